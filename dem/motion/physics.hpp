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

/// What a scene has. A template argument of the inner loop: what a scene lacks is not compiled into it.
struct Physics {
  int dimension;  ///< 2: position and angle; 3: position and unit quaternion
  BondForm form;
  bool damped;    ///< dashpots in the bonds, their force taken at the lagged velocity
  bool drag;      ///< force on every sphere against its velocity, to settle a chain
  bool curved;    ///< bonds that are not straight at rest (total form; the incremental one needs no rest shape)

  constexpr bool operator==(const Physics&) const = default;
};

/// Every combination that is built, for every lane width, and no other.
inline constexpr auto built_physics = [] {
  std::array<Physics, 24> list{};
  int n = 0;
  for (const int dimension : {2, 3}) {
    for (const bool damped : {false, true}) {
      for (const bool drag : {false, true}) {
        list[n++] = {dimension, BondForm::incremental, damped, drag, false};
        list[n++] = {dimension, BondForm::total, damped, drag, false};
        list[n++] = {dimension, BondForm::total, damped, drag, true};
      }
    }
  }
  return list;
}();

}  // namespace fiberchain::dem
