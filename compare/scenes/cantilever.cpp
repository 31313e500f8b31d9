#include "compare/scenes/cantilever.hpp"

#include <array>
#include <chrono>
#include <cmath>

#include "dem/equilibrium/dynamic_relaxation.hpp"
#include "dem/equilibrium/newton.hpp"

namespace fiberchain::compare {
namespace {

using dem::CantileverScene;
using Direction = std::array<double, 3>;

/// Unit vectors of the stations' y and z: along the load's part across the fiber, and across both.
struct Across {
  Direction y = {0, 1, 0};
  Direction z = {0, 0, 1};
};

Across across(const Direction& load) {
  const double part = std::hypot(load[1], load[2]);
  if (part == 0) return {};
  const double cosine = load[1] / part;
  const double sine = load[2] / part;
  return {{0, cosine, sine}, {0, -sine, cosine}};
}

template <int Dim>
double along(const dem::Vec<double, Dim>& vector, const Direction& direction) {
  double sum = 0;
  for (int i = 0; i < Dim; ++i) sum += vector[i] * direction[static_cast<std::size_t>(i)];
  return sum;
}

template <int Dim>
dem::Boundary<Dim> boundary(const CantileverScene& scene) {
  dem::Load<Dim> load{};
  load.sphere = scene.fiber.aspect_ratio;
  for (int i = 0; i < Dim; ++i) {
    load.force[i] = dem::load_force(scene.fiber, scene.load) * scene.direction[static_cast<std::size_t>(i)];
  }
  return {.clamped = {0}, .loads = {load}};
}

/// In the plane the angle counts full turns; in space it is that of the axis.
double angle_of(const dem::Pose<double, 2>& pose, const Across& frame) {
  return frame.y[1] * pose.orientation;
}
double angle_of(const dem::Pose<double, 3>& pose, const Across& frame) {
  const auto axis = dem::axis(pose);
  return std::atan2(along<3>(axis, frame.y), axis[0]);
}

template <int Dim>
std::vector<Station> stations(const CantileverScene& scene, const dem::Poses<Dim>& poses) {
  const Across frame = across(scene.direction);
  const double length = dem::fiber_length(scene.fiber);
  std::vector<Station> all;
  for (const auto& pose : poses) {
    all.push_back({pose.position[0] / length, along<Dim>(pose.position, frame.y) / length,
                   along<Dim>(pose.position, frame.z) / length, angle_of(pose, frame)});
  }
  return all;
}

template <int Dim>
CantileverRest solved(const CantileverScene& scene) {
  const auto chain = dem::straight_chain<Dim>(scene.fiber);
  const auto found = dem::solve_equilibrium<Dim>(chain, boundary<Dim>(scene));
  return {.spheres = stations<Dim>(scene, found.poses),
          .residual = found.residual.moment,
          .iterations = found.statistics.newton_iterations,
          .steps = std::nullopt,
          .run_time = 0};
}

template <int Dim>
CantileverRest marched(const CantileverScene& scene) {
  const dem::RelaxCase<Dim> only{dem::straight_chain<Dim>(scene.fiber), {boundary<Dim>(scene)}};
  const auto found = dem::relax_to_equilibrium<Dim>({only}, scene.march).front();
  return {.spheres = stations<Dim>(scene, found.poses),
          .residual = found.residual.moment,
          .iterations = std::nullopt,
          .steps = std::llround(found.steps),
          .run_time = 0};
}

}  // namespace

CantileverRest rest_of(const CantileverScene& scene) {
  const auto begin = std::chrono::steady_clock::now();
  const bool planar = scene.dimension == dem::Dimension::planar;
  const bool solve = scene.method == dem::Method::solve;
  CantileverRest rest = planar ? (solve ? solved<2>(scene) : marched<2>(scene))
                               : (solve ? solved<3>(scene) : marched<3>(scene));
  rest.run_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return rest;
}

}  // namespace fiberchain::compare
