#include "dem/scene/expected_speed.hpp"

#include <algorithm>
#include <cmath>

namespace fiberchain::dem {
namespace {

/// Room, region of filling and starts together.
Box whole_of(const PackingScene& scene) {
  Box all = scene.scene_box;
  const auto include = [&](const Vec<double, 3>& place) {
    for (int a = 0; a < 3; ++a) {
      all.low[a] = std::min(all.low[a], place[a]);
      all.high[a] = std::max(all.high[a], place[a]);
    }
  };
  for (const PackingFiberKind& kind : scene.kinds) {
    if (kind.count > 0) include(scene.filling.region.low), include(scene.filling.region.high);
    for (const FiberStart& start : kind.starts) include(start.position);
  }
  return all;
}

double start_speed(const PackingScene& scene) {
  double fastest = scene.carried_speed;
  for (const PackingFiberKind& kind : scene.kinds) {
    if (kind.count > 0) fastest = std::max(fastest, norm(scene.filling.velocity));
    for (const FiberStart& start : kind.starts) fastest = std::max(fastest, norm(start.velocity));
  }
  return fastest;
}

/// The fastest kind's, m g / (6 pi mu R).
double settling_speed(const PackingScene& scene) {
  double fastest = 0;
  for (const PackingFiberKind& kind : scene.kinds) {
    const double drag = stokes_drag(*scene.domain.fluid, kind.fiber).translation;
    fastest = std::max(fastest, sphere_mass(kind.fiber) * norm(scene.domain.gravity) / drag);
  }
  return fastest;
}

double flow_speed(const PackingScene& scene, const Box& all) {
  const Gradient A = gradient_at(scene.domain.fluid->flow, 0);
  double speed = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Vec<double, 3> place{};
    for (int a = 0; a < 3; ++a) place[a] = (corner >> a & 1) != 0 ? all.high[a] : all.low[a];
    speed = std::max(speed, norm(velocity_at<3>(A, place)));
  }
  return speed;
}

/// Of walls that turn, in the room of fibers that come at random: those that are there already count by
/// themselves (assembly/time_step.cpp).
double wall_speed(const PackingScene& scene, const Box& all) {
  double fastest = 0;
  if (!std::ranges::any_of(scene.kinds, [](const PackingFiberKind& kind) { return kind.count > 0; }))
    return 0;
  for (const Wall& wall : scene.domain.walls) {
    for (int corner = 0; corner < 8; ++corner) {
      Vec<double, 3> place{};
      for (int a = 0; a < 3; ++a) place[a] = (corner >> a & 1) != 0 ? all.high[a] : all.low[a];
      const double reach = distance_from_axis(wall, place);
      fastest = std::max(fastest, largest_speed(wall, reach) - largest_speed(wall, 0));
    }
  }
  return fastest;
}

/// Of what holds spheres.
double held_speed(const PackingScene& scene, const Box& all) {
  double fastest = 0;
  for (const SceneGrip& held : scene.held) {
    for (int corner = 0; corner < 8; ++corner) {
      Vec<double, 3> place{};
      for (int a = 0; a < 3; ++a) place[a] = (corner >> a & 1) != 0 ? all.high[a] : all.low[a];
      fastest = std::max(fastest, largest_speed(held.grip.body, distance_from_axis(held.grip.body, place)));
    }
  }
  return fastest;
}

}  // namespace

double expected_speed(const PackingScene& scene) {
  const Box all = whole_of(scene);
  const Vec<double, 3>& g = scene.domain.gravity;
  const double turning = wall_speed(scene, all);
  double drop = 0;  // gravity times the largest height
  for (int a = 0; a < 3; ++a) drop += std::abs(g[a]) * (all.high[a] - all.low[a]);
  const double start = start_speed(scene);
  double speed = std::sqrt(start * start + 2 * drop);
  if (scene.duration > 0) speed = std::min(speed, start + norm(g) * scene.duration);
  if (!scene.domain.fluid) return speed + turning + held_speed(scene, all);
  return std::max(start, std::min(speed, settling_speed(scene))) + flow_speed(scene, all) + turning;
}

}  // namespace fiberchain::dem
