#include <algorithm>
#include <cmath>

#include "compare/friction/case.hpp"
#include "compare/friction/stretch_march.hpp"
#include "compare/static/case.hpp"
#include "compare/study/validation.hpp"

namespace fiberchain::compare {
namespace {

constexpr double over_bond(const RollingPoint& p) { return p.damping / p.as_bond; }

/// What the paper says of Fig 10 at xi_r = 4, xi_b = 1: for both fibers at one load, and at others.
std::vector<Measured> figure_10(const ValidationInput& in) {
  const RollingPoints p = rolling_points({{.load = 1, .rolling_friction = 4},
                                          {.load = 3, .rolling_friction = 4},
                                          {.load = 0.3, .rolling_friction = 4},
                                          {.aspect_ratio = 20, .load = 1, .rolling_friction = 4},
                                          {.aspect_ratio = 20, .load = 3, .rolling_friction = 4},
                                          {.aspect_ratio = 20, .load = 0.3, .rolling_friction = 4}},
                                         {.jobs = in.jobs});
  const auto improved = [](const RollingPoint& point) { return point.damping / point.without; };
  return {{improved(p[0]), {improved(p[2]), improved(p[3])}},
          {.value = over_bond(p[0]), .evidence = {over_bond(p[1])}, .otherwise = over_bond(p[2])},
          {.value = over_bond(p[3]), .evidence = {over_bond(p[5])}, .otherwise = over_bond(p[4])},
          {improved(p[0]) / improved(p[3])}};
}

/// Fig 10's plateau beyond xi_r = 2, by the law and by the sign of the lagged spin.
std::vector<Measured> plateau(const ValidationInput& in) {
  const auto sign = dem::Rolling::explicit_sign;
  const RollingPoints p =
      rolling_points({{.load = 1, .rolling_friction = 2},
                      {.load = 1, .rolling_friction = 10},
                      {.load = 3, .rolling_friction = 2},
                      {.load = 3, .rolling_friction = 10},
                      {.load = 3, .rolling_friction = 2, .law = sign, .step_ratio = 0.1},
                      {.load = 3, .rolling_friction = 10, .law = sign, .step_ratio = 0.1},
                      {.load = 3, .rolling_friction = 2, .law = sign, .step_ratio = 0.03, .peaks = {1, 2}},
                      {.load = 3, .rolling_friction = 4, .law = sign, .step_ratio = 0.03, .peaks = {1, 2}}},
                     {.jobs = in.jobs});
  return {{p[1].damping / p[0].damping, {p[0].damping, p[1].damping}},
          {p[3].damping / p[2].damping,
           {p[2].damping, p[3].damping, p[4].damping, p[5].damping, p[6].damping, p[7].damping}}};
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

}  // namespace

const Checks& friction_checks() {
  static const Checks checks{
      {{"paper-fig10-improved", "paper-fig10-30", "paper-fig10-20", "paper-fig10-longer"}, figure_10},
      {{"paper-fig10-plateau", "paper-fig10-plateau-3"}, plateau},
      {{"friction-weak"},
       [](const ValidationInput& in) -> std::vector<Measured> { return {{worst_weak_friction(in)}}; }},
      {{"paper-stretch-increments"}, stretch}};
  return checks;
}

}  // namespace fiberchain::compare
