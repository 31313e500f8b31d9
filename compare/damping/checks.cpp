#include <algorithm>
#include <cmath>

#include "compare/damping/case.hpp"
#include "compare/damping/paper_checks.hpp"
#include "compare/study/validation.hpp"
#include "reference/damped_elastica.hpp"

namespace fiberchain::compare {
namespace {

DampingPoints measure(const std::vector<DampingCase>& cases, const Jobs& jobs) {
  DampingOptions options;
  options.jobs = jobs;
  options.elastica = false;
  return damping_points(cases, options);
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
  const Checks own{{{"march-modes"}, [](const In& in) -> Found { return {{worst_march(in)}}; }},
                   {{"closed-form-modes"}, [](const In&) -> Found { return {{worst_closed_form()}}; }},
                   {{"amplitude-frequency"},
                    [](const In&) -> Found { return {{reference::amplitude_frequency_coefficient()}}; }},
                   {{"rod-modes"}, [](const In&) -> Found { return {{worst_rod_mode()}}; }}};
  static const Checks checks = merged(paper_damping_checks(), own);
  return checks;
}

}  // namespace fiberchain::compare
