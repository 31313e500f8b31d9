#include <algorithm>
#include <cmath>
#include <limits>

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

std::vector<Measured> elastica_tips(const ValidationInput&) {
  std::vector<Measured> tips;
  for (const int load : {1, 2, 5, 10}) {
    const TipState tip = reference::elastica_closed_form(load);
    tips.insert(tips.end(), {{tip.y}, {tip.x}});
  }
  return tips;
}

constexpr double rigid = std::numeric_limits<double>::infinity();

std::vector<Measured> reissner_tips(const ValidationInput&) {
  std::vector<Measured> tips;
  for (const int shear : {500, 50, 5}) {
    const TipState tip = reference::reissner_cantilever(10, rigid, shear, 10, 1);
    tips.insert(tips.end(), {{tip.y}, {tip.x}});
  }
  return tips;
}

std::vector<Measured> own_ways(const ValidationInput&) {
  const auto shooting = [](double load) { return reference::elastica_shooting(load); };
  const auto closed = [](double load) { return reference::elastica_closed_form(load); };
  const auto stiff = [](double load) { return reference::reissner_tip(load, rigid, rigid); };
  const auto paper = [](double load) { return reference::elastica_paper(load).tip; };
  return {{worst_difference(shooting, closed, 1e-6, 1e3)},
          {worst_difference(paper, closed, 1e-2, 10)},
          {worst_difference(stiff, closed, 1e-6, 1e3)}};
}

}  // namespace

const Checks& beam_checks() {
  static const Checks checks{
      {{"elastica-y-1", "elastica-x-1", "elastica-y-2", "elastica-x-2", "elastica-y-5", "elastica-x-5",
        "elastica-y-10", "elastica-x-10"},
       elastica_tips},
      {{"reissner-y-500", "reissner-x-500", "reissner-y-50", "reissner-x-50", "reissner-y-5", "reissner-x-5"},
       reissner_tips},
      {{"elastica-shooting-closed-form", "elastica-paper-closed-form", "reissner-rigid-elastica"}, own_ways}};
  return checks;
}

}  // namespace fiberchain::compare
