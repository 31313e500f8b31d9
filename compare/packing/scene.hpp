#pragma once

#include <cstdint>
#include <string>

#include "dem/material/frequency_band.hpp"
#include "dem/scene/packing_scene.hpp"

// The packings of Figs 11 and 12. The paper names the number of fibers, their aspect ratio, restitution and
// friction; the rest is ours, as in data/scenes/packing.yaml.
namespace fiberchain::compare {

inline constexpr double kPackingDuration = 0.6;  ///< of the fall and the coming to rest [s]

/// In which a loss factor is flat: the first bending frequency of these fibers, free, is 69 Hz.
inline constexpr dem::FrequencyBand kPackingBand{10, 1e4};

/// A packing to run.
struct PackingCase {
  double bond_damping = 1;      ///< xi_b
  double rolling_friction = 0;  ///< xi_r
  double stiffness = 1;         ///< factor to Young's modulus of fibers and walls
  double contact_modulus = 1;   ///< Young's modulus of the fibers in contacts over that of their bonds
  int fibers = 2000;
  double side = 0.1;       ///< of the square floor [m]; with it and the number goes the depth
  std::uint64_t seed = 1;  ///< of the filling
  double step_ratio = 1;   ///< time step over the usual: 0.8 of the bonds' limit, 0.45 of the contacts'
  dem::Integrator integrator = dem::Integrator::leapfrog;
  double duration = kPackingDuration;  ///< [s]
  bool periodic = false;               ///< sides, in place of walls
  bool accounted = false;              ///< energy by mechanism
  bool pictured = false;               ///< places are kept for pictures
  double loss_factor = 0;              ///< tan delta of the fibers' material, flat over kPackingBand
};

/// The scene. Throws InputError for fewer than one fiber.
dem::PackingScene packing_scene(const PackingCase& asked);

/// Area of the floor [m^2].
double floor_area(const dem::PackingScene& scene);

}  // namespace fiberchain::compare
