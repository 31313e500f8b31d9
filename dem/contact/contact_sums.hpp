#pragma once

#include <cstdint>
#include <vector>

#include "dem/contact/contact_history.hpp"
#include "dem/contact/laws/contact_action.hpp"
#include "dem/model/domain.hpp"
#include "dem/simd/instruction_set.hpp"

// What contacts of an assembly are asked for, and what they add up to.
namespace fiberchain::dem {

struct ContactOptions {
  bool account_energy = false;  ///< sum the work dissipated by contacts and done by walls
  InstructionSet instruction_set = best_instruction_set();
};

/// Sums of a part over the steps [J] and of the present moment [W].
struct ContactAccumulators {
  std::int64_t contacts = 0;  ///< now
  ContactAccount<double> account{}, power{};

  ContactAccumulators& operator+=(const ContactAccumulators& more);
};

/// Over all contacts at one moment.
struct ContactSums {
  double stored_energy = 0;      ///< in their springs [J]
  double overlap = 0;            ///< over the smaller radius
  std::int64_t overlapping = 0;  ///< contacts whose bodies do: not those of laws that act across a gap
};

/// What forces start from: histories of contacts, walls whose velocities are of half a step before.
struct ContactMemory {
  std::vector<SavedContact> contacts;
  std::vector<Wall> walls;
};

}  // namespace fiberchain::dem
