#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "compare/damping/case.hpp"
#include "compare/measure/ring_down_release.hpp"
#include "reference/damped_elastica.hpp"

namespace fiberchain::test {

/// Largest distance of the chain's free end from the damped Elastica's over five periods, over L.
inline double elastica_error(int aspect_ratio, double bond_damping) {
  const compare::DampingCase asked{.aspect_ratio = aspect_ratio, .load = 2, .bond_damping = bond_damping};
  const dem::Fiber fiber = compare::damped_fiber(asked);
  const auto mode = reference::first_bending_mode(compare::linear_chain_of(asked));
  dem::ReleaseOptions options;
  options.samples_per_period = 100;
  const auto record = dem::ring_down<2>({compare::static_release(fiber, mode, asked.load, 5.0)}, options)[0];
  const double L = dem::fiber_length(fiber);
  const double unit = reference::chain_time_unit(aspect_ratio) * dem::bond_time_step(fiber);
  std::vector<double> times;
  for (const auto& sample : record.samples) times.push_back(sample.time / unit);
  const auto beam = reference::damped_elastica(reference::chain_layout(aspect_ratio, bond_damping),
                                               {reference::Release::Shape::static_load, asked.load}, times);
  double worst = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto& p = record.samples[i].position;
    worst = std::max(worst, std::hypot(p[1] / L - beam.samples[i].y, 1 - p[0] / L - beam.samples[i].x));
  }
  return worst;
}

}  // namespace fiberchain::test
