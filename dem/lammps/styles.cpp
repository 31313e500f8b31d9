#include "dem/lammps/styles.hpp"

#include <map>

#include "bond.h"
#include "dem/lammps/style_makers.hpp"
#include "fix.h"
#include "force.h"
#include "modify.h"
#include "pair.h"

namespace fiberchain::dem::mpi {
namespace {

using LAMMPS_NS::LAMMPS;

std::map<LAMMPS*, Rank*>& ranks() {
  static std::map<LAMMPS*, Rank*> all;
  return all;
}

}  // namespace

Rank& rank_of(LAMMPS* lammps) { return *ranks().at(lammps); }

void register_styles(LAMMPS& lammps, Rank& rank) {
  ranks()[&lammps] = &rank;
  (*lammps.force->bond_map)["fiberchain"] = &make_bond_style;
  (*lammps.force->pair_map)["fiberchain"] = &make_pair_style;
  (*lammps.modify->fix_map)["fiberchain"] = &make_fix_style;
}

void forget_styles(LAMMPS& lammps) { ranks().erase(&lammps); }

}  // namespace fiberchain::dem::mpi
