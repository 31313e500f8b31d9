#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "compare/damping/table.hpp"
#include "compare/study/validation.hpp"
#include "reference/damped_elastica.hpp"

namespace fiberchain::compare {
namespace {

using Points = std::vector<DampingPoint>;

Points measure(const std::vector<DampingCase>& cases, int jobs) {
  DampingOptions options;
  options.jobs = jobs;
  options.elastica = false;
  return damping_points(cases, options);
}

/// Load P L^2/(E I) of a force on the nominal fiber.
double load_of(double force, int aspect_ratio, double shear_modulus = 1e6) {
  const DampingCase unit{.aspect_ratio = aspect_ratio, .youngs_modulus = 2.6 * shear_modulus};
  return force / dem::load_force(damped_fiber(unit), 1.0);
}

/// Where fiber_damping_paper passes the paper's slope, by interpolation between loads, and the slope there.
MatrixRow slope_row(const ValidationInput& in, int aspect_ratio, const std::string& id) {
  const double wanted = find_published(in.published, id).value;
  std::vector<DampingCase> cases;
  for (int i = 0; i < 16; ++i) cases.push_back({.aspect_ratio = aspect_ratio, .load = 0.02 + 0.2 * i});
  const Points points = measure(cases, in.jobs);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double above = points[i - 1].damping_paper, below = points[i].damping_paper;
    if (!(above >= wanted && below < wanted)) continue;
    const double load = cases[i - 1].load + (above - wanted) / (above - below) * (cases[i].load - cases[i - 1].load);
    const double there = measure({{.aspect_ratio = aspect_ratio, .load = load}}, in.jobs)[0].damping_paper;
    return published_row(in, id, there, 2e-5,
                         fmt::format("appears at PL^2/EI = {:.2f} with peaks 1..10 after the release; at vanishing load "
                                     "the slope is {:.6f}, {:.1f} % higher", load, points[0].damping_modes,
                                     100 * (points[0].damping_modes / wanted - 1)));
  }
  return published_row(in, id, points[0].damping_modes, 0, "no load up to 3 gives this slope with peaks 1..10");
}

std::vector<MatrixRow> load_rows(const ValidationInput& in) {
  const Points ten = measure({{.load = load_of(0.001, 10)}, {.load = load_of(0.008, 10)}, {.load = load_of(0.02, 10)}}, in.jobs);
  const Points eight = measure({{.aspect_ratio = 8, .load = load_of(0.02, 8)}}, in.jobs);
  const auto fall = [](double from, double to) { return 100 * (1 - to / from); };
  const double far_ten = fall(ten[0].damping_modes, ten[2].damping), far_eight = fall(eight[0].damping_modes, eight[0].damping);
  return {published_row(in, "paper-fig8-load", fall(ten[0].damping, ten[1].damping), 0.5,
                        fmt::format("mode 2 gone, nominal fiber d = 2 mm, G = 1 MPa, nu = 0.3; peaks 1..10 give {:.2f} %",
                                    fall(ten[0].damping_paper, ten[1].damping_paper))),
          disputed_row(in, "paper-fig7-load", far_ten,
                       fmt::format("from vanishing load to P = 0.02 N on the nominal fiber xi_f falls {:.1f} % at r_f = 10 "
                                   "(PL^2/EI = {:.2f}) and {:.1f} % at r_f = 8 ({:.2f}); the paper's own fall of 5 % up to "
                                   "0.008 N is larger than 3.3 %", far_ten, ten[2].asked.load, far_eight,
                                   eight[0].asked.load))};
}

MatrixRow modulus_row(const ValidationInput& in) {
  std::vector<DampingCase> cases;
  for (const double force : {0.002, 0.0005}) {
    for (const double modulus : {0.2e6, 2e6}) {
      cases.push_back({.load = load_of(force, 10, modulus), .youngs_modulus = 2.6 * modulus});
    }
  }
  const Points p = measure(cases, in.jobs);
  const auto rise = [](const DampingPoint& soft, const DampingPoint& stiff) { return 100 * (stiff.damping / soft.damping - 1); };
  return disputed_row(in, "paper-fig8-modulus", rise(p[0], p[1]),
                      fmt::format("xi_f depends on G only through PL^2/EI: from 0.2 to 2 MPa it rises {:.2f} % at P = 0.002 N "
                                  "and {:.2f} % at 0.0005 N; constant above 0.2 MPa holds for small loads only",
                                  rise(p[0], p[1]), rise(p[2], p[3])));
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
      cases.push_back({.aspect_ratio = aspect_ratio, .poisson_ratio = 0.17, .load = 1e-5, .bond_damping = damping});
    }
  }
  double worst = 0;
  for (const DampingPoint& p : measure(cases, in.jobs)) worst = std::max(worst, std::abs(p.damping / p.damping_modes - 1));
  return worst;
}

