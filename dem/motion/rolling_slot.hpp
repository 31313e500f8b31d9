#pragma once

#include "dem/math/near_one.hpp"
#include "dem/math/small_matrix.hpp"
#include "dem/simd/as_numbers.hpp"

// Rolling friction of a bond: its slot in the workspace, kept from step to step, and its explicit form.
namespace fiberchain::dem {

/// Of one bond.
template <class Real, int Dim>
struct RollingSlot {
  Real limit;               ///< r [1/s]
  Spin<Real, Dim> impulse;  ///< l [1/s], kept from step to step as the first guess
  Spin<Real, Dim> free;     ///< w_free [1/s]
  Spin<Real, Dim> forward;
  Square<Real, spin_size<Dim>> coupling;
};

/// Moment of the sliding friction on the first sphere by the sign of the lagged spin, the paper's way.
template <class Real, int S>
Vec<Real, S> sliding_moment(const Real& largest, const Vec<Real, S>& spin) {
  const Real size = norm(spin);
  return (select(size > Real(0.0), largest / size, Real(0.0))) * spin;
}

template <class Chain>
auto* rolling_slots(const Chain& chain) {
  return as_values<RollingSlot<typename Chain::Number, Chain::Dim>>(chain.workspace);
}

}  // namespace fiberchain::dem
