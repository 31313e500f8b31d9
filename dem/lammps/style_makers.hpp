#pragma once

#include <mpi.h>

#include <algorithm>
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

/// Bonds read LAMMPS's rows of three numbers four at a time in lanes: there must be room behind the last.
inline InstructionSet set_for_rows(const Rank& rank, const LAMMPS_NS::Atom& atom) {
  return atom.nlocal + atom.nghost < atom.nmax ? rank.set : InstructionSet::scalar;
}

/// Where a sphere is and how it moves, as the contact loops want it.
inline void put_row(Rows& rows, const LAMMPS_NS::Atom& atom, int i) {
  double *place = rows.position_of(static_cast<std::size_t>(i)),
         *motion = rows.motion_of(static_cast<std::size_t>(i));
  std::copy_n(atom.x[i], 3, place);
  std::copy_n(atom.v[i], 3, motion);
  std::copy_n(atom.omega[i], 3, motion + spin_offset);
}

/// LAMMPS counts from 1.
inline std::int64_t number_of(const LAMMPS_NS::Atom& atom, int i) {
  return static_cast<std::int64_t>(atom.tag[i]) - 1;
}

}  // namespace fiberchain::dem::mpi
