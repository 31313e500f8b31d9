#include <algorithm>
#include <cmath>
#include <limits>

#include "dem/model/errors.hpp"
#include "dem/scene/read_common.hpp"

namespace fiberchain::dem {
namespace {

const std::vector<std::string> kAxes = {"x", "y", "z"};

Vec<double, 3> vector_of(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

Vec<double, 3> unit_vector(const StrictMapping& section, const char* key) {
  const auto v = read_direction(section, key, Dimension::spatial);
  return {v[0], v[1], v[2]};
}

Wall wall_across(int axis, double place, double into) {
  Plane plane{};
  plane.point[axis] = place;
  plane.normal[axis] = into;
  return {plane};
}

/// Walls at 0 and the length of every side given; no wall at the top of an open box.
void read_box(const StrictMapping& walls, PackingScene& scene) {
  const StrictMapping box = walls.section("box", {"x", "y", "z", "lid"});
  const bool open = box.has("lid") && box.choice("lid", {"closed", "open"}) == 1;
  for (int a = 0; a < 3; ++a) {
    const std::string& axis = kAxes[static_cast<std::size_t>(a)];
    const bool floor_alone = a == 2 && open;
    if (scene.domain.period[a] > 0) {
      if (box.has(axis)) box.fail(axis, "has no walls: this side is periodic");
      continue;
    }
    if (!floor_alone || box.has(axis)) scene.room.high[a] = box.quantity(axis, "m", kPositive);
    scene.domain.walls.push_back(wall_across(a, 0, 1));
    if (!floor_alone) scene.domain.walls.push_back(wall_across(a, scene.room.high[a], -1));
  }
}

void read_motion_of(const StrictMapping& section, Wall& wall) {
  if (section.has("velocity")) wall.velocity = vector_of(section.quantities("velocity", "m/s", 3));
  if (section.has("from")) wall.from = section.quantity("from", "s", kFinite);
  if (section.has("until")) wall.until = section.quantity("until", "s", kFinite);
  if (!(wall.from < wall.until)) section.fail("until", "must be later than from");
}

void check_even(const StrictMapping& section, const char* key, const Wall& wall, const Vec<double, 3>& period) {
  for (int a = 0; a < 3; ++a) {
    if (period[a] > 0 && !is_invariant_along(wall, a)) section.fail(key, "must leave the wall the same all along " + kAxes[static_cast<std::size_t>(a)] + ", which is periodic");
  }
}

void read_walls(const StrictMapping& top, PackingScene& scene) {
  const StrictMapping walls =
      top.section("walls", {"youngs_modulus", "poisson_ratio", "box", "planes", "cylinders"});
  Domain& around = scene.domain;
  if (walls.has("youngs_modulus"))
    around.wall_youngs_modulus = walls.quantity("youngs_modulus", "Pa", kPositive);
  if (walls.has("poisson_ratio")) {
    if (!walls.has("youngs_modulus")) walls.fail("poisson_ratio", "is of use only with youngs_modulus");
    around.wall_poisson_ratio = walls.number("poisson_ratio", {.low = -1, .high = 0.5, .low_open = true});
  }
  if (walls.has("box")) read_box(walls, scene);
  if (walls.has("planes")) {
    for (const StrictMapping& s : walls.sections("planes", {"point", "normal", "velocity", "from", "until"})) {
      Wall wall{Plane{vector_of(s.quantities("point", "m", 3)), unit_vector(s, "normal")}};
      read_motion_of(s, wall);
      check_even(s, "normal", wall, around.period);
      around.walls.push_back(wall);
    }
  }
  if (walls.has("cylinders")) {
    for (const StrictMapping& s :
         walls.sections("cylinders", {"point", "axis", "radius", "velocity", "from", "until"})) {
      Wall wall{Cylinder{vector_of(s.quantities("point", "m", 3)), unit_vector(s, "axis"),
                         s.quantity("radius", "m", kPositive)}};
      read_motion_of(s, wall);
      check_even(s, "axis", wall, around.period);
      around.walls.push_back(wall);
    }
  }
}

void read_periods(const StrictMapping& top, PackingScene& scene) {
  const StrictMapping periodic = top.section("periodic", kAxes);
  for (int a = 0; a < 3; ++a) {
    const std::string& axis = kAxes[static_cast<std::size_t>(a)];
    if (!periodic.has(axis)) continue;
    scene.room.high[a] = scene.domain.period[a] = periodic.quantity(axis, "m", kPositive);
  }
}

/// As in a flow scene; without a flow it is at rest.
Fluid read_packing_fluid(const StrictMapping& top) {
  const StrictMapping fluid = top.section(
      "fluid", {"viscosity", "flow", "rate", "gradient", "course", "hydrodynamics", "compressible"});
  if (!fluid.has("flow") && !fluid.has("gradient")) {
    for (const char* key : {"rate", "course", "compressible"}) {
      if (fluid.has(key))
        fluid.fail(key, "is of use only with flow or gradient; without, the fluid is at rest");
    }
    return {fluid.quantity("viscosity", "Pa s", kPositive), {}};
  }
  FlowScene flow{};
  flow.dimension = Dimension::spatial;
  read_fluid(top, flow);
  if (flow.fluid.hydrodynamics != Hydrodynamics::free_draining) {
    fluid.fail("hydrodynamics",
               "interactions and stresslets are not built for packings; allowed: free_draining");
  }
  return flow.fluid;
}

ContactProperties read_contacts(const StrictMapping& top) {
  const StrictMapping contacts = top.section("contacts", {"restitution", "friction", "rolling_friction"});
  ContactProperties rules;
  if (contacts.has("restitution")) {
    rules.restitution = contacts.number("restitution", {.low = 0, .high = 1, .low_open = true});
  }
  if (contacts.has("friction")) rules.friction = contacts.number("friction", kNonNegative);
  if (contacts.has("rolling_friction"))
    rules.rolling_friction = contacts.number("rolling_friction", kNonNegative);
  return rules;
}

/// Place of the wall across this axis that looks up it from below, if there is one.
double floor_below(const std::vector<Wall>& walls, int axis, double place) {
  for (const Wall& wall : walls) {
    const auto* plane = wall.shape.get_if<Plane>();
    if (plane && plane->normal[axis] == 1 && plane->point[axis] < place) return plane->point[axis];
  }
  return place;
}

}  // namespace

void read_domain(const StrictMapping& top, PackingScene& scene) {
  if (top.has("periodic")) read_periods(top, scene);
  if (top.has("walls")) read_walls(top, scene);
  if (top.has("gravity")) scene.domain.gravity = vector_of(top.quantities("gravity", "m/s^2", 3));
  if (top.has("fluid")) scene.domain.fluid = read_packing_fluid(top);
  if (top.has("contacts")) scene.domain.contacts = read_contacts(top);
}

void complete_domain(PackingScene& scene) {
  const Box& region = scene.filling.region;
  const bool filled = region.high[0] > region.low[0];
  for (int a = 0; a < 3; ++a) {
    double &low = scene.room.low[a], &high = scene.room.high[a];
    const double period = scene.domain.period[a];
    if (period > 0 && filled) low = region.low[a], high = low + period;
    if (high > low) continue;
    low = filled ? region.low[a] : std::numeric_limits<double>::infinity();
    high = filled ? region.high[a] : -low;
    for (const FiberKind& kind : scene.kinds) {
      const double reach = fiber_length(kind.fiber) + sphere_radius(kind.fiber);
      for (const FiberStart& start : kind.starts) {
        low = std::min(low, start.position[a] - reach);
        high = std::max(high, start.position[a] + reach);
      }
    }
    low = floor_below(scene.domain.walls, a, low);
  }
}

}  // namespace fiberchain::dem
