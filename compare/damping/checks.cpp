#include <algorithm>
#include <cmath>

#include "compare/damping/table.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/validation.hpp"
#include "reference/damped_elastica.hpp"

namespace fiberchain::compare {
namespace {

DampingPoints measure(const std::vector<DampingCase>& cases, int jobs) {
  DampingOptions options;
  options.jobs = jobs;
  options.elastica = false;
  return damping_points(cases, options);
}

/// Load P L^2/(E I) of a force on the nominal fiber.
double load_of_shear_modulus(double force, int aspect_ratio, double shear_modulus = 1e6) {
  const DampingCase unit{.aspect_ratio = aspect_ratio, .youngs_modulus = 2.6 * shear_modulus};
  return force / dem::load_force(damped_fiber(unit), 1.0);
}

/// Paper's slope where fiber_damping_paper passes it, by interpolation between loads; NaN if no load up to 3
/// gives it.
Measured slope(const ValidationInput& in, int aspect_ratio, const std::string& id) {
  const double wanted = find_claim(in.claims, id).value;
  std::vector<DampingCase> cases;
  for (int i = 0; i < 16; ++i) cases.push_back({.aspect_ratio = aspect_ratio, .load = 0.02 + 0.2 * i});
  const DampingPoints points = measure(cases, in.jobs);
  double load = nan, there = load;
  for (std::size_t i = 1; i < points.size() && std::isnan(load); ++i) {
    const double above = points[i - 1].damping_paper, below = points[i].damping_paper;
    if (!(above >= wanted && below < wanted)) continue;
    load = cases[i - 1].load + (above - wanted) / (above - below) * (cases[i].load - cases[i - 1].load);
    there = measure({{.aspect_ratio = aspect_ratio, .load = load}}, in.jobs)[0].damping_paper;
  }
  return {there, {load, points[0].damping_modes, 100 * (points[0].damping_modes / wanted - 1)}};
}

std::vector<Measured> slopes(const ValidationInput& in) {
  return {slope(in, 8, "paper-fig7-slope-8"), slope(in, 10, "paper-fig7-slope-10")};
}

std::vector<Measured> loads(const ValidationInput& in) {
  const DampingPoints ten = measure({{.load = load_of_shear_modulus(0.001, 10)},
                                     {.load = load_of_shear_modulus(0.008, 10)},
                                     {.load = load_of_shear_modulus(0.02, 10)}},
                                    in.jobs);
  const DampingPoints eight = measure({{.aspect_ratio = 8, .load = load_of_shear_modulus(0.02, 8)}}, in.jobs);
  const auto fall = [](double from, double to) { return 100 * (1 - to / from); };
  const double far_ten = fall(ten[0].damping_modes, ten[2].damping),
               far_eight = fall(eight[0].damping_modes, eight[0].damping);
  return {{fall(ten[0].damping, ten[1].damping), {fall(ten[0].damping_paper, ten[1].damping_paper)}},
          {far_ten, {far_ten, ten[2].asked.load, far_eight, eight[0].asked.load}}};
}

std::vector<Measured> modulus(const ValidationInput& in) {
  std::vector<DampingCase> cases;
  for (const double force : {0.002, 0.0005}) {
    for (const double modulus : {0.2e6, 2e6}) {
      cases.push_back({.load = load_of_shear_modulus(force, 10, modulus), .youngs_modulus = 2.6 * modulus});
    }
  }
  const DampingPoints p = measure(cases, in.jobs);
  const auto rise = [](const DampingPoint& soft, const DampingPoint& stiff) {
    return 100 * (stiff.damping / soft.damping - 1);
  };
  return {{rise(p[0], p[1]), {rise(p[0], p[1]), rise(p[2], p[3])}}};
}

std::vector<Measured> equation_20_values(const ValidationInput&) {
  const double chain_30 = reference::first_bending_mode(linear_chain_of({.aspect_ratio = 30})).damping;
  const double ratio = equation_20(30, 1) / chain_30;
  return {{equation_20(8, 1)}, {equation_20(10, 1)}, {ratio, {chain_30, 1 / ratio}}};
}

double worst_closed_form() {
  double worst = 0;
  for (int aspect_ratio = 5; aspect_ratio <= 60; ++aspect_ratio) {
    for (const double nu : {0.0, 0.17, 0.3, 0.49}) {
      const DampingCase asked{.aspect_ratio = aspect_ratio, .poisson_ratio = nu};
      const double modes = reference::first_bending_mode(linear_chain_of(asked)).damping;
      worst = std::max(worst, std::abs(reference::first_bending_damping(aspect_ratio, 1.0) / modes - 1));
    }
  }
  return worst;
}

double worst_march(const ValidationInput& in) {
  std::vector<DampingCase> cases;
  for (const int aspect_ratio : {5, 13, 24}) {
    for (const double damping : {0.01, 0.6, 3.0}) {
      cases.push_back(
          {.aspect_ratio = aspect_ratio, .poisson_ratio = 0.17, .load = 1e-5, .bond_damping = damping});
    }
  }
  double worst = 0;
  for (const DampingPoint& p : measure(cases, in.jobs))
    worst = std::max(worst, std::abs(p.damping / p.damping_modes - 1));
  return worst;
}

/// First axial and twisting mode against sqrt(2) xi_b sin(pi / (4 r_f + 2)).
double worst_rod_mode() {
  const DampingCase asked{.aspect_ratio = 13, .poisson_ratio = 0.17, .bond_damping = 0.7};
  const double exact = std::sqrt(2.0) * 0.7 * std::sin(std::acos(-1.0) / (4 * 13 + 2));
  double worst = 0;
  for (const auto motion : {reference::ChainMotion::axial, reference::ChainMotion::twist}) {
    const auto modes =
        reference::chain_modes(linear_chain_of(asked), motion, reference::ChainEnds::clamped_free);
    worst = std::max(worst, std::abs(modes[0].damping / exact - 1));
  }
  return worst;
}

}  // namespace

const Checks& damping_checks() {
  using In = ValidationInput;
  using Found = std::vector<Measured>;
  static const Checks checks{
      {{"paper-fig7-slope-8", "paper-fig7-slope-10"}, slopes},
      {{"paper-fig8-modulus"}, modulus},
      {{"paper-eq20-8", "paper-eq20-10", "paper-eq20-30"}, equation_20_values},
      {{"march-modes"}, [](const In& in) -> Found { return {{worst_march(in)}}; }},
      {{"closed-form-modes"}, [](const In&) -> Found { return {{worst_closed_form()}}; }},
      {{"amplitude-frequency"},
       [](const In&) -> Found { return {{reference::amplitude_frequency_coefficient()}}; }},
      {{"rod-modes"}, [](const In&) -> Found { return {{worst_rod_mode()}}; }},
      {{"paper-fig8-load", "paper-fig7-load"}, loads}};
  return checks;
}

}  // namespace fiberchain::compare
