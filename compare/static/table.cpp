#include "compare/static/table.hpp"

#include <cmath>

#include "compare/study/errors.hpp"
#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {
namespace {

bool allowed(StaticMethod method, dem::BondForm form) {
  return method == StaticMethod::march || form == dem::BondForm::total;
}

dem::NamedRow row_of(const StaticPoint& p) {
  const StaticCase& c = p.asked;
  const StaticBudget& b = p.budget;
  return {{"aspect_ratio", std::int64_t{c.aspect_ratio}},
          {"poisson_ratio", c.poisson_ratio},
          {"load", c.load},
          {"bond", std::string(dem::name(c.bond))},
          {"method", std::string(name(c.method))},
          {"form", std::string(dem::name(c.form))},
          {"dimension", std::string(c.dimension == 2 ? "planar" : "spatial")},
          {"tip_y", p.tip.y},
          {"tip_x", p.tip.x},
          {"tip_angle", p.tip.angle},
          {"elastica_tip_y", p.elastica.y},
          {"elastica_tip_x", p.elastica.x},
          {"elastica_tip_angle", p.elastica.angle},
          {"reissner_tip_y", p.reissner.y},
          {"reissner_tip_x", p.reissner.x},
          {"reissner_tip_angle", p.reissner.angle},
          {"departure_y", p.departure.y},
          {"departure_x", p.departure.x},
          {"departure_angle", p.departure.angle},
          {"departure_distance", p.distance},
          {"departure_distance_unstretched", p.distance_unstretched},
          {"shear_y", b.shear.y},
          {"shear_x", b.shear.x},
          {"shear_angle", b.shear.angle},
          {"stretch_y", b.stretch.y},
          {"stretch_x", b.stretch.x},
          {"stretch_angle", b.stretch.angle},
          {"discretization_y", b.discretization.y},
          {"discretization_x", b.discretization.x},
          {"discretization_angle", b.discretization.angle},
          {"history_y", b.history.y},
          {"history_x", b.history.x},
          {"history_angle", b.history.angle},
          {"time_step_y", b.time_step.y},
          {"time_step_x", b.time_step.x},
          {"time_step_angle", b.time_step.angle},
          {"leftover_motion_y", b.leftover_motion.y},
          {"leftover_motion_x", b.leftover_motion.x},
          {"leftover_motion_angle", b.leftover_motion.angle},
          {"largest_strain", p.strain},
          {"status", p.status},
          {"residual", p.residual},
          {"stability", std::string(name(p.stability))},
          {"iterations", std::int64_t{p.iterations}},
          {"steps", static_cast<std::int64_t>(p.steps)},
          {"run_time", p.run_time}};
}

/// Order at which an error vanishes between two aspect ratios.
double order(double coarse_error, double fine_error, int coarse, int fine) {
  return std::log(coarse_error / fine_error) / std::log(static_cast<double>(fine) / coarse);
}

}  // namespace

std::vector<StaticCase> cases(const StaticSweep& sweep) {
  std::vector<StaticCase> all;
  for (const auto bond : sweep.bond)
    for (const auto method : sweep.method)
      for (const auto form : sweep.form)
        for (const int dimension : sweep.dimension)
          for (const double nu : sweep.poisson_ratio)
            for (const int aspect_ratio : sweep.aspect_ratio)
              for (const double load : sweep.load)
                if (allowed(method, form))
                  all.push_back({aspect_ratio, nu, load, bond, method, form, dimension});
  if (all.empty()) {
    throw InputError(
        "--form incremental is not allowed with --method solve: it has no energy; use --method march");
  }
  return all;
}

dem::Table static_table(const std::vector<StaticPoint>& points) {
  return tabulate(points, [](const StaticPoint& point) { return row_of(point); });
}

dem::Table static_order_table(double poisson_ratio, const Jobs& jobs) {
  StaticSweep sweep;
  sweep.aspect_ratio = {5, 10, 20, 40, 80};
  sweep.poisson_ratio = {poisson_ratio};
  sweep.bond = {dem::BondModel::paper, dem::BondModel::corrected};
  dem::Table table({"bond", "load", "aspect_ratio", "departure_distance", "order",
                    "departure_distance_unstretched", "order_unstretched"});
  for (const double load : {1.0, 6.0}) {
    sweep.load = {load};
    const std::vector<StaticPoint> points = static_points(cases(sweep), {.jobs = jobs});
    for (std::size_t i = 0; i < points.size(); ++i) {
      const StaticPoint& p = points[i];
      dem::NamedRow row{{"bond", std::string(dem::name(p.asked.bond))},
                        {"load", load},
                        {"aspect_ratio", std::int64_t{p.asked.aspect_ratio}},
                        {"departure_distance", p.distance},
                        {"departure_distance_unstretched", p.distance_unstretched}};
      if (i > 0 && points[i - 1].asked.bond == p.asked.bond) {
        const StaticPoint& coarse = points[i - 1];
        const int from = coarse.asked.aspect_ratio, to = p.asked.aspect_ratio;
        row.emplace_back("order", order(coarse.distance, p.distance, from, to));
        row.emplace_back("order_unstretched",
                         order(coarse.distance_unstretched, p.distance_unstretched, from, to));
      }
      table.append(row);
    }
  }
  return table;
}

}  // namespace fiberchain::compare
