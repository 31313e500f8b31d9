#include "dem/equilibrium/rod_singular.hpp"

#include <algorithm>
#include <cmath>

namespace fiberchain::dem {
namespace {

/// Bounds closer than this part of the path's step hold one singular point, however often it counts.
constexpr double least_interval = 1e-6;
constexpr int most_refinements = 60;

struct Bound {
  double step;
  RodStation station;
};

struct Search {
  const RodContext& context;
  const RodStation& from;
  double step;
  RodPath& path;
};

int crossing(const Bound& a, const Bound& b) { return b.station.point.negative - a.station.point.negative; }

bool factor_turns(const Bound& a, const Bound& b) {
  return (a.station.tangent.factor < 0) != (b.station.tangent.factor < 0);
}

std::optional<Bound> bound_at(const Search& search, double step) {
  auto station = station_after(search.context, search.from, step, search.path.newton_iterations);
  if (!station) return std::nullopt;
  return Bound{step, std::move(*station)};
}

/// Where a line through two values is zero, if that lies between the bounds; their middle otherwise.
double next_step(double a, double value_a, double b, double value_b) {
  const double guess = a - value_a * (b - a) / (value_b - value_a);
  const double low = std::min(a, b), high = std::max(a, b), margin = 1e-3 * (high - low);
  return guess > low + margin && guess < high - margin ? guess : 0.5 * (a + b);
}

/// The eigenvalue nearest to zero goes through it between the bounds a and b. Equilibria closer to the
/// singular one than rounding tells apart are not asked for: the line through the last two values ends it.
void refine(const Search& search, Bound a, Bound b, bool turns) {
  const RodContext& context = search.context;
  const double near = std::max(1e-6, 1e3 * zero_eigenvalue(context.problem.chain));
  const int change = crossing(a, b);
  NearestMode mode_a = nearest_mode(context, a.station.state),
              mode_b = nearest_mode(context, b.station.state);
  SingularPoint found{.kind = turns ? SingularKind::limit_point : SingularKind::bifurcation,
                      .after = static_cast<int>(search.path.points.size()) - 1,
                      .crossing = change};
  for (int n = 0; n < most_refinements; ++n) {
    if (std::abs(b.step - a.step) < context.options.singular_tolerance * std::abs(search.step)) break;
    if (std::min(std::abs(mode_a.eigenvalue), std::abs(mode_b.eigenvalue)) < near) break;
    const bool opposite = (mode_a.eigenvalue < 0) != (mode_b.eigenvalue < 0);
    const double middle = 0.5 * (a.step + b.step);
    const double step =
        opposite && n % 3 != 2 ? next_step(a.step, mode_a.eigenvalue, b.step, mode_b.eigenvalue) : middle;
    auto c = bound_at(search, step);
    if (!c) break;
    const bool below = change != 0 ? crossing(a, *c) == 0 : !factor_turns(a, *c);
    (below ? mode_a : mode_b) = nearest_mode(context, c->station.state);
    (below ? a : b) = std::move(*c);
  }
  const bool first = std::abs(mode_a.eigenvalue) < std::abs(mode_b.eigenvalue);
  const Bound &best = first ? a : b, &other = first ? b : a;
  NearestMode &mode = first ? mode_a : mode_b, &mode_other = first ? mode_b : mode_a;
  found.point = best.station.point;
  const double part = mode.eigenvalue / (mode.eigenvalue - mode_other.eigenvalue);
  if (part > 0 && part < 1) {
    found.point.factor += part * (other.station.point.factor - best.station.point.factor);
    found.point.arc += part * (other.station.point.arc - best.station.point.arc);
  }
  found.mode = std::move(mode.mode);
  search.path.singular.push_back(std::move(found));
}

void search_between(const Search& search, const Bound& a, const Bound& b) {
  const int change = crossing(a, b);
  const bool turns = factor_turns(a, b);
  if (change == 0 && !turns) return;
  const bool alone =
      std::abs(change) == 1 || std::abs(b.step - a.step) < least_interval * std::abs(search.step);
  if (!alone) {
    if (auto middle = bound_at(search, 0.5 * (a.step + b.step))) {
      search_between(search, a, *middle);
      search_between(search, *middle, b);
      return;
    }
  }
  refine(search, a, b, turns);
}

}  // namespace

void find_singular_points(const RodContext& context, const RodStation& from, const RodStation& to,
                          double step, RodPath& path) {
  search_between({context, from, step, path}, {0, from}, {step, to});
}

}  // namespace fiberchain::dem
