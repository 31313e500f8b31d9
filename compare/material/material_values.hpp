#pragma once

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

/// Throws dem::SceneError for a file that is wrong or not there, InputError where a value is missing.
MetalValues metal_values(const std::string& name);

/// The loss factors that a material has for bending and for twist, each with its range.
struct LossRange {
  double value, low, high;
};
struct PlantLoss {
  LossRange bending, twist;
  double youngs_modulus, shear_modulus;  ///< [Pa]
  double density;                        ///< [kg/m^3]
  double band_low, band_high;            ///< of both [Hz]
};
/// As metal_values().
PlantLoss plant_loss(const std::string& name);

}  // namespace fiberchain::compare
