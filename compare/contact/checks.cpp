#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "compare/contact/adhesion.hpp"
#include "compare/contact/experiments.hpp"
#include "compare/contact/study.hpp"
#include "compare/study/validation.hpp"
#include "reference/adhesion.hpp"
#include "reference/friction.hpp"

namespace fiberchain::compare {
namespace {

std::vector<ImpactPoint> points_of(int test, const std::vector<double>& angles,
                                   const std::vector<double>& parts) {
  return impact_points(impact_cases(test, angles), {.parts = parts}, 1);
}

double worst_error(const std::vector<ImpactPoint>& points, std::size_t k) {
  double worst = 0;
  for (const ImpactPoint& p : points) worst = std::max(worst, p.errors[k]);
  return worst;
}

/// Tests 1 to 8: the largest error at a part of the default step, with that at the default one. The part is
/// smaller where damped surfaces stick, which is of first order.
std::vector<Measured> eight_tests(const ValidationInput& in) {
  std::vector<Measured> all(impact_tests);
  in.jobs.run(all.size(), [&](std::size_t i) {
    const int test = static_cast<int>(i) + 1;
    const double part = test == 6 || test == 8 ? 1.0 / 16 : 0.25;
    const auto points = points_of(test, few_impact_angles(), {1, part});
    const auto [least, most] =
        std::ranges::minmax(points, {}, [](const ImpactPoint& p) { return p.found.steps; });
    all[i] = {worst_error(points, 1), {least.found.steps, most.found.steps, worst_error(points, 0)}};
  });
  return all;
}

/// Order of the step where nothing changes along the surfaces, and where contacts slide and then stick.
std::vector<Measured> orders(const ValidationInput&) {
  const std::vector<double> parts{0.5, 0.25, 0.125};
  std::vector<ImpactPoint> smooth;
  for (const int test : {1, 2, 3, 7}) {
    for (ImpactPoint& p : points_of(test, {45}, parts)) smooth.push_back(std::move(p));
  }
  return {{observed_order(smooth, parts)},
          {observed_order(points_of(6, {45}, parts), parts),
           {observed_order(points_of(4, few_impact_angles(), parts), parts),
            observed_order(points_of(5, few_impact_angles(), parts), parts)}}};
}

/// Against rigid bodies, where contacts slide throughout.
std::vector<Measured> rigid_bodies(const ValidationInput&) {
  double worst = 0;
  int cases = 0;
  for (const int test : {4, 5, 6, 8}) {
    for (const ImpactCase& impact : impact_cases(test, few_impact_angles())) {
      const ImpactReference expected = impact_reference(impact);
      if (!expected.rigid) continue;
      ++cases;
      const ImpactOutcome found = marched_impact(impact, 0.25 * default_step(impact), 0.35);
      worst = std::max(worst, rigid_error(impact, found, *expected.rigid));
    }
  }
  return {{worst, {cases}}};
}

ImpactCase oxide(double degrees) { return impact_cases(4, {degrees}).front(); }

ImpactOutcome fine(const ImpactCase& impact) {
  return marched_impact(impact, 0.25 * default_step(impact), 0.35);
}

double quantity_of(const std::string& quantity, const ImpactCase& impact, const ImpactOutcome& outcome) {
  if (quantity == "spin") return outcome.first.spin;
  if (quantity == "rebound_angle") return std::atan(recoil(impact, outcome)) * 180 / std::numbers::pi;
  return outcome.first.velocity[1] / impact.first_motion.velocity[1];
}

/// Distance from measured points, root mean square over the range that they span: of the march, of the
/// reference; without the points below 8 degrees, too.
Measured distance_from(const std::string& quantity) {
  const ExperimentPoints points = experiment_points("kharaz", quantity);
  const auto [least, most] = std::ranges::minmax(points.y);
  const auto distance = [&](double from, const std::function<ImpactOutcome(const ImpactCase&)>& outcome_of) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      if (points.x[i] < from) continue;
      const ImpactCase impact = oxide(points.x[i]);
      sum += std::pow(quantity_of(quantity, impact, outcome_of(impact)) - points.y[i], 2), ++count;
    }
    return std::sqrt(sum / count) / (most - least);
  };
  const auto exact = [](const ImpactCase& impact) { return impact_reference(impact).outcome; };
  return {.value = distance(0, fine),
          .evidence = {static_cast<int>(points.x.size()), distance(8, fine)},
          .expected = distance(0, exact)};
}

