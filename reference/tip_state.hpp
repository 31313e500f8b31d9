#pragma once

#include <vector>

namespace fiberchain::reference {

/// Where the free end of a cantilever of length L is. The unloaded beam lies along +x from the clamp, the
/// dead load acts along +y.
struct TipState {
  double y;      ///< deflection along the load, y / L
  double x;      ///< shortening toward the clamp, 1 - x_position / L
  double angle;  ///< rotation of the end section [rad]
};

/// A deformed beam, at stations from the clamp (first entry) to the free end (last entry).
struct BeamShape {
  std::vector<double> s;      ///< arc length of the undeformed beam, s / L
  std::vector<double> x;      ///< position along the undeformed axis, x / L
  std::vector<double> y;      ///< position along the load, y / L
  std::vector<double> theta;  ///< rotation of the section [rad]
};

}  // namespace fiberchain::reference
