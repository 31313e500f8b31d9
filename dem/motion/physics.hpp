#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include "dem/bond/laws/failing_bond.hpp"
#include "dem/bond/laws/laws.hpp"
#include "dem/bond/laws/viscoelastic_bond.hpp"

namespace fiberchain::dem {

/// Rolling friction of the bonds (Eq 21).
enum class Rolling {
  none,
  set_valued,    ///< solved within the step: sticks at zero relative spin
  explicit_sign  ///< by the sign of the lagged relative spin, the paper's way; chatters
};

constexpr std::string_view name(Rolling rolling) {
  switch (rolling) {
    case Rolling::set_valued:
      return "set_valued";
    case Rolling::explicit_sign:
      return "explicit_sign";
    default:
      return "none";
  }
}

/// What of the bonds is solved for along the chain within the step (implicit_kick.hpp).
enum class Solved {
  nothing,
  dashpots,  ///< centered in the step: stable up to the undamped limit
  bonds      ///< dashpots and springs: stable beyond the springs' own step
};

constexpr std::string_view name(Solved solved) {
  switch (solved) {
    case Solved::dashpots:
      return "dashpots";
    case Solved::bonds:
      return "bonds";
    default:
      return "nothing";
  }
}

/// What a scene has. A template argument of the inner loop: what a scene lacks is not compiled into it.
struct Physics {
  int dimension;  ///< 2: position and angle; 3: position and unit quaternion
  BondForm form;
  bool damped;            ///< dashpots in the bonds, their force taken at the lagged velocity unless `solved`
  bool settling_damping;  ///< force on every sphere against its velocity, to settle a chain
  bool curved;  ///< bonds that are not straight at rest (total form; the incremental one needs no rest shape)
  Solved solved = Solved::nothing;
  Rolling rolling = Rolling::none;
  bool fluid = false;     ///< Stokes' drag of a flow on every sphere, solved within the step
  bool branches = false;  ///< Maxwell branches beside the bonds' springs; built with dashpots, for some
  bool fails =
      false;  ///< bonds break or yield; built with dashpots, for fibers among others (failing_physics)

  constexpr bool operator==(const Physics&) const = default;
};

namespace physics_detail {

template <BondForm form, bool branches, bool fails>
struct BondLawFor {
  using type = BondLawType<form>;
};

template <BondForm form>
struct BondLawFor<form, true, false> {
  using type = ViscoelasticBond<BondLawType<form>>;
};

template <BondForm form>
struct BondLawFor<form, false, true> {
  using type = FailingBond<BondLawType<form>>;
};

}  // namespace physics_detail

/// The bond law of a physics.
template <Physics P>
using BondLaw = typename physics_detail::BondLawFor<P.form, P.branches, P.fails>::type;

namespace physics_detail {

/// A straight rest shape and, where it matters, a curved one.
template <BondForm form, class Emit>
constexpr void rest_shapes(Physics physics, const Emit& emit) {
  physics.form = form;
  emit(physics);
  if constexpr (BondLawType<form>::from_poses) {
    physics.curved = true;
    emit(physics);
  }
}

/// Calls emit(physics) for every combination that is built of these laws.
template <BondForm... forms, class Emit>
constexpr void each_physics(std::integer_sequence<BondForm, forms...>, const Emit& emit) {
  for (const int dimension : {2, 3}) {
    Physics plain{
        .dimension = dimension, .form = {}, .damped = false, .settling_damping = false, .curved = false};
    for (const bool damped : {false, true}) {
      for (const bool settling_damping : {false, true}) {
        plain.damped = damped, plain.settling_damping = settling_damping;
        (rest_shapes<forms>(plain, emit), ...);
      }
    }
    plain.settling_damping = false;  // and damped
    const auto with = [&](BondForm form, Solved solved, Rolling rolling) {
      Physics physics = plain;
      physics.form = form, physics.solved = solved, physics.rolling = rolling;
      emit(physics);
    };
    (with(forms, Solved::dashpots, Rolling::none), ...);
    ((BondLawType<forms>::rolls ? with(forms, Solved::nothing, Rolling::set_valued) : void()), ...);
    ((BondLawType<forms>::rolls ? with(forms, Solved::nothing, Rolling::explicit_sign) : void()), ...);
    plain.solved = Solved::bonds;
    for (const bool fluid : {false, true}) {  // the stiffness of a law from outside is not known
      plain.fluid = fluid;
      ((is_in_library(forms) ? rest_shapes<forms>(plain, emit) : void()), ...);
    }
    plain.solved = Solved::nothing;
    for (const bool damped : {false, true}) {
      plain.damped = damped, plain.fluid = true;
      (rest_shapes<forms>(plain, emit), ...);
    }
    plain.fluid = false, plain.branches = true;
    for (const Solved solved : {Solved::nothing, Solved::bonds}) {
      plain.solved = solved;
      ((is_in_library(forms) ? rest_shapes<forms>(plain, emit) : void()), ...);
    }
  }
}

template <BondForm... forms>
constexpr auto list_physics(std::integer_sequence<BondForm, forms...> laws) {
  constexpr std::size_t count = [] {
    std::size_t n = 0;
    each_physics(std::integer_sequence<BondForm, forms...>{}, [&](const Physics&) { ++n; });
    return n;
  }();
  std::array<Physics, count> list{};
  std::size_t n = 0;
  each_physics(laws, [&](const Physics& physics) { list[n++] = physics; });
  return list;
}

/// Last law first.
template <std::size_t... I>
constexpr auto library_forms(std::index_sequence<I...>) {
  return std::integer_sequence<BondForm, static_cast<BondForm>(sizeof...(I) - 1 - I)...>{};
}

}  // namespace physics_detail

/// Every combination that is built, for every lane width, and no other.
inline constexpr auto built_physics =
    physics_detail::list_physics(physics_detail::library_forms(std::make_index_sequence<bond_law_count>{}));

/// The same of one law, which may be from outside of the library.
template <BondForm form>
inline constexpr auto built_physics_of =
    physics_detail::list_physics(std::integer_sequence<BondForm, form>{});

namespace physics_detail {

/// Both forms, rest shapes and schemes, and in a fluid the explicit one.
template <class Emit>
constexpr void each_failing_physics(const Emit& emit) {
  Physics physics{
      .dimension = 3, .form = {}, .damped = true, .settling_damping = false, .curved = false, .fails = true};
  const auto forms = [&] {
    rest_shapes<BondForm::incremental>(physics, emit);
    rest_shapes<BondForm::total>(physics, emit);
  };
  forms();
  physics.fluid = true;
  forms();
  physics.fluid = false, physics.solved = Solved::bonds;
  forms();
}

}  // namespace physics_detail

/// Every combination that is built of bonds that break or yield, by kernels of their own.
inline constexpr auto failing_physics = [] {
  constexpr std::size_t count = [] {
    std::size_t n = 0;
    physics_detail::each_failing_physics([&](const Physics&) { ++n; });
    return n;
  }();
  std::array<Physics, count> list{};
  std::size_t n = 0;
  physics_detail::each_failing_physics([&](const Physics& physics) { list[n++] = physics; });
  return list;
}();

/// What is also built for one chain along the lanes: no settling_damping, straight at rest, no Maxwell
/// branches, nothing to solve along the chain.
constexpr bool built_for_single_chain(const Physics& p) {
  return !p.settling_damping && !p.curved && !p.branches && !p.fails && p.solved == Solved::nothing &&
         p.rolling != Rolling::set_valued;
}

}  // namespace fiberchain::dem
