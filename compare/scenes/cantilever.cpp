#include "compare/scenes/cantilever.hpp"

#include <array>
#include <chrono>
#include <cmath>

#include "dem/run/run_fiber.hpp"

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
CantileverRest rest_in(const CantileverScene& scene) {
  const dem::RestState<Dim> rest = dem::find_rest<Dim>(scene);
  return {.spheres = stations<Dim>(scene, rest.poses),
          .residual = rest.residual.moment,
          .stability = rest.stability,
          .iterations = rest.iterations,
          .steps = rest.steps,
          .run_time = 0};
}

}  // namespace

CantileverRest rest_of(const CantileverScene& scene) {
  const auto begin = std::chrono::steady_clock::now();
  CantileverRest rest = scene.dimension == dem::Dimension::planar ? rest_in<2>(scene) : rest_in<3>(scene);
  rest.run_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return rest;
}

}  // namespace fiberchain::compare
