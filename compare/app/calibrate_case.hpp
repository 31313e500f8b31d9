#pragma once

#include <optional>

#include "compare/app/quantities.hpp"
#include "compare/calibration/calibration.hpp"
#include "dem/scene/read_material.hpp"

// The fiber that `calibrate` is asked of. Throws InputError, dem::SceneError for materials.
namespace fiberchain::app {

/// The options that say what a fiber's damping is or shall be; --loss-factor is one where no --band is.
std::vector<std::string> calibration_targets(const Arguments& arguments);

/// The one target typed. @throws InputError where there is none, or more than one
std::string known_target(const Arguments& arguments);

struct CalibratedFiber {
  dem::Fiber fiber;  ///< without its dashpots' setting
  bool dimensional;  ///< size and material are a real fiber's
  std::optional<dem::MaterialData> material;
};
CalibratedFiber calibrated_fiber(const Arguments& arguments, const Quantities& typed);

/// The fiber that `identify` is asked of: its Young's modulus is the nominal one's.
dem::Fiber identified_fiber(const Arguments& arguments, const Quantities& typed);

/// The answer to --material, or to --loss-factor with --band: by the material's own damping.
int run_calibrate_material(const Arguments& arguments, Context& context);

}  // namespace fiberchain::app
