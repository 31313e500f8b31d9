#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/static/case.hpp"
#include "compare/static/table.hpp"
#include "compare/static/tip.hpp"
#include "compare/study/validation.hpp"
#include "dem/equilibrium/newton.hpp"

namespace fiberchain::compare {
namespace {

StaticPoint point(const StaticCase& asked, int jobs) {
  return static_points({asked}, {.jobs = jobs}).front();
}

double departure_percent(int aspect_ratio, double load, int jobs) {
  return 100 * point({.aspect_ratio = aspect_ratio, .load = load}, jobs).departure.y;
}

/// Load at which the departure of the deflection reaches `percent`, by bisection: it grows with the load.
double load_of_departure(int aspect_ratio, double percent, int jobs) {
  double low = 1e-3, high = 10;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    (departure_percent(aspect_ratio, middle, jobs) < percent ? low : high) = middle;
  }
  return low;
}

std::vector<Measured> figure_4(const ValidationInput& in) {
  const double least = 100 * small_load_departure(nominal_fiber(10, 0.3, dem::BondModel::paper));
  const double quarter = load_of_departure(10, 0.25, in.jobs), one = load_of_departure(6, 1.0, in.jobs);
  const double y_quarter = point({.aspect_ratio = 10, .load = quarter}, in.jobs).tip.y;
  const double y_one = point({.aspect_ratio = 6, .load = one}, in.jobs).tip.y;
  const double six_small = 100 * small_load_departure(nominal_fiber(6, 0.3, dem::BondModel::paper));
  const double rise_1 = departure_percent(6, 1.0, in.jobs), rise_25 = departure_percent(6, 2.5, in.jobs);
  return {{least},
          {departure_percent(10, 6, in.jobs)},
          {y_quarter, {y_quarter, quarter}},
          {six_small, {six_small, one, y_one}},
          {rise_25 - rise_1, {rise_1, rise_25}}};
}

std::vector<Measured> increments(const ValidationInput& in) {
  const StaticPoint total = point({.load = 6}, in.jobs);
  const StaticPoint increments =
      point({.load = 6, .method = StaticMethod::march, .form = dem::BondForm::incremental}, in.jobs);
  const double difference = std::abs(increments.departure.y) - std::abs(total.departure.y);
  return {{difference,
           {100 * increments.departure.y, 100 * total.departure.y, std::abs(difference),
            std::abs(total.departure.y / difference)}}};
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
double observed_order(dem::BondModel bond, double StaticPoint::*distance, int jobs) {
  const StaticPoint coarse = point({.aspect_ratio = 20, .load = 6, .bond = bond}, jobs);
  const StaticPoint fine = point({.aspect_ratio = 40, .load = 6, .bond = bond}, jobs);
  return std::log2(coarse.*distance / (fine.*distance));
}

double march_less_solve(int jobs) {
  const StaticPoint solved = point({.aspect_ratio = 13, .poisson_ratio = 0.17, .load = 3}, jobs);
  const StaticPoint marched =
      point({.aspect_ratio = 13, .poisson_ratio = 0.17, .load = 3, .method = StaticMethod::march}, jobs);
  return std::hypot(marched.tip.y - solved.tip.y, marched.tip.x - solved.tip.x) / solved.tip.y;
}

double worst_corrected_distance(int jobs) {
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
  static const Checks checks{
      {{"paper-fig4-rf10-least", "paper-fig4-rf10-most", "paper-fig4-rf10-small", "paper-fig4-rf6-small",
        "paper-fig4-rf6-rise"},
       figure_4},
      {{"paper-bond-time-step"}, [](const In&) -> Found { return {{bond_time_step_factor()}}; }},
      {{"paper-incremental-superior"}, increments},
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
  return checks;
}

}  // namespace fiberchain::compare
