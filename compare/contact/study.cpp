#include "compare/contact/study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {
namespace {

dem::NamedRow row_of(const ImpactPoint& p) {
  const ImpactCase& c = p.impact;
  const double after = p.found.second.velocity[0] - p.found.first.velocity[0];
  return {{"impact_test", std::int64_t{c.test}},
          {"impact_material", c.material},
          {"restitution", c.restitution},
          {"restitution_found", after / closing_speed(c)},
          {"incidence", incidence(c)},
          {"recoil", recoil(c, p.found)},
          {"recoil_reference", recoil(c, p.expected.outcome)},
          {"impact_spin", p.found.first.spin},
          {"impact_slides", std::string(p.expected.slides ? "yes" : "no")},
          {"time_step", p.step},
          {"impact_steps", p.found.steps},
          {"impact_error", p.errors.front()},
          {"impact_error_rigid", p.rigid ? dem::Cell{*p.rigid} : dem::Cell{}}};
}

std::vector<ImpactPoint> of_test(const std::vector<ImpactPoint>& points, int test) {
  std::vector<ImpactPoint> own;
  std::ranges::copy_if(points, std::back_inserter(own),
                       [&](const ImpactPoint& p) { return p.impact.test == test; });
  return own;
}

dem::Table step_table(const std::vector<ImpactPoint>& points, const ContactPlan& plan) {
  dem::Table table({"impact_test", "step_part", "impact_error", "impact_order"});
  for (const int test : plan.tests) {
    const std::vector<ImpactPoint> own = of_test(points, test);
    for (std::size_t k = 0; k < plan.parts.size(); ++k) {
      const bool last = k + 1 == plan.parts.size();
      const double error = mean_error(own, k);
      const dem::Cell order = last ? dem::Cell{}
                                   : dem::Cell{std::log(error / mean_error(own, k + 1)) /
                                               std::log(plan.parts[k] / plan.parts[k + 1])};
      table.append({{"impact_test", std::int64_t{test}},
                    {"step_part", plan.parts[k]},
                    {"impact_error", error},
                    {"impact_order", order}});
    }
  }
  return table;
}

}  // namespace

double incidence(const ImpactCase& impact) {
  return std::abs(slip(impact, impact.first_motion, impact.second_motion)) / closing_speed(impact);
}

double recoil(const ImpactCase& impact, const ImpactOutcome& outcome) {
  const double before = slip(impact, impact.first_motion, impact.second_motion),
               after = slip(impact, outcome.first, outcome.second);
  return std::copysign(1.0, before) * after / (outcome.second.velocity[0] - outcome.first.velocity[0]);
}

double mean_error(const std::vector<ImpactPoint>& points, std::size_t k) {
  double sum = 0;
  for (const ImpactPoint& p : points) sum += p.mean_errors[k] * p.mean_errors[k];
  return std::sqrt(sum / static_cast<double>(points.size()));
}

dem::Table impact_table(const std::vector<ImpactPoint>& points) {
  return tabulate(points, [](const ImpactPoint& p) { return row_of(p); });
}

ContactStudy impact_study(const ContactPlan& plan, const Jobs& jobs) {
  std::vector<ImpactCase> impacts;
  for (const int test : plan.tests) {
    for (ImpactCase& impact : impact_cases(test, impact_angles())) impacts.push_back(std::move(impact));
  }
  const std::vector<ImpactPoint> points = impact_points(impacts, {.parts = plan.parts}, jobs);
  return {impact_table(points), step_table(points, plan), impact_figures(points, plan.parts)};
}

}  // namespace fiberchain::compare
