#pragma once

#include "dem/bond/dashpot.hpp"

// State of one bond as its law sees it: poses of the two ends, their line and their relative motion.
namespace fiberchain::dem {

/// A bond's vector with its length, for one square root a step.
template <class Real, int Dim>
struct BondVector {
  Vec<Real, Dim> vector;  ///< from sphere 1 to sphere 2 [m]
  Real length_squared;
  Real inverse_length;
};

/// `scale` is 1 / l_0: bonds keep their length within a few percent.
template <class Real, int Dim>
BondVector<Real, Dim> bond_vector(const Vec<Real, Dim>& vector, const Real& scale) {
  const Real squared = dot(vector, vector);
  return {vector, squared, scale * inverse_sqrt_near_one(squared * (scale * scale))};
}

/// What a bond law may depend on besides its parameters and its history. Poses are those of the bond's ends:
/// of its spheres, turned to where the bond is straight. Nothing is copied (a copy of packs goes through
/// memory); all of it must live as long.
template <class Real, int Dim>
struct BondConfiguration {
  const Pose<Real, Dim>& first;
  const Pose<Real, Dim>& second;
  const BondVector<Real, Dim>& line;        ///< between the centers
  const RelativeMotion<Real, Dim>& motion;  ///< half a step before the poses in the leapfrog
};

template <class Real, int Dim>
BondLoads<Real, Dim> dashpot_loads(const BondParameters<Real>& bond,
                                   const BondConfiguration<Real, Dim>& now) {
  const BondVector<Real, Dim>& line = now.line;
  return act_at_middle(line.vector,
                       dashpot_action(bond, line.vector, line.inverse_length * line.vector, now.motion));
}

}  // namespace fiberchain::dem
