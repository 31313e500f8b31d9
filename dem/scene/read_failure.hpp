#pragma once

#include <cstdint>
#include <optional>

#include "dem/model/fiber.hpp"
#include "dem/scene/key_table.hpp"

// Keys of bonds that break or yield. All readers throw SceneError.
namespace fiberchain::dem {

struct BondKeys;

/// Mapping "weibull" of a strength as typed.
struct WeibullKeys {
  double modulus = 0;
  std::optional<double> reference_length;  ///< [m]
  std::uint64_t seed = 1;
};

/// Mapping "strength" of bonds as typed.
struct StrengthKeys {
  std::optional<double> tension, compression, shear, torsion;  ///< [Pa]
  std::optional<WeibullKeys> weibull;
};

/// Mapping "yield" of bonds as typed.
struct YieldKeys {
  std::optional<double> moment;  ///< [N m], or
  std::optional<double> stress;  ///< [Pa]
  double hardening = 0;
};

/// Declares keys strength and yield.
void declare_failure(KeyTable<BondKeys>& table);
/// Gives the fiber what its bonds bear.
void apply_failure(const BondKeys& keys, Fiber& fiber);
/// Refuses what is not built together with bonds that break or yield.
void check_failure(const StrictMapping& top, const Fiber& fiber);

}  // namespace fiberchain::dem
