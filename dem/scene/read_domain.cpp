#include <algorithm>
#include <limits>
#include <optional>

#include "dem/contact/contact_law.hpp"
#include "dem/scene/build_packing.hpp"
#include "dem/scene/read_common.hpp"

namespace fiberchain::dem {
namespace {

/// Mapping "periodic" as typed: lengths of its sides [m].
using PeriodKeys = std::array<std::optional<double>, 3>;

KeyTable<PeriodKeys> period_keys() {
  KeyTable<PeriodKeys> table;
  for (int a = 0; a < 3; ++a) {
    table
        .quantity(
            kAxes[a], "m", [a](PeriodKeys & sides) -> auto& { return sides[a]; }, kPositive,
            std::string("length of the periodic cell along ") + kAxes[a])
        .otherwise("not periodic");
  }
  return table;
}

void store_periods(const StrictMapping&, const PeriodKeys& sides, PackingScene& scene) {
  for (int a = 0; a < 3; ++a) {
    if (sides[a]) scene.scene_box.high[a] = scene.domain.period[a] = *sides[a];
  }
}

void store_fluid(const StrictMapping& mapping, const FluidKeys& keys, PackingScene& scene) {
  scene.domain.fluid = fluid_of(mapping, keys, Dimension::spatial).fluid;
}

/// What the spheres of files take along an axis.
struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  double lowest_center = low;
};

Extent extent_of_starts(const PackingScene& scene, int axis) {
  Extent extent;
  for (const PackingFiberKind& kind : scene.kinds) {
    const Chain<3> chain = chain_of(kind);
    const double radius = sphere_radius(kind.fiber);
    for (const FiberStart& start : kind.starts) {
      for (const auto& pose : placed(chain, start).poses) {
        const double center = pose.position[axis];
        extent.low = std::min(extent.low, center - radius);
        extent.high = std::max(extent.high, center + radius);
        extent.lowest_center = std::min(extent.lowest_center, center);
      }
    }
  }
  return extent;
}

/// Position of the wall across this axis on which spheres come to lie: of those below them the highest one
/// that stays; else the highest at the start.
std::optional<double> floor_below(const std::vector<Wall>& walls, int axis, double spheres) {
  std::optional<double> at_start, stays;
  for (const Wall& wall : walls) {
    const auto* plane = wall.shape.get_if<Plane>();
    if (!plane || plane->normal[axis] != 1 || plane->point[axis] > spheres) continue;
    const double position = plane->point[axis];
    if (wall.active_from <= 0) at_start = std::max(at_start.value_or(position), position);
    const bool for_good = wall.active_until == std::numeric_limits<double>::infinity() && is_at_rest(wall);
    if (for_good) stays = std::max(stays.value_or(position), position);
  }
  return stays ? stays : at_start;
}

}  // namespace

void declare_domain(KeyTable<PackingScene>& table) {
  const auto gravity = [](PackingScene & scene) -> auto& { return scene.domain.gravity; };
  table
      .mapping("periodic", period_keys(), &store_periods,
               "periodic sides; walls must be the same all along them")
      .otherwise("none");
  declare_walls(table);
  table.vector("gravity", "m/s^2", gravity, "acceleration of gravity");
  table
      .mapping("fluid", fluid_keys({Hydrodynamics::free_draining}, true), &store_fluid,
               "a fluid around the fibers")
      .otherwise("none");
  declare_contacts(table);
}

void complete_scene_box(PackingScene& scene) {
  const Box& region = scene.filling.region;
  const bool filled = region.high[0] > region.low[0];
  for (int a = 0; a < 3; ++a) {
    double &low = scene.scene_box.low[a], &high = scene.scene_box.high[a];
    const double period = scene.domain.period[a];
    if (period > 0 && filled) low = region.low[a], high = low + period;
    if (high > low) continue;
    Extent extent = extent_of_starts(scene, a);
    if (filled) {
      extent.low = std::min(extent.low, region.low[a]);
      extent.high = std::max(extent.high, region.high[a]);
      extent.lowest_center = std::min(extent.lowest_center, region.low[a]);
    }
    low = floor_below(scene.domain.walls, a, extent.lowest_center).value_or(extent.low);
    high = extent.high;
  }
}

}  // namespace fiberchain::dem
