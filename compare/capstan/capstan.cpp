#include "compare/capstan/capstan.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "compare/measure/stop_motion.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/stopping.hpp"
#include "dem/model/errors.hpp"
#include "reference/capstan.hpp"

namespace fiberchain::compare {
namespace {

using std::numbers::pi;

/// F/F_0 of the reference.
double expected_ratio(const CapstanCase& asked) {
  const WoundFiber sizes = wound_fiber(asked);
  const double cosine = std::cos(sizes.pitch_angle);
  const reference::Capstan capstan{.friction = asked.friction,
                                   .turning = asked.turning,
                                   .radius = sizes.axis_radius / (cosine * cosine),
                                   .rod_radius = dem::sphere_radius(sizes.fiber),
                                   .bending_stiffness = dem::bending_stiffness(sizes.fiber)};
  return reference::drawn_over(capstan, sizes.held_force).force / sizes.held_force;
}

/// Mean of the tensions of the bonds nearest to an end.
struct EndTensions {
  double held, drawn;
};
EndTensions end_tensions(const dem::Assembly& assembly) {
  constexpr int near = 4;
  const auto bonds = assembly.bonds(0, 0);
  EndTensions ends{};
  for (int i = 0; i < near; ++i) {
    ends.held += norm(bonds[static_cast<std::size_t>(i)].force) / near;
    ends.drawn += norm(bonds[bonds.size() - 1 - static_cast<std::size_t>(i)].force) / near;
  }
  return ends;
}

/// Whenever the motion has passed its largest energy it is stopped; contacts keep their springs.
void come_to_rest(dem::Assembly& assembly, std::int64_t steps, std::int64_t every) {
  double last = 0;
  for (std::int64_t done = 0; done < steps; done += every) {
    assembly.march(every);
    last = stop_past_peak(assembly, last);
  }
}

void measure(const CapstanCase& asked, CapstanPoint& point) {
  const WoundFiber sizes = wound_fiber(asked);
  dem::Assembly assembly = drum_assembly(asked);
  const auto steps_of = [&](double ways) {  // of sound along the fiber
    return static_cast<std::int64_t>(std::ceil(ways * sizes.sound_time / assembly.step()));
  };
  come_to_rest(assembly, steps_of(asked.settling), steps_of(0.05));
  constexpr int samples = 400;
  // of spheres, so that more than one goes over all places between two others
  const double ways =
      asked.surface == DrumSurface::spheres ? 8 * sizes.fiber.diameter / (sizes.speed * sizes.sound_time) : 4;
  const std::int64_t every = std::max<std::int64_t>(1, steps_of(ways) / samples);
  std::vector<double> ratios;
  for (int n = 0; n < samples; ++n) {
    assembly.march(every);
    const EndTensions ends = end_tensions(assembly);
    ratios.push_back(ends.drawn / ends.held);
  }
  point.ratio = point.spread = 0;
  for (const double ratio : ratios) point.ratio += ratio / samples;
  for (const double ratio : ratios) point.spread = std::max(point.spread, std::abs(ratio / point.ratio - 1));
  point.contacts = static_cast<int>(assembly.touching());
}

}  // namespace

std::string_view name(DrumSurface surface) {
  switch (surface) {
    case DrumSurface::smooth:
      return "smooth";
    case DrumSurface::wall:
      return "wall";
    case DrumSurface::ring:
      return "ring";
    case DrumSurface::spheres:
      return "spheres";
  }
  throw InputError("no such surface of a drum");
}

std::vector<CapstanCase> capstan_cases(const CapstanSweep& sweep) {
  std::vector<CapstanCase> all;
  for (const DrumSurface surface : sweep.surface)
    for (const double drum : sweep.drum)
      for (const double bending : sweep.bending)
        for (const double spacing : sweep.spacing)
          for (const double friction : sweep.friction)
            for (const double turning : sweep.turning) {
              const bool ring = surface == DrumSurface::ring || surface == DrumSurface::spheres,
                         smooth = surface == DrumSurface::smooth || surface == DrumSurface::ring;
              if ((!smooth && spacing != 1) || (ring && turning > 1)) continue;
              CapstanCase one{surface, friction, turning * pi, drum, bending, spacing};
              if (surface == DrumSurface::spheres) one.speed /= 5;  // bumps pass slower than the fiber swings
              all.push_back(one);
            }
  if (all.empty())
    throw InputError(
        "--surface is not allowed: on rings fibers turn by pi at most, only smooth ones have another "
        "--spacing "
        "than 1");
  return all;
}

CapstanPoint capstan_point(const CapstanCase& asked) {
  const auto clock = std::chrono::steady_clock::now();
  CapstanPoint point{.asked = asked,
                     .ratio = nan,
                     .spread = nan,
                     .euler = reference::euler_eytelwein(asked.friction, asked.turning),
                     .expected = expected_ratio(asked),
                     .contacts = 0,
                     .run_time = 0};
  try {
    measure(asked, point);
  } catch (const dem::Diverged& error) {
    point.status = error.what();
  }
  point.run_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count();
  return point;
}

std::vector<CapstanPoint> capstan_points(const std::vector<CapstanCase>& cases,
                                         const CapstanOptions& options) {
  std::vector<CapstanPoint> points;
  std::vector<double> costs;
  for (const CapstanCase& asked : cases) {
    points.push_back({asked, nan, nan, nan, nan, 0, 0, std::string(not_begun)});
    const WoundFiber sizes = wound_fiber(asked);
    const double bodies = sizes.fiber.aspect_ratio * (asked.surface == DrumSurface::spheres ? 8 : 1);
    costs.push_back(bodies * sizes.fiber.aspect_ratio * asked.settling);
  }
  options.jobs.run_dearest_first(costs, [&](std::size_t i) {
    if (options.stopped()) return;
    points[i] = capstan_point(cases[i]);
    options.advance();
  });
  return points;
}

}  // namespace fiberchain::compare
