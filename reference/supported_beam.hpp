#pragma once

#include <vector>

namespace fiberchain::reference {

/// A straight beam on two supports that loads at equal spacing press down: a fiber's spheres and their
/// weights. The supports stand under two of the load points; the ends may hang over.
struct SupportedBeam {
  int points;       ///< loads, spaced evenly from one end to the other
  double spacing;   ///< l [m]
  double load;      ///< W at every point [N]
  double bending;   ///< E I [N m^2]
  double shear;     ///< G A [N], may be infinite
  int left, right;  ///< points that are supported, 0 <= left < right < points
};

struct BeamOnSupports {
  double left, right;              ///< forces of the supports [N]
  std::vector<double> deflection;  ///< at the points, down is positive, 0 at the supports [m]
};

/// Timoshenko's beam, small deflections, closed form by Macaulay's brackets:
/// E I w'''' = loads - supports and G A w_s'' = supports - loads. Throws InvalidArgument.
BeamOnSupports beam_on_supports(const SupportedBeam& beam);

}  // namespace fiberchain::reference
