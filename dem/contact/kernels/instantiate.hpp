#pragma once

#include <utility>

#include "dem/contact/kernels/neighbor_query.hpp"
#include "dem/contact/kernels/walls.hpp"
#include "dem/math/type_list.hpp"
#include "dem/model/shapes/shapes.hpp"

// Included by one source file an instruction set and list of laws, as dem/motion/kernels/instantiate.hpp.
namespace fiberchain::dem {

/// The loop that serves these physics: of laws that adhere those for several sizes serve one size, too, which
/// halves what has to be compiled of them.
template <class Law>
constexpr ContactPhysics built_physics(ContactPhysics p) {
  if constexpr (Adheres<Law>) p.uniform = false;
  return p;
}

template <class Real, class Law, ContactPhysics asked, class Shapes>
constexpr ContactKernel contact_kernel_of() {
  constexpr ContactPhysics P = built_physics<Law>(asked);
  return {lane_count<Real>, prune_pairs<P, Real>, contact_pairs<Law, P, Real>,
          contact_wall<Law, P, NearestOfShapes<Real, Shapes>, Real>, query_neighbors<P.periodic, Real>};
}

template <int count>
struct ContactTable {
  ContactKernel kernels[count * contact_combinations];
};

template <class Real, class Shapes, class... Laws>
constexpr auto contact_table(TypeList<Laws...>) {
  ContactTable<sizeof...(Laws)> table{};
  ContactKernel* next = table.kernels;
  const auto add = [&]<class Law, int... N>(const Law*, std::integer_sequence<int, N...>) {
    ((*next++ = contact_kernel_of<Real, Law, contact_physics(N), Shapes>()), ...);
  };
  (add(static_cast<const Laws*>(nullptr), std::make_integer_sequence<int, contact_combinations>{}), ...);
  return table;
}

template <class Real, class Laws, class Shapes>
inline constexpr auto contacts_of = contact_table<Real, Shapes>(Laws{});

}  // namespace fiberchain::dem
