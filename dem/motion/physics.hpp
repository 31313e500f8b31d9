#pragma once

#include <array>
#include <string_view>

namespace fiberchain::dem {

/// How the strain of a bond is known.
enum class BondForm {
  total,       ///< from the poses of its spheres: forces are derivatives of an energy, no history
  incremental  ///< summed over the steps, as the paper does
};

constexpr std::string_view name(BondForm form) { return form == BondForm::total ? "total" : "incremental"; }

/// Rolling friction of the bonds (Eq 21).
enum class Rolling {
  none,
  set_valued,    ///< solved within the step: sticks at zero relative spin
  explicit_sign  ///< by the sign of the lagged relative spin, the paper's way; chatters
};

constexpr std::string_view name(Rolling rolling) {
  switch (rolling) {
    case Rolling::set_valued: return "set_valued";
    case Rolling::explicit_sign: return "explicit_sign";
    default: return "none";
  }
}

/// What a scene has. A template argument of the inner loop: what a scene lacks is not compiled into it.
struct Physics {
  int dimension;  ///< 2: position and angle; 3: position and unit quaternion
  BondForm form;
  bool damped;    ///< dashpots in the bonds, their force taken at the lagged velocity unless `solved`
  bool settling_damping;      ///< force on every sphere against its velocity, to settle a chain
  bool curved;    ///< bonds that are not straight at rest (total form; the incremental one needs no rest shape)
  bool solved = false;  ///< dashpots centered in the step and solved for: stable up to the undamped limit
  Rolling rolling = Rolling::none;
  bool fluid = false;  ///< Stokes' settling_damping of a flow on every sphere, solved within the step

  constexpr bool operator==(const Physics&) const = default;
};

/// Every combination that is built, for every lane width, and no other.
inline constexpr auto built_physics = [] {
  std::array<Physics, 44> list{};
  int n = 0;
  for (const int dimension : {2, 3}) {
    for (const bool damped : {false, true}) {
      for (const bool settling_damping : {false, true}) {
        list[n++] = {dimension, BondForm::incremental, damped, settling_damping, false};
        list[n++] = {dimension, BondForm::total, damped, settling_damping, false};
        list[n++] = {dimension, BondForm::total, damped, settling_damping, true};
      }
    }
    list[n++] = {dimension, BondForm::incremental, true, false, false, true};
    list[n++] = {dimension, BondForm::total, true, false, false, true};
    list[n++] = {dimension, BondForm::incremental, true, false, false, false, Rolling::set_valued};
    list[n++] = {dimension, BondForm::incremental, true, false, false, false, Rolling::explicit_sign};
    for (const bool damped : {false, true}) {
      list[n++] = {dimension, BondForm::incremental, damped, false, false, false, Rolling::none, true};
      list[n++] = {dimension, BondForm::total, damped, false, false, false, Rolling::none, true};
      list[n++] = {dimension, BondForm::total, damped, false, true, false, Rolling::none, true};
    }
  }
  return list;
}();

/// What is also built for one chain along the lanes: no settling_damping, straight at rest, nothing to solve along the chain.
constexpr bool built_for_single_chain(const Physics& p) {
  return !p.settling_damping && !p.curved && !p.solved && p.rolling != Rolling::set_valued;
}

}  // namespace fiberchain::dem
