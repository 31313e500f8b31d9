#pragma once

#include <cstdint>

// Rods of uniform curvature, of strengths by Weibull's law, whose both ends are let go at once: into how many
// pieces they break. The rod is of one material and length in its own units, whatever the bonds it is cut
// into: curvature and strength by its length, damping (Kelvin & Voigt's) by the time of its waves.
namespace fiberchain::compare {

struct FragmentCase {
  int aspect_ratio = 60;
  int rods = 400;
  std::uint64_t seed = 1;
  double modulus = 8;     ///< Weibull's m [-]
  double strength = 1.5;  ///< of a whole rod, in bending, over the stress before the release; bears 1/e
  double damping_way =
      0.1;  ///< of its length that the largest curvature of a beam goes in the retardation time
};

/// Over the rods.
struct Fragments {
  double mean = 0;       ///< pieces
  double deviation = 0;  ///< standard one of the mean
  double unbroken = 0;   ///< part of the rods
  double longest = 0;    ///< mean length of the longest piece, of the rod's
};

/// Until the wave of a beam has gone the rod's length three times over.
Fragments break_rods(const FragmentCase& asked);

}  // namespace fiberchain::compare
