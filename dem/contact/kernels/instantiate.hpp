#pragma once

#include "dem/contact/kernels/neighbor_query.hpp"
#include "dem/contact/kernels/walls.hpp"

// Included by one source file an instruction set, as dem/motion/kernels/instantiate.hpp.
namespace fiberchain::dem {

template <class Real>
struct ContactTable {
  ContactKernel kernels[contact_combinations];
};

template <class Real, int... N>
constexpr ContactTable<Real> contact_table(std::integer_sequence<int, N...>) {
  return {{{lane_count<Real>, prune_pairs<contact_physics(N), Real>, contact_pairs<contact_physics(N), Real>, contact_wall<contact_physics(N), Real>,
            query_neighbors<contact_physics(N).periodic, Real>}...}};
}

template <class Real>
inline constexpr ContactTable<Real> contacts_of = contact_table<Real>(std::make_integer_sequence<int, contact_combinations>{});

}  // namespace fiberchain::dem
