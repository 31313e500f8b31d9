#pragma once

#include "dem/contact/lanes/search.hpp"
#include "dem/contact/lanes/walls.hpp"

// Included by one source file an instruction set, as motion/lanes/instantiate.hpp.
namespace fiberchain::dem {

template <class Real>
struct ContactTable {
  ContactKernel kernels[contact_combinations];
};

template <class Real, int... N>
constexpr ContactTable<Real> contact_table(std::integer_sequence<int, N...>) {
  return {{{lane_count<Real>, near_pairs<contact_physics(N), Real>, contact_pairs<contact_physics(N), Real>, contact_wall<contact_physics(N), Real>,
            spheres_near<contact_physics(N).periodic, Real>}...}};
}

template <class Real>
inline constexpr ContactTable<Real> contacts_of = contact_table<Real>(std::make_integer_sequence<int, contact_combinations>{});

}  // namespace fiberchain::dem
