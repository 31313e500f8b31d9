#pragma once

#include "dem/lammps/rank.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace fiberchain::dem::mpi {

/// Makes bond, pair and fix style `fiberchain` known to this LAMMPS, which then work on the rank's plan and
/// rows. Before its first input.
void register_styles(LAMMPS_NS::LAMMPS& lammps, Rank& rank);

/// Forgets them; before the rank or LAMMPS goes.
void forget_styles(LAMMPS_NS::LAMMPS& lammps);

}  // namespace fiberchain::dem::mpi
