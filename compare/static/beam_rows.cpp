#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "compare/static/tip.hpp"
#include "compare/study/validation.hpp"
#include "reference/elastica.hpp"
#include "reference/reissner.hpp"

namespace fiberchain::compare {
namespace {

using reference::TipState;

double largest(const TipState& a) { return std::max({std::abs(a.y), std::abs(a.x), std::abs(a.angle)}); }

/// Largest difference of two ways over loads 1e-6 to 1e3, evenly spaced in the logarithm.
template <class Way, class Other>
double worst_difference(const Way& way, const Other& other, double from, double to) {
  double worst = 0;
  constexpr int n = 60;
  for (int i = 0; i <= n; ++i) {
    const double load = from * std::pow(to / from, static_cast<double>(i) / n);
    worst = std::max(worst, largest(way(load) - other(load)));
  }
  return worst;
}

}  // namespace

std::vector<MatrixRow> beam_rows(const ValidationInput& input) {
  std::vector<MatrixRow> rows;
  for (const int load : {1, 2, 5, 10}) {
    const TipState tip = reference::elastica_closed_form(load);
    rows.push_back(published_row(input, fmt::format("elastica-y-{}", load), tip.y, 5e-6, "closed form"));
    rows.push_back(published_row(input, fmt::format("elastica-x-{}", load), tip.x, 5e-6, "closed form"));
  }
  constexpr double rigid = std::numeric_limits<double>::infinity();
  for (const int shear : {500, 50, 5}) {
    const TipState tip = reference::reissner_cantilever(10, rigid, shear, 10, 1);
    rows.push_back(published_row(input, fmt::format("reissner-y-{}", shear), tip.y, 5e-10, "shooting"));
    rows.push_back(published_row(input, fmt::format("reissner-x-{}", shear), tip.x, 5e-10, "shooting"));
  }
  const auto shooting = [](double load) { return reference::elastica_shooting(load); };
  const auto closed = [](double load) { return reference::elastica_closed_form(load); };
  const auto stiff = [](double load) { return reference::reissner_tip(load, rigid, rigid); };
  const auto paper = [](double load) { return reference::elastica_paper(load).tip; };
  rows.push_back(method_row("elastica-shooting-closed-form", "Elastica", 0, worst_difference(shooting, closed, 1e-6, 1e3),
                            1e-10, "elliptic integrals against an initial-value integration",
                            "largest difference in y/L, x/L and angle, PL^2/EI from 1e-6 to 1e3"));
  rows.push_back(method_row("elastica-paper-closed-form", "Elastica", 0, worst_difference(paper, closed, 1e-2, 10), 1e-6,
                            "the paper's bisection with Simpson's rule (Eqs 13-15), its integrand made regular",
                            "largest difference in y/L, x/L and angle, 200 panels, PL^2/EI from 0.01 to 10"));
  rows.push_back(method_row("reissner-rigid-elastica", "Reissner beam", 0, worst_difference(stiff, closed, 1e-6, 1e3),
                            1e-10, "Reissner's beam without shear and stretch is the Elastica",
                            "largest difference in y/L, x/L and angle, PL^2/EI from 1e-6 to 1e3"));
  return rows;
}

}  // namespace fiberchain::compare
