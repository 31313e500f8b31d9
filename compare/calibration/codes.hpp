#pragma once

#include <string>
#include <vector>

#include "compare/calibration/calibration.hpp"

// What to type into other codes for a fiber with dashpots.
namespace fiberchain::compare {

struct CodeLine {
  std::string code;  ///< "LAMMPS", "LIGGGHTS"
  std::string line;  ///< of its input; comments begin with #
};

/// Lines for LAMMPS, bond_style bpm/rotational, as its source has the forces: gnorm and gslide are the
/// dashpots of stretch and shear; rolling has a torque 0.5 groll r w, r = 2R the bond's length, and twist 0.5
/// gtwist w, so that groll = c_bend / R and gtwist = 2 c_twist. `time_step` [s].
std::vector<CodeLine> lammps_lines(const dem::Fiber& fiber, double time_step);

/// Lines for LIGGGHTS with flexible fibers (github.com/schrummy14/LIGGGHTS_Flexible_Fibers), whose bond_style
/// gran has stiffnesses E A / l, G A / l, G I_p / l, E I / l, which are the paper's bond's, and dashpots
/// 2 damp sqrt(m/2 K), which are its xi_b. A comment in place of what its bond cannot have.
std::vector<CodeLine> liggghts_lines(const dem::Fiber& fiber, double time_step);

}  // namespace fiberchain::compare
