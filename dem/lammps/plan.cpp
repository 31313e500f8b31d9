#include "dem/lammps/plan.hpp"

#include <algorithm>

#include "dem/lammps/bond_kernel.hpp"

namespace fiberchain::dem::mpi {

double Plan::largest_radius() const { return std::ranges::max(groups, {}, &GroupNumbers::radius).radius; }
double Plan::smallest_radius() const { return std::ranges::min(groups, {}, &GroupNumbers::radius).radius; }

const BondKernel& bond_kernel(BondForm form, bool damped, InstructionSet set) {
  return kernel_of<BondKernels>(set, 2 * static_cast<int>(form) + (damped ? 1 : 0));
}

bool are_bonded(const GroupNumbers& group, std::int64_t lower, std::int64_t higher) {
  return higher - lower == 1 && (lower - group.first) % group.spheres + 1 < group.spheres;
}

}  // namespace fiberchain::dem::mpi
