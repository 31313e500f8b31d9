#pragma once

#include <optional>
#include <string>

#include "dem/scene/key_table.hpp"
#include "dem/scene/read_material.hpp"

// Key material_damping of a fiber. All readers throw SceneError.
namespace fiberchain::dem {

/// Mapping "thermoelastic" as typed; what is left out is the material's.
struct ThermoelasticKeys {
  std::optional<double> expansion;          ///< [1/K]
  std::optional<double> temperature;        ///< [K]
  std::optional<double> heat_capacity;      ///< [J/(kg K)]
  std::optional<double> conductivity;       ///< [W/(m K)]
  std::optional<double> highest_frequency;  ///< [Hz]
};

/// Mapping "material_damping" as typed.
struct MaterialDampingKeys {
  bool from_material = false;
  std::optional<double> loss_factor = {}, shear_loss_factor = {};
  std::optional<FrequencyBand> band = {};
  std::optional<int> branches = {};
  std::optional<double> modulus_frequency = {};  ///< [Hz]
  std::optional<ThermoelasticKeys> thermoelastic = {};
  MaterialRelaxation spectrum = {};
};

KeyTable<MaterialDampingKeys> material_damping_keys();

/// The damping that the keys mean, of a material where one is named.
/// @throws SceneError at key material_damping of the fiber's mapping
MaterialDamping damping_of(const StrictMapping& fiber, const MaterialDampingKeys& keys,
                           const std::optional<MaterialData>& material);

}  // namespace fiberchain::dem
