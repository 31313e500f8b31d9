#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "dem/chain/rod_shapes.hpp"
#include "dem/files/numbers.hpp"
#include "dem/model/errors.hpp"
#include "dem/scene/read_common.hpp"

// Rods in space: shape at rest, what holds them and what they bear, and how their path is followed.
namespace fiberchain::dem {
namespace {

using V = Vec<double, 3>;

/// Mapping "axes" or "turn" as typed: a rotation.
struct RodTurnKeys {
  V axis{0, 0, 1};
  double angle = 0;  ///< [rad]
};

/// Mapping "shape" as typed.
struct RodShapeKeys {
  std::optional<double> arc;  ///< [rad], or
  std::optional<int> corner;  ///< sphere, or
  std::vector<V> points;      ///< [m]
  RodTurnKeys turn;
};

/// An entry of list "supports" as typed.
struct RodSupportKeys : RodSupport {
  std::string word;
  RodTurnKeys turn;
};

/// A load as typed, in SI units and over those of the rod.
struct RodLoadKeys {
  std::string word;
  V force{}, moment{}, reduced_force{}, reduced_moment{};
  LoadDirection direction = LoadDirection::dead;
  bool steady = false;
};

/// Mapping "path" as typed.
struct RodPathKeys : RodPathOptions {
  RodPathKeys() {}  // no aggregate: GCC 12 sees the function of one used before it is made, which is not so
  std::string word = "last";
};

int rod_sphere(const StrictMapping& mapping, const char* key, const std::string& word, int bonds) {
  if (word == "first") return 0;
  if (word == "last") return bonds;
  const auto number = parse_integer(word);
  if (!number || *number < 0 || *number > bonds) {
    mapping.fail(
        key, fmt::format("'{}' is not allowed; allowed: first, last or a sphere of 0 to {}", word, bonds));
  }
  return static_cast<int>(*number);
}

std::pair<int, int> rod_spheres(const StrictMapping& mapping, const std::string& word, int bonds) {
  const std::size_t dots = word.find("..");
  if (word == "all") return {0, bonds};
  if (dots != std::string::npos) {
    const auto from = parse_integer(word.substr(0, dots)), to = parse_integer(word.substr(dots + 2));
    if (from && to && *from >= 0 && *from < *to && *to <= bonds) {
      return {static_cast<int>(*from), static_cast<int>(*to)};
    }
  }
  mapping.fail(
      "spheres",
      fmt::format("'{}' is not allowed; allowed: all, or N..M of the spheres 0 to {}, N < M", word, bonds));
}

KeyTable<RodTurnKeys> rod_turn_keys() {
  KeyTable<RodTurnKeys> table;
  table.direction("axis", &RodTurnKeys::axis, "axis of the turn");
  table.quantity("angle", "rad", &RodTurnKeys::angle, kFinite, "angle of the turn").required();
  return table;
}

Quaternion<double> turn_of(const RodTurnKeys& keys) { return rotation(keys.angle * keys.axis); }

struct RodPlaceKeys {
  V at{};
};

KeyTable<RodShapeKeys> rod_shape_keys() {
  KeyTable<RodShapeKeys> table;
  table.quantity("arc", "rad", &RodShapeKeys::arc, kFinite,
                 "an arc from x toward y that turns by this angle from end to end");
  table.integer("corner", &RodShapeKeys::corner, {.low = 1, .high = 1e6},
                "straight along x up to the sphere of this number, along y from there: rigidly joined");
  KeyTable<RodPlaceKeys> point;
  point.vector("at", "m", &RodPlaceKeys::at, "where the point is").required();
  table
      .list(
          "points", point,
          [](const StrictMapping&, const RodPlaceKeys& keys, RodShapeKeys& shape) {
            shape.points.push_back(keys.at);
          },
          "straight members from point to point, rigidly joined: every one a whole number of bonds long, all "
          "together `fiber.aspect_ratio`")
      .otherwise("none");
  table.one_of({"arc", "corner", "points"}, "straight along x from the origin");
  table
      .mapping_into("turn", &RodShapeKeys::turn, rod_turn_keys(),
                    "the rod at rest is turned so about the origin")
      .otherwise("none");
  return table;
}

Chain<3> chain_of(const RodShapeKeys& keys, Fiber fiber) {
  const Quaternion<double> turn = turn_of(keys.turn);
  if (keys.arc) fiber.rest_angle = *keys.arc / fiber.aspect_ratio;
  Chain<3> chain = keys.arc              ? arc_rod(fiber)
                   : keys.corner         ? cornered_chain<3>(fiber, *keys.corner)
                   : keys.points.empty() ? straight_chain<3>(fiber)
                                         : rod_through(fiber, keys.points);
  return placed(std::move(chain), turn, {});
}

void store_shape(const StrictMapping& mapping, const RodShapeKeys& keys, RodScene& scene) {
  if (scene.fiber.aspect_ratio > most_rod_bonds) return;  // is told below
  try {
    scene.problem.chain = chain_of(keys, scene.fiber);
  } catch (const InvalidInput& error) {
    mapping.fail(keys.arc              ? "arc"
                 : keys.corner         ? "corner"
                 : keys.points.empty() ? ""
                                       : "points",
                 error.what());
  }
  scene.fiber = scene.problem.chain.fiber;
}

KeyTable<RodSupportKeys> rod_support_keys() {
  KeyTable<RodSupportKeys> table;
  table.word("sphere", &RodSupportKeys::word, "`first`, `last` or a number", "the sphere that is held")
      .required();
  table.choice("place", &RodSupportKeys::hold_displacement, axis_words(),
               "along which axes its place is held");
  table.choice(
      "turn", &RodSupportKeys::hold_rotation, axis_words(),
      "about which axes its turns are held: all of a clamp; two of a hinge about the third; one of a "
      "universal joint, its outer axis the next of x, y, z, x; none of a ball");
  table
      .mapping_into("axes", &RodSupportKeys::turn, rod_turn_keys(),
                    "the support's axes x, y, z are the global ones turned so")
      .otherwise("the global ones");
  table.vector("move", "m", &RodSupportKeys::moved,
               "its held place goes so far while the load factor goes from 0 to 1");
  table.vector("rotate", "rad", &RodSupportKeys::turned,
               "a clamp turns by this rotation vector while the load factor goes from 0 to 1");
  return table;
}

void store_support(const StrictMapping& mapping, const RodSupportKeys& keys, RodScene& scene) {
  RodSupport support = keys;
  support.sphere = rod_sphere(mapping, "sphere", keys.word, scene.fiber.aspect_ratio);
  support.axes = turn_of(keys.turn);
  scene.problem.supports.push_back(support);
}

void declare_load_course(KeyTable<RodLoadKeys>& table, const std::string& axes) {
  table.choice("direction", &RodLoadKeys::direction,
               words_of({LoadDirection::dead, LoadDirection::following}),
               "whether it keeps its direction in space or turns with the rod: then in axes of " + axes +
                   ", x along the rod");
  table.flag("steady", &RodLoadKeys::steady,
             "it acts in full from load factor 0 on, not times the load factor");
}

KeyTable<RodLoadKeys> rod_load_keys() {
  KeyTable<RodLoadKeys> table;
  table.word("sphere", &RodLoadKeys::word, "`first`, `last` or a number", "the sphere that bears it")
      .required();
  table.vector("force", "N", &RodLoadKeys::force, "force");
  table.vector("moment", "N m", &RodLoadKeys::moment, "moment, about axes fixed in space where dead");
  table.vector("reduced_force", "1", &RodLoadKeys::reduced_force, "F L^2 / (E I), adds to `force`");
  table.vector("reduced_moment", "1", &RodLoadKeys::reduced_moment, "M L / (E I), adds to `moment`");
  table.one_or_more_of({"force", "moment", "reduced_force", "reduced_moment"});
  declare_load_course(table, "its sphere");
  return table;
}

KeyTable<RodLoadKeys> rod_line_load_keys() {
  KeyTable<RodLoadKeys> table;
  table.word("spheres", &RodLoadKeys::word, "`all` or `N..M`", "the part of the rod that bears it")
      .required();
  table.vector("force", "N/m", &RodLoadKeys::force, "force per length of the rod");
  table.vector("reduced_force", "1", &RodLoadKeys::reduced_force, "w L^3 / (E I), adds to `force`");
  table.one_or_more_of({"force", "reduced_force"});
  declare_load_course(table, "the bonds' ends");
  return table;
}

void store_rod_load(const StrictMapping& mapping, const RodLoadKeys& keys, RodScene& scene) {
  const double unit = load_force(scene.fiber, 1), L = fiber_length(scene.fiber);
  scene.problem.point_loads.push_back(
      {.sphere = rod_sphere(mapping, "sphere", keys.word, scene.fiber.aspect_ratio),
       .force = keys.force + unit * keys.reduced_force,
       .moment = keys.moment + (unit * L) * keys.reduced_moment,
       .direction = keys.direction,
       .steady = keys.steady});
}

void store_line_load(const StrictMapping& mapping, const RodLoadKeys& keys, RodScene& scene) {
  const double unit = load_force(scene.fiber, 1) / fiber_length(scene.fiber);
  const auto [first, last] = rod_spheres(mapping, keys.word, scene.fiber.aspect_ratio);
  scene.problem.line_loads.push_back({.first = first,
                                      .last = last,
                                      .force = keys.force + unit * keys.reduced_force,
                                      .direction = keys.direction,
                                      .steady = keys.steady});
}

KeyTable<RodPathKeys> rod_path_keys() {
  KeyTable<RodPathKeys> table;
  table.choice("control", &RodPathKeys::control,
               words_of({RodControl::load, RodControl::displacement, RodControl::arc_length}),
               "what leads: the load factor, a displacement, or the arc length through limit points");
  table.integer("points", &RodPathKeys::points, {.low = 1, .high = 1e5}, "about so many steps to the end");
  table.integer("most_points", &RodPathKeys::most_points, {.low = 1, .high = 1e6},
                "path points after which a path led by the arc length stops");
  table.number("end_factor", &RodPathKeys::end_factor, {.low = -1e9, .high = 1e9},
               "load factor where the path ends, not 0");
  table
      .quantity(
          "end_displacement", "m", &RodPathKeys::end_displacement, kFinite,
          "displacement of the probe where the path ends; led by the arc length, the first point beyond it")
      .otherwise("none");
  KeyTable<RodPathKeys> probe;
  probe.word("sphere", &RodPathKeys::word, "`first`, `last` or a number", "sphere of the probe");
  probe.direction(
      "direction", [](RodPathKeys & keys) -> auto& { return keys.probe.direction; },
      "direction of its displacement that counts");
  table.mapping_into("probe", std::identity{}, probe, "a displacement that is recorded, and may lead or end");
  table
      .number(
          "largest_step", &RodPathKeys::largest_step, {.low = 0, .high = 1e6},
          "of the arc length: the root mean square over spheres of displacement / L and rotation, and the "
          "load factor")
      .otherwise("four times the first");
  table.number("tolerance", &RodPathKeys::tolerance, {.low = 1e-15, .high = 1e-3},
               "Newton step, displacement / L and rotation, after which one more is taken");
  table.flag("singular_points", &RodPathKeys::find_singular, "limit points and bifurcations are looked for");
  return table;
}

void store_path(const StrictMapping& mapping, const RodPathKeys& keys, RodScene& scene) {
  scene.path = keys;
  scene.path.probe.sphere = rod_sphere(mapping, "probe", keys.word, scene.fiber.aspect_ratio);
  if (keys.end_factor == 0) mapping.fail("end_factor", "must not be 0");
  if (keys.control == RodControl::displacement && keys.end_displacement == 0) {
    mapping.fail("end_displacement", "must not be 0 where the displacement leads");
  }
}

KeyTable<RodBranch> rod_branch_keys() {
  KeyTable<RodBranch> table;
  table.integer("bifurcation", &RodBranch::bifurcation, {.low = 1, .high = 1e6},
                "number of the bifurcation along the path, from 1");
  table.choice("side", &RodBranch::sign, Words<int>{{"plus", 1}, {"minus", -1}},
               "the way of the mode, which points to +y, or against it");
  table.number("amplitude", &RodBranch::amplitude, kFraction,
               "largest of the mode's displacements / L and rotations at the first point of the branch");
  return table;
}

RodScene rod_defaults() {
  RodScene scene;
  scene.path.probe.direction = {0, 1, 0};
  return scene;
}

KeyTable<RodScene> rod_keys() {
  KeyTable<RodScene> table(rod_defaults());
  table.known("scene", "rod",
              "a fiber of any shape, held and loaded in any way, along its path of equilibria");
  declare_single_fiber(table, {}, [](const BondKeys&, RodScene&) {});
  table.mapping("shape", rod_shape_keys(), &store_shape, "the rod at rest");
  table.list("supports", rod_support_keys(), &store_support, "what holds it").required();
  table.list("loads", rod_load_keys(), &store_rod_load, "forces and moments on spheres").otherwise("none");
  table.list("line_loads", rod_line_load_keys(), &store_line_load, "forces per length").otherwise("none");
  table.choice(
      "line_load_rule", [](RodScene & scene) -> auto& { return scene.problem.line_load_rule; },
      words_of({LineLoads::lumped, LineLoads::consistent}),
      "how forces per length reach the spheres: half a bond's on each of its two, second order in 1 / r_f; "
      "or "
      "with the end moments w l^2 / 12, fourth order with the corrected bond");
  table.vector(
      "gravity", "m/s^2", [](RodScene & scene) -> auto& { return scene.problem.gravity; },
      "acceleration of gravity: the rod's weight, which acts in full from load factor 0 on");
  KeyTable<RodPathKeys> path = rod_path_keys();
  table.mapping("path", path, &store_path, "how the equilibria are followed");
  table
      .mapping(
          "branch", rod_branch_keys(),
          [](const StrictMapping&, const RodBranch& keys, RodScene& scene) { scene.branch = keys; },
          "a bifurcation of the path whose other branch is followed too, by the arc length")
      .otherwise("none");
  table.integer("shapes", &RodScene::shapes, {.low = 0, .high = 1e6},
                "points of the path whose shape is recorded, besides singular ones");
  return table;
}

}  // namespace

std::vector<KeyDeclaration> rod_declarations() { return rod_keys().declarations(); }

RodScene read_rod(const StrictMapping& top) {
  RodScene scene = rod_keys().read_strictly(top);
  if (!scene.fiber.branches.empty())
    top.fail_within("material_damping", "is not built for a rod's equilibria");
  if (scene.fiber.aspect_ratio > most_rod_bonds) {
    top.fail_within("fiber.aspect_ratio", fmt::format("gives {} bonds: a rod has at most {}",
                                                      scene.fiber.aspect_ratio, most_rod_bonds));
  }
  if (scene.problem.chain.poses.empty()) scene.problem.chain = straight_chain<3>(scene.fiber);
  scene.problem.planar = scene.dimension == Dimension::planar;
  try {
    check(scene.problem);
  } catch (const InvalidInput& error) {
    top.fail("supports", error.what());
  }
  if (scene.branch && !scene.path.find_singular)
    top.fail("branch", "is of use only with path.singular_points");
  return scene;
}

}  // namespace fiberchain::dem
