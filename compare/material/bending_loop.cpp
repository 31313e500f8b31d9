#include "compare/material/bending_loop.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "dem/bond/branch_steps.hpp"
#include "dem/bond/laws/viscoelastic_bond.hpp"

namespace fiberchain::compare {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// A bond in the plane whose two spheres turn against each other, nothing else.
class BentBond {
 public:
  BentBond(const dem::Fiber& fiber, double dt)
      : bond_(dem::bond_parameters(fiber)), branches_(dem::branch_steps(fiber, dt, 2)), dt_(dt) {
    const auto numbers = dem::branch_memory<Law::keeps_strain, 2>(branches_.stretch, branches_.shear,
                                                                  branches_.twist, branches_.bend);
    memory_.assign(numbers, 0.0);
  }

  /// Moment that bends it, a step of dt on.
  double moment(double angle, double rate) {
    const double l = bond_.unbent_length - bond_.rest_length * bond_.chord * angle * angle;
    const dem::Pose<double, 2> first{{0, 0}, -angle / 2}, second{{l, 0}, angle / 2};
    const auto line = dem::bond_vector<double, 2>(second.position - first.position, 1 / bond_.rest_length);
    const dem::RelativeMotion<double, 2> motion{{}, {0}, {rate}};
    const auto loads = Law::loads<true>(bond_, branches_.view(), history_, memory_.data(),
                                        dem::BondConfiguration<double, 2>{first, second, line, motion}, dt_);
    return 0.5 * (loads.moment_on_first[0] - loads.moment_on_second[0]);
  }

 private:
  using Law = dem::ViscoelasticBond<dem::TotalBond>;

  dem::BondParameters<double> bond_;
  dem::BranchSteps branches_;
  double dt_;
  std::vector<double> memory_;
  Law::History<double, 2> history_{};
};

}  // namespace

BendingLoop bending_loop(const dem::Fiber& fiber, double frequency, const BendingDrive& drive) {
  const double omega = two_pi * frequency, dt = 1 / (frequency * drive.steps);
  BentBond bond(fiber, dt);
  BendingLoop loop{frequency, {}, {}, 0, 0};
  double lost = 0, in_phase = 0;
  const int last = (drive.cycles - 1) * drive.steps;
  for (int n = 1; n <= drive.cycles * drive.steps; ++n) {
    const double phase = omega * n * dt;
    const double angle = drive.amplitude * std::sin(phase);
    const double moment = bond.moment(angle, drive.amplitude * omega * std::cos(phase));
    if (n > last) {
      lost += 0.5 * (moment + loop.moment.back()) * (angle - loop.angle.back());
      in_phase += 2.0 / drive.steps * moment * std::sin(phase) / drive.amplitude;
    }
    if (n >= last) loop.angle.push_back(angle), loop.moment.push_back(moment);
  }
  loop.storage = in_phase;
  loop.loss = lost / (two_pi * 0.5 * in_phase * drive.amplitude * drive.amplitude);
  return loop;
}

double bending_loss_factor(const dem::Fiber& fiber, double frequency) {
  const std::complex<double> s{0, two_pi * frequency};
  const double retardation = dem::bond_dashpot(fiber).bend / dem::bond_stiffness(fiber).bend;
  const std::complex<double> k = dem::complex_modulus(fiber.branches.bend, s) + retardation * s;
  return k.imag() / k.real();
}

}  // namespace fiberchain::compare
