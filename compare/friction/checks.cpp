#include <algorithm>
#include <cmath>

#include "compare/friction/case.hpp"
#include "compare/friction/stretch_march.hpp"
#include "compare/static/case.hpp"
#include "compare/study/validation.hpp"

namespace fiberchain::compare {
namespace {

constexpr double over_bond(const RollingPoint& p) { return p.damping / p.as_bond; }

/// The paper's statements on Fig 10, all at xi_b = 1.
std::vector<Measured> figure_10(const ValidationInput& in) {
  const auto sign = dem::Rolling::explicit_sign;
  const RollingPoints p =
      rolling_points({{.load = 3, .rolling_friction = 2},
                      {.load = 3, .rolling_friction = 10},
                      {.load = 3, .rolling_friction = 2, .law = sign, .step_ratio = 0.1},
                      {.load = 3, .rolling_friction = 10, .law = sign, .step_ratio = 0.1},
                      {.load = 3, .rolling_friction = 2, .law = sign, .step_ratio = 0.03, .peaks = {1, 2}},
                      {.load = 3, .rolling_friction = 4, .law = sign, .step_ratio = 0.03, .peaks = {1, 2}},
                      {.load = 1, .rolling_friction = 4},
                      {.load = 3, .rolling_friction = 4},
                      {.load = 0.3, .rolling_friction = 4},
                      {.aspect_ratio = 20, .load = 1, .rolling_friction = 4},
                      {.aspect_ratio = 20, .load = 3, .rolling_friction = 4},
                      {.aspect_ratio = 20, .load = 0.3, .rolling_friction = 4}},
                     {.jobs = in.jobs});
  return {{p[1].damping / p[0].damping,
           {p[0].damping, p[1].damping, p[2].damping, p[3].damping, p[4].damping, p[5].damping}},
          {over_bond(p[6]) > 1.5 ? 1.0 : 0.0, {over_bond(p[6]), over_bond(p[7]), over_bond(p[8])}},
          {over_bond(p[9]), {over_bond(p[10]), over_bond(p[11])}}};
}

/// The friction's part of xi_f at small amplitude, march against the linear mode.
double worst_weak_friction(const ValidationInput& in) {
  std::vector<RollingCase> cases;
  for (const int aspect_ratio : {7, 13, 24}) {
    for (const double friction : {0.0, 0.7, 3.0}) {
      cases.push_back({.aspect_ratio = aspect_ratio,
                       .poisson_ratio = 0.17,
                       .amplitude = 0.004,
                       .bond_damping = 0.6,
                       .rolling_friction = friction});
    }
  }
  const RollingPoints p = rolling_points(cases, {.jobs = in.jobs});
  double worst = 0;
  for (std::size_t i = 0; i < p.size(); i += 3) {
    for (std::size_t k = i + 1; k < i + 3; ++k) {
      worst = std::max(worst, std::abs((p[k].damping - p[i].damping) / (p[k].weak - p[k].without) - 1));
    }
  }
  return worst;
}

std::vector<Measured> stretch(const ValidationInput&) {
  dem::Fiber fiber = nominal_fiber(10, 0.3, dem::BondModel::paper);
  fiber.bond_damping = 1;
  const StretchComparison coarse = compare_stretch(fiber, 3, 0.16, {1, 5}),
                          fine = compare_stretch(fiber, 3, 0.08, {1, 5});
  return {{coarse.tip, {std::abs(coarse.damping), coarse.stretch, fine.stretch}}};
}

/// Departure of the deflection from the Elastica [%] at y/L = 0.6, where the paper's realistic bending ends.
double departure_at_large_bending(int aspect_ratio, int jobs) {
  double low = 1, high = 6;
  StaticPoint there;
  for (int i = 0; i < 30; ++i) {
    const double middle = (low + high) / 2;
    there = static_points({{.aspect_ratio = aspect_ratio, .load = middle}}, {.jobs = jobs}).front();
    (there.tip.y < 0.6 ? low : high) = middle;
  }
  return 100 * there.departure.y;
}

std::vector<Measured> recommendation(const ValidationInput& in) {
  int largest = 0;
  std::vector<EvidenceField> departures;
  for (int aspect_ratio = 4; aspect_ratio <= 9; ++aspect_ratio) {
    const double departure = departure_at_large_bending(aspect_ratio, in.jobs);
    if (departure > 1) largest = aspect_ratio;
    departures.emplace_back(departure);
  }
  const auto at_6 = [&](int aspect_ratio, dem::BondModel bond) {
    const auto point =
        static_points({{.aspect_ratio = aspect_ratio, .load = 6, .bond = bond}}, {.jobs = in.jobs}).front();
    return 100 * point.departure.y;
  };
  const auto paper = dem::BondModel::paper;
  departures.insert(departures.end(),
                    {at_6(6, paper), at_6(8, paper), at_6(9, paper), at_6(6, dem::BondModel::corrected)});
  return {{double(largest), departures}};
}

}  // namespace

const Checks& friction_checks() {
  static const Checks checks{
      {{"paper-fig10-plateau", "paper-fig10-30", "paper-fig10-20"}, figure_10},
      {{"friction-weak"},
       [](const ValidationInput& in) -> std::vector<Measured> { return {{worst_weak_friction(in)}}; }},
      {{"paper-stretch-increments"}, stretch},
      {{"paper-recommended-6"}, recommendation}};
  return checks;
}

}  // namespace fiberchain::compare
