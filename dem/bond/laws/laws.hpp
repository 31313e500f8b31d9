#pragma once

#include <cstddef>
#include <string_view>
#include <tuple>
#include <utility>

#include "dem/bond/laws/incremental_bond.hpp"
#include "dem/bond/laws/total_bond.hpp"

// The bond laws. A law is a type with
//   name, from_poses, rolls, dissipates       what it is called and what it needs
//   History<Real, Dim>                        numbers kept from step to step; an empty type for none
//   start, advance                            of the history, where there is one
//   loads (from_poses) or action<damped>      forces and moments; tension too where it rolls
//   stored_energy, dissipated (dissipates)    [J], dissipated over a step
//   bending_angle (not from_poses)            for output [rad]
//   largest_stiffness                         over that of the parameters [-], for the time step
// Its own parameters are Fiber::law_parameters, in the inner loops BondParameters::own.
namespace fiberchain::dem {

/// The laws that the library builds, in the order of BondForm. A further one: its header above, its type
/// here.
using BondLaws = std::tuple<TotalBond, IncrementalBond>;

/// Number of a bond law: its position in BondLaws, or a number of its own for a law from outside of the
/// library.
enum class BondForm : int { total, incremental };

inline constexpr std::size_t bond_law_count = std::tuple_size_v<BondLaws>;

/// The law of a form; specialized by laws from outside of the library.
template <BondForm form>
struct BondLawOf {
  using type = std::tuple_element_t<static_cast<std::size_t>(form), BondLaws>;
};
template <BondForm form>
using BondLawType = typename BondLawOf<form>::type;

static_assert(BondLawType<BondForm::total>::name == "total" &&
              BondLawType<BondForm::incremental>::name == "incremental");

/// visit.operator()<form>() for a form in BondLaws; the last one for a form beyond.
template <std::size_t I = 0, class Visit>
constexpr decltype(auto) with_bond_form(BondForm form, const Visit& visit) {
  constexpr BondForm own = static_cast<BondForm>(I);
  if constexpr (I + 1 < bond_law_count) {
    if (form != own) return with_bond_form<I + 1>(form, visit);
  }
  return visit.template operator()<own>();
}

constexpr bool is_in_library(BondForm form) { return static_cast<std::size_t>(form) < bond_law_count; }

constexpr std::string_view name(BondForm form) {
  if (!is_in_library(form)) return "of a law from outside of the library";
  return with_bond_form(form, []<BondForm own>() { return BondLawType<own>::name; });
}

/// Whether loads depend on the orientations of the spheres and the rest shape of the chain.
constexpr bool from_poses(BondForm form) {
  return with_bond_form(form, []<BondForm own>() { return BondLawType<own>::from_poses; });
}

template <class Law, class Real, int Dim>
using BondLawHistory = typename Law::template History<Real, Dim>;

template <class Law>
inline constexpr bool has_history = !std::is_empty_v<BondLawHistory<Law, double, 3>>;

}  // namespace fiberchain::dem
