#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/material/bending_loop.hpp"
#include "compare/material/damped_fibers.hpp"
#include "compare/material/mode_decay.hpp"
#include "compare/study/jobs.hpp"

// What the study of materials measures.
namespace fiberchain::compare {

/// A bending mode of one of the three fibers.
struct ModePoint {
  Damper damper;
  int mode;                   ///< from 1
  reference::FreeDecay root;  ///< of the linear chain with complex moduli
  MarchedDecay marched;
  std::optional<double> series;  ///< zeta with the exact thermoelastic modulus
};

/// The lowest bending modes of each of the fibers, in time and by their roots.
std::vector<ModePoint> mode_points(const ThreeFibers& fibers, int modes, const Jobs& jobs);

/// Free end of a fiber struck in modes 1 and 2, as high in both at first.
struct TwoModes {
  Damper damper;
  TipHistory history;
  double period;      ///< of mode 1 [s]
  double root;        ///< zeta of mode 2 by its complex root
  double in_company;  ///< zeta of mode 2 from this motion
  double left;        ///< amplitude of mode 2 after three periods of mode 1, over that at the start
};

/// Of the fibers with the same damping ratio of mode 1, viscous and flat.
std::vector<TwoModes> two_modes(const ThreeFibers& fibers, double periods);

/// A cycle of bending of one bond.
struct CyclePoint {
  Damper damper;
  BendingLoop loop;
  double formula;  ///< K''/K'
};

/// Of each of the fibers at these frequencies [Hz].
std::vector<CyclePoint> cycle_points(const ThreeFibers& fibers, const std::vector<double>& frequencies);

/// A wire of a metal, clamped at one end.
struct WirePoint {
  MetalValues metal;
  double diameter;   ///< [m]
  double frequency;  ///< first bending frequency [Hz]
  double peak;       ///< of thermoelastic damping [Hz]
  int branches;
  double root;                    ///< zeta of mode 1 of the chain with branches
  double series;                  ///< zeta with the exact thermoelastic modulus
  std::optional<double> marched;  ///< zeta in time
};

struct WireSweep {
  std::vector<std::string> metals{"aluminium", "copper",   "carbon-steel",
                                  "tungsten",  "titanium", "stainless-steel-316"};
  int aspect_ratio = 20;
  std::vector<double> diameters;  ///< [m]
  int marched_every = 8;          ///< so many diameters, from the second on; 0: none
};

std::vector<WirePoint> wire_points(const WireSweep& sweep, const Jobs& jobs);

/// So many values from the first to the last, each the same factor apart.
std::vector<double> logarithmic_values(double first, double last, int count);

}  // namespace fiberchain::compare