/// Angle from which a march ends as a rigid body that slides through does.
Measured sliding_angle() {
  int from = 45;
  while (from > 20) {
    const ImpactCase impact = oxide(from - 1);
    const auto rigid =
        reference::sliding_impact(elastic_body(impact.first), second_body(impact), impact.friction,
                                  impact.restitution, impact.first_motion, impact.second_motion);
    if (rigid_error(impact, fine(impact), rigid) > 1e-3) break;
    --from;
  }
  return {static_cast<double>(from), {std::atan(3.5 * 0.092 * 1.98) * 180 / std::numbers::pi}};
}

std::vector<Measured> kharaz(const ValidationInput&) {
  return {distance_from("tangential_restitution"), distance_from("spin"), distance_from("rebound_angle"),
          sliding_angle()};
}

std::vector<Measured> jkr(const ValidationInput&) {
  const AdhesionCase twice = adhesion_case("jkr", 2);
  const reference::HertzPair pair = hertz_pair_of(twice);
  const double loss = reference::jkr_cycle_loss(pair, twice.work_of_adhesion),
               energy = 0.5 * pair.mass * twice.speed * twice.speed, step = default_step(twice);
  const AdhesionOutcome coarse = marched_adhesion(twice, step, 0.35),
                        found = marched_adhesion(twice, step / 4, 0.35);
  const auto lost = [&](const AdhesionOutcome& o) {
    return (1 - o.restitution * o.restitution) * energy / loss;
  };
  double low = 0.8, high = 1.25;  // over the sticking speed
  while (high - low > 1e-3) {
    const double middle = (low + high) / 2;
    const AdhesionCase a = adhesion_case("jkr", middle);
    (marched_adhesion(a, step / 4, 0.35).parted ? high : low) = middle;
  }
  return {{found.work_off},
          {found.pull / reference::jkr_pull_off(pair, twice.work_of_adhesion),
           {coarse.pull / reference::jkr_pull_off(pair, twice.work_of_adhesion)}},
          {lost(found), {lost(coarse), reference::hertz_collision(pair, twice.speed).time / step}},
          {(low + high) / 2},
          {found.energy_change, {coarse.energy_change}}};
}

std::vector<Measured> dmt(const ValidationInput&) {
  const AdhesionCase slow = adhesion_case("dmt", 1.1);
  const double step = default_step(slow) / 4,
               pull = reference::dmt_pull_off(hertz_pair_of(slow), slow.work_of_adhesion);
  const AdhesionOutcome found = marched_adhesion(slow, step, 0.35);
  return {{found.pull / pull}, {found.restitution}};
}

}  // namespace

const Checks& contact_checks() {
  static const Checks checks{
      {{"chung-ooi-1", "chung-ooi-2", "chung-ooi-3", "chung-ooi-4", "chung-ooi-5", "chung-ooi-6",
        "chung-ooi-7", "chung-ooi-8"},
       eight_tests},
      {{"impact-order", "impact-order-sticks"}, orders},
      {{"impact-rigid"}, rigid_bodies},
      {{"kharaz-tangential", "kharaz-spin", "kharaz-rebound", "kharaz-sliding"}, kharaz},
      {{"jkr-curve", "jkr-pull-off", "jkr-loss", "jkr-sticking", "jkr-energy"}, jkr},
      {{"dmt-pull-off", "dmt-restitution"}, dmt}};
  return checks;
}

}  // namespace fiberchain::compare
