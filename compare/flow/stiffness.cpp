#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "compare/flow/study.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/tabulate.hpp"
#include "reference/equivalent_aspect_ratio.hpp"
#include "reference/jeffery.hpp"

namespace fiberchain::compare {

std::vector<StiffnessPoint> stiffness_points(int spheres, const std::vector<double>& ratios,
                                             const OrbitOptions& options) {
  std::vector<OrbitCase> cases;
  for (const double ratio : ratios) {
    // 3 pi mu rate (2RN)^4/(E pi R^4/4) = 192 N^4 mu rate/E; the first half turn, of bonds that take up their
    // load, is not measured
    cases.push_back({.spheres = spheres,
                     .elasto_viscous = 192 * std::pow(spheres, 4) * ratio,
                     .turns = 1,
                     .interval = 0.02,
                     .tolerance = 1e-12});
  }
  const double rigid = reference::jeffery_period(reference::free_draining_aspect_ratio(spheres), 1);
  std::vector<StiffnessPoint> points;
  for (const OrbitPoint& p : orbit_points(cases, options)) {
    StiffnessPoint point{spheres, ratios[points.size()], p.period / rigid - 1, nan};
    if (!points.empty()) {
      const StiffnessPoint& before = points.back();
      point.order = std::log(point.correction / before.correction) /
                    std::log(point.viscous_ratio / before.viscous_ratio);
    }
    points.push_back(point);
  }
  return points;
}

FlowStudy stiffness_study(const OrbitOptions& options) {
  dem::Table table({"aspect_ratio", "spheres", "viscous_ratio", "elasto_viscous", "period_error", "order"});
  Figure figure{"Period of a chain of finite stiffness over the rigid one's",
                {"μ rate/{/:Italic E}", true},
                {"|period over the rigid chain's - 1|", true},
                {}};
  FlowStudy study{std::move(table)};
  for (const int spheres : {2, 3, 5, 11}) {
    // up to where the chain of 11 buckles
    const std::vector<double> ratios =
        spheres < 11 ? std::vector<double>{1e-4, 3e-4, 1e-3, 3e-3} : std::vector<double>{3e-5, 1e-4, 3e-4};
    Series s{fmt::format("N = {}", spheres), {}, {}};
    for (const StiffnessPoint& p : stiffness_points(spheres, ratios, options)) {
      study.table.append({{"aspect_ratio", std::int64_t{p.spheres - 1}},
                          {"spheres", std::int64_t{p.spheres}},
                          {"viscous_ratio", p.viscous_ratio},
                          {"elasto_viscous", 192 * std::pow(p.spheres, 4) * p.viscous_ratio},
                          {"period_error", p.correction},
                          {"order", dem::known(p.order)}});
      if (std::isnan(p.correction)) ++study.failed;
      s.add(p.viscous_ratio, std::abs(p.correction));
    }
    figure.series.push_back(std::move(s));
  }
  study.figures = {{"shear-stiffness", std::move(figure)}};
  return study;
}

}  // namespace fiberchain::compare