/// First axial and twisting mode against sqrt(2) xi_b sin(pi / (4 r_f + 2)).
double worst_rod_mode() {
  const DampingCase asked{.aspect_ratio = 13, .poisson_ratio = 0.17, .bond_damping = 0.7};
  const double exact = std::sqrt(2.0) * 0.7 * std::sin(std::acos(-1.0) / (4 * 13 + 2));
  double worst = 0;
  for (const auto motion : {reference::ChainMotion::axial, reference::ChainMotion::twist}) {
    const auto modes = reference::chain_modes(linear_chain_of(asked), motion, reference::ChainEnds::clamped_free);
    worst = std::max(worst, std::abs(modes[0].damping / exact - 1));
  }
  return worst;
}

}  // namespace

std::vector<MatrixRow> damping_rows(const ValidationInput& in) {
  const double chain_30 = reference::first_bending_mode(linear_chain_of({.aspect_ratio = 30})).damping;
  const double ratio = equation_20(30, 1) / chain_30;
  std::vector<MatrixRow> rows{
      slope_row(in, 8, "paper-fig7-slope-8"),
      slope_row(in, 10, "paper-fig7-slope-10"),
      modulus_row(in),
      published_row(in, "paper-eq20-8", equation_20(8, 1), 5e-6, "a = 0.03709, b = 0.1615"),
      published_row(in, "paper-eq20-10", equation_20(10, 1), 5e-6, "a = 0.03709, b = 0.1615"),
      disputed_row(in, "paper-eq20-30", ratio,
                   fmt::format("the chain follows a power law, xi_f = {:.6f} xi_b at r_f = 30 (linear modes); Eq 20 is an "
                               "exponential fitted over a short range and is {:.1f} times too low there", chain_30, 1 / ratio)),
      method_row("march-modes", "damped vibration", 0, worst_march(in), 2e-4,
                 "quadratic eigenproblem of the linear chain",
                 "largest relative difference of xi_f, r_f = 5, 13, 24, xi_b = 0.01 to 3, nu = 0.17, PL^2/EI = 1e-5"),
      method_row("closed-form-modes", "damped vibration", 0, worst_closed_form(), 0.0025,
                 "(beta_1^2/sqrt(20)) xi_b/(r_f + 1/2)^2 against the quadratic eigenproblem",
                 "largest relative difference, r_f = 5 to 60, nu = 0 to 0.49, xi_b = 1"),
      method_row("amplitude-frequency", "damped Elastica", 0.0194, reference::amplitude_frequency_coefficient(), 5e-5,
                 "undamped amplitude-frequency relation omega/omega_0 = 1 + c (a/L)^2",
                 "c by averaging over a period; the damped Elastica's runs are tested against it"),
      exact_row("rod-modes", "damped vibration", 0, worst_rod_mode(), 1e-10, "sqrt(2) xi_b sin(pi/(4 r_f + 2))",
                "first axial and twisting mode of the linear chain, r_f = 13, nu = 0.17, xi_b = 0.7")};
  for (MatrixRow& row : load_rows(in)) rows.push_back(std::move(row));
  return rows;
}

}  // namespace fiberchain::compare
