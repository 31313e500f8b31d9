#include "compare/material/material_values.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "compare/study/errors.hpp"
#include "dem/scene/units.hpp"

namespace fiberchain::compare {
namespace {

class MaterialFile {
 public:
  MaterialFile(const std::filesystem::path& data_directory, const std::string& name)
      : path_(data_directory / "materials" / (name + ".yaml")) {
    try {
      root_ = YAML::LoadFile(path_.string());
    } catch (const YAML::Exception& error) {
      throw InputError(fmt::format("{}: {}", path_.string(), error.what()));
    }
  }

  double value(const char* key, const char* unit) const { return quantity(key, "value", -1, unit); }
  double of_list(const char* key, const char* part, int place, const char* unit) const {
    return quantity(key, part, place, unit);
  }

 private:
  double quantity(const char* key, const char* part, int place, const char* unit) const {
    try {
      const YAML::Node values = root_[key][part];
      const YAML::Node one = place < 0 ? values : values[place];
      return units_.to_si(one.as<std::string>(), unit);
    } catch (const YAML::Exception&) {
      throw InputError(fmt::format("{}: {}.{} is missing", path_.string(), key, part));
    }
  }

  std::filesystem::path path_;
  YAML::Node root_;
  dem::Units units_;
};

LossRange loss_range(const MaterialFile& file, const char* key) {
  return {file.value(key, "1"), file.of_list(key, "range", 0, "1"), file.of_list(key, "range", 1, "1")};
}

}  // namespace

MetalValues metal_values(const std::filesystem::path& data_directory, const std::string& name) {
  const MaterialFile file(data_directory, name);
  return {name,
          file.value("youngs_modulus", "Pa"),
          file.value("poisson_ratio", "1"),
          file.value("density", "kg/m^3"),
          {.expansion = file.value("thermal_expansion", "1/K"),
           .temperature = file.value("temperature", "K"),
           .heat_capacity = file.value("heat_capacity", "J/(kg K)"),
           .conductivity = file.value("conductivity", "W/(m K)")}};
}

PlantLoss plant_loss(const std::filesystem::path& data_directory, const std::string& name) {
  const MaterialFile file(data_directory, name);
  return {.bending = loss_range(file, "loss_factor"),
          .twist = loss_range(file, "shear_loss_factor"),
          .youngs_modulus = file.value("youngs_modulus", "Pa"),
          .shear_modulus = file.value("shear_modulus", "Pa"),
          .density = file.value("density", "kg/m^3"),
          .band_low = file.of_list("loss_factor", "band", 0, "Hz"),
          .band_high = file.of_list("loss_factor", "band", 1, "Hz")};
}

}  // namespace fiberchain::compare
