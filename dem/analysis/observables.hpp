#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dem/assembly/assembly.hpp"
#include "dem/chain/bending.hpp"
#include "dem/insertion/insertion_grid.hpp"

// What a packing of fibers is like at one moment: numbers from the states of its fibers and its contacts.
namespace fiberchain::dem {

using FiberStates = std::span<const ChainState<3>>;

// --- bending

/// Sum over bonds and how many, to average over several groups.
struct Mean {
  double sum = 0;
  std::int64_t count = 0;

  double value() const { return count > 0 ? sum / static_cast<double>(count) : 0; }
};

/// bending_angle over all bonds: the paper's mean bending angle per bond (Fig 12).
Mean bending_angles(const Chain<3>& chain, FiberStates fibers);

/// turning_angle over all inner spheres.
Mean turning_angles(FiberStates fibers);

// --- height and density

/// Along the unit vector `up`, of sphere centers [m].
struct Heights {
  double highest;
  double
      quantile;  ///< below which the asked fraction of centers lies, interpolated between neighbors in order
  double mean;
};

/// The value below which this fraction of them lies, linear between two; they are put in another order.
/// Throws InvalidInput for no values and a fraction outside of 0 to 1.
double quantile(std::vector<double>& values, double fraction);

/// Throws InvalidInput when there are no spheres or the fraction is not within [0, 1].
Heights heights(const PlacedSpheres& spheres, const Vec<double, 3>& up, double fraction = 0.95);

/// Volume [m^3] of the part of a sphere below the height h over its center.
double volume_below(double radius, double h);

/// Solid fraction of the slabs between `edges` (heights along `up`, rising) of a room of constant cross
/// section [m^2]: the exact volumes of the spheres in each slab, overlaps counted twice as in the mass.
/// Throws InvalidInput unless the edges rise and the cross section is positive.
std::vector<double> solid_fractions(const PlacedSpheres& spheres, const Vec<double, 3>& up,
                                    double cross_section, const std::vector<double>& edges);

// --- contacts

/// Contacts by what they join, and means.
struct Coordination {
  std::int64_t between_fibers = 0, within_fibers = 0, with_walls = 0;
  double per_sphere = 0;           ///< contacts of a sphere with spheres: 2 (between + within) / spheres
  double per_fiber = 0;            ///< contacts of a fiber with other fibers: 2 between / fibers
  double neighbors_per_fiber = 0;  ///< different fibers that a fiber touches
  double touching_spheres = 0;     ///< fraction of spheres that touch any sphere
};

/// `fiber_of` is the fiber of each sphere. A contact whose force is zero (it is opening) counts as the
/// others. Throws InvalidInput for a contact of a sphere that is not there.
Coordination coordination(std::span<const ContactState> contacts, std::span<const std::int32_t> fiber_of);

/// Number of the fiber of each sphere, through the groups in order.
std::vector<std::int32_t> fiber_numbers(const std::vector<FiberGroup>& groups);

// --- orientation

/// Directions of bonds, each as good as its opposite.
class Orientations {
 public:
  /// Polar angles are taken from `up`, a unit vector, in so many classes of equal width from 0 to pi/2.
  explicit Orientations(const Vec<double, 3>& up, int classes = 18);

  void add(FiberStates fibers);  ///< all bonds

  std::int64_t bonds() const { return bonds_; }
  /// <u u>: trace 1, a third of the unit tensor when isotropic.
  std::array<std::array<double, 3>, 3> second_moment() const;
  /// Eigenvalues of the second moment, falling.
  std::array<double, 3> principal() const;
  double order() const;             ///< (3 lambda_1 - 1) / 2: 0 isotropic, 1 all parallel
  double order_along_up() const;    ///< (3 <cos^2> - 1) / 2: -1/2 all across, 1 all along `up`
  double mean_polar_angle() const;  ///< 0 to pi/2; 1 rad when isotropic
  /// Share of the bonds in a class over what it would be if isotropic, cos(low) - cos(high).
  std::vector<double> against_isotropic() const;

 private:
  Vec<double, 3> up_;
  std::int64_t bonds_ = 0;
  double angles_ = 0;
  std::array<double, 6> moments_{};  ///< sums of xx, yy, zz, xy, xz, yz
  std::vector<std::int64_t> classes_;
};

// --- motion

struct KineticEnergy {
  double translation = 0, rotation = 0;  ///< [J]
};

KineticEnergy kinetic_energy(const Fiber& fiber, FiberStates fibers);

}  // namespace fiberchain::dem
