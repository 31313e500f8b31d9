#include "dem/bond/branch_steps.hpp"

#include <cmath>

#include "dem/bond/laws/viscoelastic_bond.hpp"
#include "dem/simd/as_numbers.hpp"

namespace fiberchain::dem {
namespace {

BranchStep<double> branch_step(const MaxwellBranch& branch, double dt) {
  const double x = dt / branch.time, gone = -std::expm1(-x);  // 1 - E
  BranchStep<double> step{.keep = 1 - gone,
                          .gain = x > 0 ? gone / x : 1,
                          .strength = branch.strength,
                          .spent_strain = -std::expm1(-2 * x) / 2,
                          .spent_both = x > 0 ? gone * gone / x : 0,
                          .spent_change = 0};
  // (x - 2 (1 - E) + (1 - E^2) / 2) / x^2, by its series where the terms cancel
  step.spent_change = x < 1e-2 ? x / 3 * (1 - x * (3.0 / 4 - x * (7.0 / 20 - x / 8)))
                               : (x - 2 * gone + step.spent_strain) / (x * x);
  return step;
}

int add_steps(const PronySeries& series, double dt, std::vector<BranchStep<double>>& steps) {
  const std::size_t before = steps.size();
  for (const MaxwellBranch& branch : series) {
    if (branch.strength > 0) steps.push_back(branch_step(branch, dt));
  }
  return static_cast<int>(steps.size() - before);
}

}  // namespace

BranchSteps branch_steps(const Fiber& fiber, double dt, int dimension) {
  BranchSteps all;
  all.stretch = add_steps(fiber.branches.stretch, dt, all.steps);
  all.shear = add_steps(fiber.branches.shear, dt, all.steps);
  if (dimension == 3) all.twist = add_steps(fiber.branches.twist, dt, all.steps);
  all.bend = add_steps(fiber.branches.bend, dt, all.steps);
  return all;
}

template <int Dim>
std::size_t bond_memory(const Fiber& fiber, BondForm form) {
  return with_bond_form(form, [&]<BondForm own>() -> std::size_t {
    using Plain = BondLawType<own>;
    if (fiber.branches.empty()) return numbers_of<BondLawHistory<Plain, double, Dim>>;
    using Law = ViscoelasticBond<Plain>;
    const BranchSteps steps = branch_steps(fiber, 0, Dim);
    return numbers_of<BondLawHistory<Law, double, Dim>> +
           branch_memory<Law::keeps_strain, Dim>(steps.stretch, steps.shear, steps.twist, steps.bend);
  });
}

template std::size_t bond_memory<2>(const Fiber&, BondForm);
template std::size_t bond_memory<3>(const Fiber&, BondForm);

}  // namespace fiberchain::dem
