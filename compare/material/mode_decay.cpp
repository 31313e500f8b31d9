#include "compare/material/mode_decay.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "compare/measure/first_mode_damping.hpp"
#include "compare/measure/ring_down_release.hpp"

namespace fiberchain::compare {
namespace {

constexpr double small_deflection = 1e-6;

}  // namespace

dem::Release<2> struck_release(const dem::Fiber& fiber, const std::vector<StruckMode>& modes,
                               double periods) {
  const double period = 2 * std::numbers::pi / modes.front().mode.decay.eigenvalue.imag();
  dem::Release<2> release{dem::straight_chain<2>(fiber), {}, {}, {}, period, periods};
  dem::ChainVector<2> motion;
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    std::complex<double> y = 0, angle = 0, velocity = 0, spin = 0;
    for (const StruckMode& struck : modes) {
      // u = Re(c shape exp(s t)) with c = -i: a sine
      const std::complex<double> c{0, -struck.amount * dem::fiber_length(fiber)};
      const auto s = struck.mode.decay.eigenvalue;
      y += c * struck.mode.displacement[i], angle += c * struck.mode.rotation[i];
      velocity += s * c * struck.mode.displacement[i], spin += s * c * struck.mode.rotation[i];
    }
    motion.push_back({0, y.real(), angle.real()});
    release.velocity.push_back({0, velocity.real()});
    release.spin.push_back({spin.real()});
  }
  release.start = release.chain.poses;
  dem::move(release.chain, dem::Boundary<2>{{0}, {}}, release.start, motion);
  return release;
}

TipHistory struck_history(const dem::Fiber& fiber, const std::vector<StruckMode>& modes, double periods,
                          const dem::ReleaseOptions& options) {
  const auto records = dem::ring_down<2>({struck_release(fiber, modes, periods)}, options);
  return tip_history(records.front(), dem::fiber_length(fiber));
}

MarchedDecay marched_decay(const dem::Fiber& fiber, const reference::ComplexChainMode& mode,
                           const dem::ReleaseOptions& options, int intervals) {
  const CleanPeaks clean = filtered_peaks(intervals);
  const double frequency = mode.decay.eigenvalue.imag();
  const auto records =
      dem::ring_down<2>({struck_release(fiber, {{mode, small_deflection}}, clean.periods() + 1)}, options);
  const FirstModeDamping found =
      first_mode_damping(tip_history(records.front(), dem::fiber_length(fiber)), clean, frequency);
  const double ratio = std::isnan(found.sine) ? found.peaks.ratio : found.sine;
  return {ratio, found.peaks.ratio, found.peaks.frequency / (2 * std::numbers::pi), records.front().time_step,
          records.front().steps};
}

Damping decay_in_company(const TipHistory& history, double frequency, int intervals) {
  const FirstModeDamping found = first_mode_damping(history, filtered_peaks(intervals), frequency);
  Damping damping = found.peaks;
  if (!std::isnan(found.sine)) damping.ratio = found.sine;
  return damping;
}

}  // namespace fiberchain::compare
