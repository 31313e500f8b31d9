#pragma once

#include <mpi.h>

#include <cstdint>

#include "atom.h"
#include "dem/lammps/rank.hpp"
#include "lammps.h"

namespace LAMMPS_NS {
class Bond;
class Fix;
class Pair;
}  // namespace LAMMPS_NS

// What makes each style, as LAMMPS calls it.
namespace fiberchain::dem::mpi {

/// Whose plan and rows the styles of this LAMMPS work on.
Rank& rank_of(LAMMPS_NS::LAMMPS* lammps);

LAMMPS_NS::Bond* make_bond_style(LAMMPS_NS::LAMMPS* lammps);
LAMMPS_NS::Pair* make_pair_style(LAMMPS_NS::LAMMPS* lammps);
LAMMPS_NS::Fix* make_fix_style(LAMMPS_NS::LAMMPS* lammps, int count, char** arguments);

/// LAMMPS counts from 1.
inline std::int64_t number_of(const LAMMPS_NS::Atom& atom, int i) {
  return static_cast<std::int64_t>(atom.tag[i]) - 1;
}

}  // namespace fiberchain::dem::mpi
