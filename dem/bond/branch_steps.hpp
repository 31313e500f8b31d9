#pragma once

#include <vector>

#include "dem/bond/branches.hpp"
#include "dem/bond/laws/laws.hpp"

namespace fiberchain::dem {

/// Branches of a fiber's bonds in steps of dt, in the order of BondBranches.
struct BranchSteps {
  std::vector<BranchStep<double>> steps;
  int stretch = 0, shear = 0, twist = 0, bend = 0;  ///< how many of each

  BondBranches<double> view() const { return {steps.data(), stretch, shear, twist, bend}; }
};

/// Branches without strength are left out, and in the plane those of twist. A step of 0 changes nothing.
BranchSteps branch_steps(const Fiber& fiber, double dt, int dimension);

/// Numbers that a bond keeps in Dim dimensions: history of its law, strains of its branches.
template <int Dim>
std::size_t bond_memory(const Fiber& fiber, BondForm form);

}  // namespace fiberchain::dem
