#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "compare/contact/experiments.hpp"
#include "compare/contact/study.hpp"

namespace fiberchain::compare {
namespace {

using Quantity = std::function<double(const ImpactCase&, const ImpactOutcome&)>;

double degrees(double tangent) { return std::atan(tangent) * 180 / std::numbers::pi; }

/// Against the angle of incidence, of each material of a test: points of the march and a line of the
/// reference.
void add_curves(Figure& figure, const std::vector<ImpactPoint>& points, int test, const Quantity& x,
                const Quantity& y) {
  std::vector<std::string> materials;
  for (const ImpactPoint& p : points) {
    if (p.impact.test == test && std::ranges::find(materials, p.impact.material) == materials.end())
      materials.push_back(p.impact.material);
  }
  for (const std::string& material : materials) {
    const int color = static_cast<int>(figure.series.size() / 2);
    Series march{material, {}, {}, Mark::points, Dash::solid, color},
        exact{"", {}, {}, Mark::line, Dash::solid, color};
    for (const ImpactPoint& p : points) {
      if (p.impact.test != test || p.impact.material != material) continue;
      march.add(x(p.impact, p.found), y(p.impact, p.found));
      exact.add(x(p.impact, p.expected.outcome), y(p.impact, p.expected.outcome));
    }
    figure.series.push_back(std::move(march)), figure.series.push_back(std::move(exact));
  }
}

void add_experiment(Figure& figure, const char* label, const char* whose, const char* quantity) {
  const ExperimentPoints points = experiment_points(whose, quantity);
  figure.series.push_back({label, points.x, points.y, Mark::points, Dash::solid, 7});
}

constexpr const char* kMeasured = "measured (Kharaz et al. 2001)";

Figure oblique_figure(const std::vector<ImpactPoint>& points, const char* title, const char* axis,
                      const char* quantity, const Quantity& y) {
  Figure figure{title, {"angle of incidence (degrees)", false, std::pair{0.0, 90.0}}, {axis}, {}};
  add_curves(
      figure, points, 4, [](const ImpactCase& c, const ImpactOutcome&) { return degrees(incidence(c)); }, y);
  add_experiment(figure, kMeasured, "kharaz", quantity);
  return figure;
}

Figure recoil_figure(const std::vector<ImpactPoint>& points) {
  Figure figure{"Test 5: recoil against incidence, march at the default step (points), reference (lines)",
                {"slip before over μ × normal speed", false, std::pair{0.0, 14.0}},
                {"slip after over μ × normal speed", false, std::pair{-4.0, 7.0}},
                {}};
  add_curves(
      figure, points, 5, [](const ImpactCase& c, const ImpactOutcome&) { return incidence(c) / c.friction; },
      [](const ImpactCase& c, const ImpactOutcome& o) { return recoil(c, o) / c.friction; });
  add_experiment(figure, "finite elements (as drawn by Chung and Ooi)", "fem", "recoil");
  return figure;
}

Figure spinning_figure(const std::vector<ImpactPoint>& points, int test) {
  Figure figure{
      fmt::format("Test {}: spinning spheres, march at the default step (points), reference (lines)", test),
      {"tangent of the angle of incidence", false, std::pair{0.0, 4.0}},
      {"tangent of the angle of recoil", false, std::pair{-1.0, 4.0}},
      {}};
  add_curves(
      figure, points, test, [](const ImpactCase& c, const ImpactOutcome&) { return incidence(c); },
      [](const ImpactCase& c, const ImpactOutcome& o) { return recoil(c, o); });
  return figure;
}

Figure order_figure(const std::vector<ImpactPoint>& points, const std::vector<double>& parts) {
  Figure figure{"Tests 1 to 8: error against the time step",
                {"time step over the default one", true},
                {"error over the normal speed of the impact", true},
                {}};
  for (int test = 1; test <= impact_tests; ++test) {
    std::vector<ImpactPoint> own;
    std::ranges::copy_if(points, std::back_inserter(own),
                         [&](const ImpactPoint& p) { return p.impact.test == test; });
    if (own.empty()) continue;
    Series curve{fmt::format("test {}", test), {}, {}};
    for (std::size_t k = 0; k < parts.size(); ++k) curve.add(parts[k], mean_error(own, k));
    figure.series.push_back(std::move(curve));
  }
  return figure;
}

bool has(const std::vector<ImpactPoint>& points, int test) {
  return std::ranges::any_of(points, [&](const ImpactPoint& p) { return p.impact.test == test; });
}

}  // namespace

std::vector<std::pair<std::string, Figure>> impact_figures(const std::vector<ImpactPoint>& points,
                                                           const std::vector<double>& parts) {
  std::vector<std::pair<std::string, Figure>> all;
  if (has(points, 4)) {
    all.emplace_back("contact-tangential",
                     oblique_figure(points,
                                    "Test 4: tangential restitution of the center, march (points), reference "
                                    "(lines)",
                                    "tangential velocity after over before", "tangential_restitution",
                                    [](const ImpactCase& c, const ImpactOutcome& o) {
                                      return o.first.velocity[1] / c.first_motion.velocity[1];
                                    }));
    all.emplace_back(
        "contact-spin",
        oblique_figure(points, "Test 4: spin after, march (points), reference (lines)", "spin (1/s)", "spin",
                       [](const ImpactCase&, const ImpactOutcome& o) { return o.first.spin; }));
    all.emplace_back(
        "contact-rebound",
        oblique_figure(points,
                       "Test 4: rebound angle of the contact point, march (points), reference "
                       "(lines)",
                       "rebound angle (degrees)", "rebound_angle",
                       [](const ImpactCase& c, const ImpactOutcome& o) { return degrees(recoil(c, o)); }));
  }
  if (has(points, 5)) all.emplace_back("contact-recoil", recoil_figure(points));
  if (has(points, 6)) all.emplace_back("contact-spinning", spinning_figure(points, 6));
  if (has(points, 8)) all.emplace_back("contact-unlike", spinning_figure(points, 8));
  if (parts.size() > 1) all.emplace_back("contact-order", order_figure(points, parts));
  return all;
}

}  // namespace fiberchain::compare
