#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/capstan/capstan.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/validation.hpp"

namespace fiberchain::compare {
namespace {

double error_of(const CapstanPoint& p) { return 100 * (p.ratio / p.expected - 1); }

/// The farthest from the rod, and the largest ripple.
Measured worst_of(const CapstanPoint* first, const CapstanPoint* last) {
  double worst = 0, ripple = 0;
  for (const CapstanPoint* p = first; p != last; ++p) {
    if (std::abs(error_of(*p)) > std::abs(worst)) worst = error_of(*p);
    ripple = std::max(ripple, p->spread);
  }
  return {worst, {first->asked.drum, first->asked.bending, ripple}};
}

/// Smooth fibers on a smooth drum by all turnings at 0.1, then at 0.3; rings of both surfaces.
std::vector<Measured> tensions(const ValidationInput& in) {
  std::vector<CapstanCase> cases = capstan_cases({.surface = {DrumSurface::smooth}, .friction = {0.1, 0.3}});
  const auto rings = capstan_cases(
      {.surface = {DrumSurface::ring, DrumSurface::spheres}, .friction = {0.3}, .turning = {1}});
  cases.insert(cases.end(), rings.begin(), rings.end());
  const auto points = capstan_points(cases, {.jobs = in.jobs});
  for (const CapstanPoint& p : points) {
    if (p.status != "converged") throw InputError("a fiber on a drum: " + p.status);
  }
  const CapstanPoint &longest = points[7], &ring = points[8], &bumpy = points[9];
  return {worst_of(&points[0], &points[4]),
          worst_of(&points[4], &points[8]),
          {longest.ratio / longest.euler, {longest.ratio, longest.euler, longest.expected / longest.euler}},
          {error_of(ring), {ring.spread}},
          {error_of(bumpy), {bumpy.spread}}};
}

}  // namespace

const Checks& capstan_checks() {
  static const Checks checks{{.ids = {"capstan-friction-01", "capstan-friction-03", "capstan-euler",
                                      "capstan-ring", "capstan-spheres"},
                              .measure = tensions,
                              .cost = 45}};
  return checks;
}

}  // namespace fiberchain::compare
