#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/static/case.hpp"
#include "compare/static/paper_checks.hpp"
#include "compare/static/table.hpp"
#include "compare/static/tip.hpp"
#include "compare/study/validation.hpp"
#include "dem/equilibrium/newton.hpp"

namespace fiberchain::compare {
namespace {

StaticPoint point(const StaticCase& asked, const Jobs& jobs) {
  return static_points({asked}, {.jobs = jobs}).front();
}

/// Largest relative error of the small-load departure against its formula over odd materials.
double worst_small_load_error() {
  double worst = 0;
  for (const int aspect_ratio : {4, 7, 10, 13, 25}) {
    for (const double nu : {-0.2, 0.0, 0.17, 0.3, 0.49}) {
      const dem::Fiber fiber = nominal_fiber(aspect_ratio, nu, dem::BondModel::paper);
      const double exact = (0.375 * (1 + nu) - 0.25) / (aspect_ratio * aspect_ratio);
      worst = std::max(worst, std::abs(small_load_departure(fiber) / exact - 1));
    }
  }
  return worst;
}

/// The free end of a chain under the moment that closes it, from the clamp, over L.
double ring_gap(int bonds) {
  const dem::Fiber fiber = nominal_fiber(bonds, 0.17, dem::BondModel::paper);
  const double closing = 2 * std::numbers::pi * dem::bending_stiffness(fiber) / dem::fiber_length(fiber);
  const auto ring =
      dem::solve_equilibrium(dem::straight_chain<2>(fiber), dem::Boundary<2>{{0}, {{bonds, {}, {closing}}}});
  return dem::norm(ring.poses.back().position) / dem::fiber_length(fiber);
}

/// Observed order between r_f = 20 and 40 at load 6.
double observed_order(dem::BondModel bond, double StaticPoint::*distance, const Jobs& jobs) {
  const StaticPoint coarse = point({.aspect_ratio = 20, .load = 6, .bond = bond}, jobs);
  const StaticPoint fine = point({.aspect_ratio = 40, .load = 6, .bond = bond}, jobs);
  return std::log2(coarse.*distance / (fine.*distance));
}

double march_less_solve(const Jobs& jobs) {
  const StaticPoint solved = point({.aspect_ratio = 13, .poisson_ratio = 0.17, .load = 3}, jobs);
  const StaticPoint marched =
      point({.aspect_ratio = 13, .poisson_ratio = 0.17, .load = 3, .method = StaticMethod::march}, jobs);
  return std::hypot(marched.tip.y - solved.tip.y, marched.tip.x - solved.tip.x) / solved.tip.y;
}

double worst_corrected_distance(const Jobs& jobs) {
  double worst = 0;
  for (const double load : {0.05, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) {
    worst =
        std::max(worst, point({.load = load, .bond = dem::BondModel::corrected}, jobs).distance_unstretched);
  }
  return worst;
}

double bond_time_step_factor() {
  const dem::Fiber fiber = nominal_fiber(13, 0.17, dem::BondModel::paper);
  return dem::bond_time_step(fiber) /
         (fiber.diameter * std::sqrt(fiber.material.density / fiber.material.youngs_modulus));
}

/// L-shaped fiber, two arms of six bonds, a load across its plane at PL^2/EI = 3 (L one arm): largest
/// distance over L of the free ends by a direct path, by a detour and numbered from the other end.
double corner_gap() {
  const dem::Fiber fiber = nominal_fiber(12, 0.17, dem::BondModel::paper);
  const dem::Chain<3> chain = dem::cornered_chain<3>(fiber, 6);
  const double arm = 6 * dem::bond_length(fiber), P = 3 * dem::bending_stiffness(fiber) / (arm * arm);
  const dem::Boundary<3> across{{0}, {{12, {0, 0, P}, {}}}},
      detour{{0}, {{12, {0.8 * P, -0.5 * P, 0.2 * P}, {}}}};
  const auto direct = dem::solve_equilibrium(chain, across).poses.back().position;
  const auto halfway = dem::solve_equilibrium(chain, detour).poses;
  const auto around = dem::continue_equilibrium(chain, halfway, detour, across).poses.back().position;
  const dem::Boundary<3> from_other_end{{12}, {{0, {0, 0, P}, {}}}};
  const auto backward = dem::solve_equilibrium(dem::renumbered(chain), from_other_end).poses.front().position;
  return std::max(dem::norm(around - direct), dem::norm(backward - direct)) / arm;
}

}  // namespace

const Checks& static_checks() {
  using In = ValidationInput;
  using Found = std::vector<Measured>;
  using dem::BondModel;
  const Checks own{
      {{"paper-bond-time-step"}, [](const In&) -> Found { return {{bond_time_step_factor()}}; }},
      {{"small-load-departure"}, [](const In&) -> Found { return {{worst_small_load_error()}}; }},
      {{"small-load-departure-corrected"},
       [](const In&) -> Found {
         return {{small_load_departure(nominal_fiber(13, 0.17, BondModel::corrected))}};
       }},
      {{"ring"}, [](const In&) -> Found { return {{ring_gap(13)}}; }},
      {{"order-paper"},
       [](const In& in) -> Found {
         return {{observed_order(BondModel::paper, &StaticPoint::distance, in.jobs)}};
       }},
      {{"order-corrected"},
       [](const In& in) -> Found {
         return {{observed_order(BondModel::corrected, &StaticPoint::distance_unstretched, in.jobs)}};
       }},
      {{"corrected-distance"}, [](const In& in) -> Found { return {{worst_corrected_distance(in.jobs)}}; }},
      {{"corner-path"}, [](const In&) -> Found { return {{corner_gap()}}; }},
      {{"march-solve"}, [](const In& in) -> Found { return {{march_less_solve(in.jobs)}}; }}};
  static const Checks checks = merged(paper_static_checks(), own);
  return checks;
}

}  // namespace fiberchain::compare
