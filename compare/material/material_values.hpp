#pragma once

#include <filesystem>
#include <string>

#include "dem/material/thermoelastic.hpp"

namespace fiberchain::compare {

/// What data/materials says of a metal.
struct MetalValues {
  std::string name;
  double youngs_modulus;  ///< isothermal [Pa]
  double poisson_ratio;
  double density;  ///< [kg/m^3]
  dem::ThermalProperties thermal;
};

/// Of DATA/materials/NAME.yaml. Throws InputError where the file or a value is missing.
MetalValues metal_values(const std::filesystem::path& data_directory, const std::string& name);

/// The loss factors that DATA/materials/NAME.yaml has for bending and for twist, each with its range.
struct LossRange {
  double value, low, high;
};
struct PlantLoss {
  LossRange bending, twist;
  double youngs_modulus, shear_modulus;  ///< [Pa]
  double density;                        ///< [kg/m^3]
  double band_low, band_high;            ///< of both [Hz]
};
PlantLoss plant_loss(const std::filesystem::path& data_directory, const std::string& name);

}  // namespace fiberchain::compare
