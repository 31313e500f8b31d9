#pragma once

#include <cstdint>
#include <vector>

#include "dem/assembly/saved_state.hpp"
#include "dem/chain/chain_state.hpp"
#include "dem/contact/contact_history.hpp"
#include "dem/motion/physics.hpp"

// Fibers on their way from one assembly into another, whose walls, laws, step and memory may be others.
namespace fiberchain::dem {

/// The fibers of a group, and what their bonds remember.
struct CarriedGroup {
  double radius = 0;                  ///< of the spheres [m]
  bool oriented = false;              ///< orientations are known; else the poses have positions alone
  std::vector<ChainState<3>> fibers;  ///< velocities and spins half a step back where `step` is not 0
  BondForm form = BondForm::total;
  int law_numbers = 0, bond_numbers = 0;  ///< of a bond: those of its law, those with its branches
  std::vector<double> histories;          ///< bond after bond, fiber after fiber; empty where not known
  std::vector<double> loads;              ///< of contacts, load_size a sphere; empty where not known

  int spheres() const { return fibers.empty() ? 0 : static_cast<int>(fibers.front().poses.size()); }
};

/// All of them. Spheres are numbered through groups, fibers and spheres.
struct CarriedState {
  double time = 0;  ///< [s]
  double step = 0;  ///< by which velocities are half a step back and histories a whole one [s]
  std::vector<CarriedGroup> groups;
  std::vector<SavedContact> contacts;  ///< by the numbers of spheres and walls there; works are zero
};

/// The fibers in a saved state, whatever instruction set and bond form it is of.
/// @throws InvalidInput naming the field that is missing, of another version or type, or does not fit
CarriedState carried_state(const SavedState& saved);

/// Orientations from positions alone: each sphere's axis along its fiber, turned from one to the next the
/// shortest way. They know no twist and no shear.
void orient_along(ChainState<3>& fiber);

/// What did not go over.
struct CarriedLosses {
  std::int64_t contacts = 0;          ///< that the file has
  std::int64_t kept = 0;              ///< of them with their history
  std::int64_t bonds_without = 0;     ///< bonds whose strain follows from the places of their spheres
  std::int64_t branches_without = 0;  ///< bonds whose branches begin at rest
};

}  // namespace fiberchain::dem
