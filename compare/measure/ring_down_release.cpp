#include "compare/measure/ring_down_release.hpp"

#include <cmath>
#include <numbers>

#include "dem/equilibrium/newton.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::compare {
namespace {

double period(const reference::ChainMode& mode) { return 2 * std::numbers::pi / mode.eigenvalue.imag(); }

}  // namespace

dem::Release<2> mode_release(const dem::Fiber& fiber, const reference::ChainMode& mode, double amount,
                             double periods) {
  dem::Release<2> release{dem::straight_chain<2>(fiber), {}, {}, {}, period(mode), periods};
  const double deflection = amount * dem::fiber_length(fiber);
  dem::ChainVector<2> motion;
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    const std::complex<double> y = deflection * mode.displacement[i], angle = deflection * mode.rotation[i];
    motion.push_back({0, y.real(), angle.real()});
    release.velocity.push_back({0, (mode.eigenvalue * y).real()});
    release.spin.push_back({(mode.eigenvalue * angle).real()});
  }
  release.start = release.chain.poses;
  dem::move(release.chain, dem::Boundary<2>{{0}, {}}, release.start, motion);
  return release;
}

dem::Release<2> static_release(const dem::Fiber& fiber, const reference::ChainMode& mode, double load,
                               double periods) {
  dem::Release<2> release{dem::straight_chain<2>(fiber), {}, {}, {}, period(mode), periods};
  const dem::Load<2> end{fiber.aspect_ratio, {0, dem::load_force(fiber, load)}, {}};
  release.start = dem::solve_equilibrium(release.chain, dem::Boundary<2>{{0}, {end}}).poses;
  return release;
}

TipHistory tip_history(const dem::ReleaseRecord<2>& record, double length) {
  if (!record.failure.empty()) throw dem::Diverged(record.failure);
  TipHistory history;
  for (const dem::TipSample<2>& sample : record.samples) {
    history.time.push_back(sample.time);
    history.y.push_back(sample.position[1] / length);
    history.velocity.push_back(sample.velocity[1] / length);
  }
  return history;
}

}  // namespace fiberchain::compare
