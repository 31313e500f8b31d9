#include "compare/material/material_values.hpp"

#include <fmt/format.h>

#include "compare/study/errors.hpp"
#include "dem/scene/read_material.hpp"

namespace fiberchain::compare {
namespace {

/// A part of a material's data that has to be there.
template <class Part>
const Part& known(const std::optional<Part>& part, const std::string& material, const char* key) {
  if (!part) throw InputError(fmt::format("material '{}' has no {}", material, key));
  return *part;
}

LossRange loss_range(const std::optional<dem::MaterialValue>& loss, const std::string& name,
                     const char* key) {
  const dem::MaterialValue& value = known(loss, name, key);
  const auto [low, high] = known(value.range, name, "range of the loss factor");
  return {value.value, low, high};
}

}  // namespace

MetalValues metal_values(const std::string& name) {
  const dem::MaterialData material = dem::find_material(name);
  return {name, known(material.youngs_modulus, name, "youngs_modulus").value,
          known(material.poisson_ratio, name, "poisson_ratio").value,
          known(material.density, name, "density").value,
          known(dem::thermal_properties(material), name, "thermal data across the fiber")};
}

PlantLoss plant_loss(const std::string& name) {
  const dem::MaterialData material = dem::find_material(name);
  const dem::FrequencyBand band = known(known(material.loss_factor, name, "loss_factor").band, name, "band");
  return {.bending = loss_range(material.loss_factor, name, "loss_factor"),
          .twist = loss_range(material.shear_loss_factor, name, "shear_loss_factor"),
          .youngs_modulus = known(material.youngs_modulus, name, "youngs_modulus").value,
          .shear_modulus = known(material.shear_modulus, name, "shear_modulus").value,
          .density = known(material.density, name, "density").value,
          .band_low = band.low,
          .band_high = band.high};
}

}  // namespace fiberchain::compare
