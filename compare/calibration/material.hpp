#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/calibration/calibration.hpp"
#include "dem/material/material_damping.hpp"

// A fiber of a material: what its own damping does to its modes, and what to set for it.
namespace fiberchain::compare {

/// A fiber with the moduli as given, and how its material damps.
struct MaterialCase {
  dem::Fiber fiber;
  dem::MaterialDamping damping;
  bool band_of_modes = false;  ///< nobody says a band: from a third of mode 1 to three times mode 5
};

/// One bending mode of the clamped fiber in free decay.
struct MaterialMode {
  int number = 1;
  double frequency = 0;               ///< |s|/(2 pi) of the chain [Hz]
  double damping = 0;                 ///< zeta of the chain
  double beam_damping = 0;            ///< of the uniform beam of the fiber's own mass, thermoelasticity exact
  std::optional<double> ripple = {};  ///< what the flat loss factor's ripple may do to zeta, of itself
  double flat_part = 0;           ///< half of tan delta at that frequency of loss factor and given branches
  double thermoelastic_part = 0;  ///< and of thermoelasticity
};

/// Largest number of modes that are looked at.
inline constexpr int material_modes = 5;

struct MaterialAnswer {
  MaterialCase asked;  ///< with the band that was taken
  dem::DampedFiber damped;
  std::vector<MaterialMode> modes;  ///< at most 5 and as many as there are bonds; none without damping
  double step = 0;                  ///< recommended, of the fiber with branches [s]
  /// Dashpots alone that meet zeta of mode 1, on the moduli as given; nothing where there are none.
  std::optional<Calibration> dashpots = std::nullopt;
  std::vector<double> dashpot_damping = {};  ///< zeta of the modes with these
  std::string no_dashpots = {};              ///< why there are none
};

/// Throws InputError for more than 300 bonds, dem::InvalidInput for damping that makes no sense.
MaterialAnswer answer_material(MaterialCase asked);

}  // namespace fiberchain::compare
