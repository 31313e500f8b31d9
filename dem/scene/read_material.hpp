#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dem/material/material_damping.hpp"
#include "dem/scene/scene_text.hpp"
#include "dem/scene/units.hpp"

// Materials as data/materials has them: every value with where it is from. data/materials/README.md.
namespace fiberchain::dem {

/// One value of a material, in SI units.
struct MaterialValue {
  double value = 0;
  std::optional<std::array<double, 2>> range;  ///< that holds it
  std::optional<double> temperature;           ///< [K]
  std::optional<FrequencyBand> band;           ///< of a loss factor
  std::string source;                          ///< a key of data/materials/sources.yaml
  std::string note;
  bool total = false;  ///< of a loss factor: a thermoelastic part may be in it
  bool along = false;  ///< of a conductivity: along the fiber, not across
};

/// A material file as a value; what it does not say is left out.
struct MaterialData {
  std::string name, description;
  double temperature = 0;  ///< of the set [K]
  std::optional<MaterialValue> youngs_modulus, poisson_ratio, shear_modulus, transverse_modulus, density,
      loss_factor, shear_loss_factor, thermal_expansion, heat_capacity, conductivity;
  SceneText file = {};  ///< as read
};

/// Thermal data that thermoelastic damping needs, at the temperature of the set: nothing where one is missing
/// or the conductivity is that along the fiber.
std::optional<ThermalProperties> thermal_properties(const MaterialData& material);

/// All that damps a material: loss factors with their band, thermoelasticity; of a material whose loss factor
/// is a total that may have a thermoelastic part in it, thermoelasticity alone.
MaterialDamping damping_of(const MaterialData& material);

/// A material's file as data/materials has them. `units`: shared with another reader; read anew if null.
/// @throws SceneError naming file, line, key, value and what is allowed; unknown keys are errors
MaterialData parse_material(const SceneText& file, std::shared_ptr<const Units> units = nullptr);

/// A material by its name in data/materials, or by the path of a .yaml file, which is looked for beside
/// `beside`, a scene's file.
/// @throws SceneError as parse_material(); for an unknown name with the nearest one, or all
MaterialData find_material(const std::string& name, const std::filesystem::path& beside = {},
                           std::shared_ptr<const Units> units = nullptr);

/// The names in data/materials, in alphabetical order.
/// @throws SceneError where there is no such directory
std::vector<std::string> material_names();

}  // namespace fiberchain::dem
