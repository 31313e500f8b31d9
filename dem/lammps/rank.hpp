#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dem/lammps/plan.hpp"
#include "dem/lammps/rank_contacts.hpp"
#include "dem/lammps/rows.hpp"

namespace fiberchain::dem::mpi {

/// What the styles of a rank share: they are made by LAMMPS, which knows nothing of it.
struct Rank {
  Rank(Plan of_all, InstructionSet instructions)
      : plan(std::move(of_all)), set(instructions), contacts(plan, set) {}
  Rank(const Rank&) = delete;
  Rank& operator=(const Rank&) = delete;

  Plan plan;
  InstructionSet set;
  Rows rows;
  RankContacts contacts;
  std::vector<double> history_before;  ///< of own spheres' bonds, a step before the last one of a march
  double longest_path = 0;             ///< of own spheres and walls in a step [m]
};

/// The group of a LAMMPS type: two for each, of spheres between the ends and of end spheres.
constexpr std::size_t group_of_type(int type) { return static_cast<std::size_t>(type - 1) / 2; }
constexpr bool is_end_type(int type) { return (type - 1) % 2 == 1; }
constexpr int type_of(std::size_t group, bool is_end) {
  return static_cast<int>(2 * group) + (is_end ? 2 : 1);
}

}  // namespace fiberchain::dem::mpi
