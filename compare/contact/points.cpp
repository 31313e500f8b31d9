#include "compare/contact/points.hpp"

#include <algorithm>
#include <cmath>

#include "reference/friction.hpp"
#include "reference/hertz.hpp"

namespace fiberchain::compare {
namespace {

using reference::PlanarMotion;

/// The damping ratio of the law's contacts, which end at zero force: by bisection of the closed form.
double damping_ratio_of(double restitution) {
  double low = 0, high = 1;
  while (reference::hertz_restitution(high, reference::ContactEnd::zero_force) > restitution) high *= 2;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    const bool above = reference::hertz_restitution(middle, reference::ContactEnd::zero_force) > restitution;
    (above ? low : high) = middle;
  }
  return restitution < 1 ? (low + high) / 2 : 0;
}

bool is_head_on(const ImpactCase& impact) { return impact.test <= 3; }

ImpactReference head_on_reference(const ImpactCase& impact) {
  const reference::ElasticBody one = elastic_body(impact.first), two = second_body(impact);
  const double closing = closing_speed(impact), parting = impact.restitution * closing;
  const double share = std::isinf(two.mass) ? 0 : one.mass / (one.mass + two.mass);  // of the second
  const double common =
      (1 - share) * impact.second_motion.velocity[0] + share * impact.first_motion.velocity[0];
  ImpactReference expected;
  expected.outcome.first = {{common - (1 - share) * parting, 0}, 0};
  expected.outcome.second = {{common + share * parting, 0}, 0};
  if (impact.restitution < 1) return expected;
  const auto closed = reference::hertz_collision(reference::hertz_pair(one, two), closing);
  expected.outcome.force = closed.force;
  expected.outcome.overlap = closed.overlap;
  expected.outcome.time = closed.time;
  return expected;
}

double largest_of(const ImpactCase& impact, const PlanarMotion& a, const PlanarMotion& b, double radius) {
  const double off = std::max({std::abs(a.velocity[0] - b.velocity[0]),
                               std::abs(a.velocity[1] - b.velocity[1]), radius * std::abs(a.spin - b.spin)});
  return off / closing_speed(impact);
}

double off_of(double value, double expected) { return expected > 0 ? std::abs(value / expected - 1) : 0; }

double root_mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

ImpactPoint impact_point(const ImpactCase& impact, const ImpactPlan& plan) {
  ImpactPoint point{impact, impact_reference(impact), default_step(impact), {}};
  for (const double part : plan.parts) {
    std::vector<double> errors;
    for (const double phase : plan.phases) {
      const ImpactOutcome found = marched_impact(impact, part * point.step, phase);
      errors.push_back(impact_error(impact, found, point.expected));
      if (part != plan.parts.front()) continue;
      if (errors.size() == 1) point.found = found;
      if (point.expected.rigid)
        point.rigid = std::max(point.rigid.value_or(0), rigid_error(impact, found, *point.expected.rigid));
    }
    point.errors.push_back(std::ranges::max(errors));
    point.mean_errors.push_back(root_mean_square(errors));
  }
  return point;
}

}  // namespace

ImpactReference impact_reference(const ImpactCase& impact) {
  if (is_head_on(impact)) return head_on_reference(impact);
  const reference::ElasticBody one = elastic_body(impact.first), two = second_body(impact);
  const reference::Impact hit =
      reference::collide(one, two, {damping_ratio_of(impact.restitution), impact.friction},
                         impact.first_motion, impact.second_motion);
  ImpactReference expected{.outcome = {.first = hit.first, .second = hit.second},
                           .slides = hit.starts_sliding && hit.ends_sliding && hit.changes == 0};
  if (expected.slides)
    expected.rigid = reference::sliding_impact(one, two, impact.friction, impact.restitution,
                                               impact.first_motion, impact.second_motion);
  return expected;
}

double impact_error(const ImpactCase& impact, const ImpactOutcome& found, const ImpactReference& expected) {
  const ImpactOutcome& e = expected.outcome;
  double worst = largest_of(impact, found.first, e.first, impact.first.radius);
  if (impact.second)
    worst = std::max(worst, largest_of(impact, found.second, e.second, impact.second->radius));
  if (is_head_on(impact)) worst /= impact.restitution;
  return std::max(
      {worst, off_of(found.force, e.force), off_of(found.overlap, e.overlap), off_of(found.time, e.time)});
}

double rigid_error(const ImpactCase& impact, const ImpactOutcome& found,
                   const std::array<PlanarMotion, 2>& rigid) {
  const double first = largest_of(impact, found.first, rigid[0], 0);
  return impact.second ? std::max(first, largest_of(impact, found.second, rigid[1], 0)) : first;
}

std::vector<ImpactPoint> impact_points(const std::vector<ImpactCase>& impacts, const ImpactPlan& plan,
                                       const Jobs& jobs) {
  std::vector<ImpactPoint> points(impacts.size());
  jobs.run(impacts.size(), [&](std::size_t i) { points[i] = impact_point(impacts[i], plan); });
  return points;
}

double observed_order(const std::vector<ImpactPoint>& points, const std::vector<double>& parts) {
  double x = 0, y = 0, xx = 0, xy = 0;
  const auto n = static_cast<double>(parts.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    std::vector<double> errors;
    for (const ImpactPoint& point : points) errors.push_back(point.mean_errors[k]);
    const double a = std::log(parts[k]), b = std::log(root_mean_square(errors));
    x += a, y += b, xx += a * a, xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace fiberchain::compare
