#include "dem/scene/build_fiber.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "dem/chain/self_weight.hpp"
#include "dem/equilibrium/newton.hpp"

namespace fiberchain::dem {
namespace {

/// A dead load P at the free end, from P L^2 / (E I).
template <int Dim>
Load<Dim> end_load(const Fiber& fiber, double load, const std::array<double, 3>& direction) {
  Load<Dim> end{fiber.aspect_ratio, {}, {}};
  const double force = load_force(fiber, load);
  for (int i = 0; i < Dim; ++i) end.force[i] = force * direction[static_cast<std::size_t>(i)];
  return end;
}

/// Slope of the start's curve at xi from -1 to 1 along the fiber: a (1 - xi^2) + b (5 xi^3 - 3 xi)/2 over the
/// length 2.
double slope(const FlowStart& start, double xi) {
  return 2 * (-2 * start.bend * xi + start.s_bend * (7.5 * xi * xi - 1.5));
}

template <int Dim>
Vec<double, Dim> line_at(const FlowStart& start, double angle) {
  Vec<double, Dim> axis;
  for (int i = 0; i < Dim; ++i) {
    axis[i] = std::cos(angle) * start.direction[i] + std::sin(angle) * start.bend_direction[i];
  }
  return axis;
}

double orientation(const FlowStart& start, const Vec<double, 2>&, double angle) {
  const std::array<double, 3>& p = start.direction;
  const std::array<double, 3>& n = start.bend_direction;
  return std::atan2(p[1], p[0]) + std::copysign(1.0, p[0] * n[1] - p[1] * n[0]) * angle;
}

/// The x axis turned into the fiber's line (by way of -x where that is nearer), then by the slope.
Quaternion<double> orientation(const FlowStart& start, const Vec<double, 3>&, double angle) {
  const Vec<double, 3> p{start.direction[0], start.direction[1], start.direction[2]},
      n{start.bend_direction[0], start.bend_direction[1], start.bend_direction[2]},
      x{std::copysign(1.0, p[0]), 0, 0};
  const Quaternion<double> first = p[0] < 0 ? Quaternion<double>{0, {0, 0, 1}} : Quaternion<double>{1, {}};
  const auto line = normalized(Quaternion<double>{1 + std::abs(p[0]), cross(x, p)}) * first;
  return rotation(angle * cross(p, n)) * line;
}

}  // namespace

template <int Dim>
CantileverCase<Dim> build_cantilever(const CantileverScene& scene) {
  Boundary<Dim> boundary{{0}, {end_load<Dim>(scene.fiber, scene.load, scene.direction)}};
  Vec<double, Dim> gravity{};
  for (int c = 0; c < Dim; ++c) gravity[c] = scene.gravity[static_cast<std::size_t>(c)];
  if (norm(gravity) > 0)
    std::ranges::copy(self_weight(scene.fiber, gravity), std::back_inserter(boundary.loads));
  return {straight_chain<Dim>(scene.fiber), boundary};
}

bool has_energy(const ReleaseScene& scene) {
  const Integrator integrator = scene.motion.integrator;
  return !is_leapfrog(integrator) || scene.fiber.rolling_friction == 0;
}

template <int Dim>
Release<Dim> build_release(const ReleaseScene& scene, double period) {
  Release<Dim> release{straight_chain<Dim>(scene.fiber), {}, {}, {}, period, scene.periods};
  const Boundary<Dim> pulled{{0}, {end_load<Dim>(scene.fiber, scene.pull.load, scene.pull.direction)}};
  release.start = solve_equilibrium(release.chain, pulled).poses;
  return release;
}

template <int Dim>
Poses<Dim> start_poses(const Fiber& fiber, const FlowStart& start) {
  const int bonds = fiber.aspect_ratio;
  const auto xi = [&](double i) { return 2 * i / bonds - 1; };
  Poses<Dim> poses;
  Vec<double, Dim> place{}, sum{};
  for (int i = 0; i <= bonds; ++i) {
    if (i > 0) place = place + bond_length(fiber) * line_at<Dim>(start, slope(start, xi(i - 0.5)));
    poses.push_back({place, orientation(start, place, slope(start, xi(i)))});
    sum = sum + place;
  }
  for (auto& pose : poses) pose.position = pose.position - (1.0 / (bonds + 1)) * sum;
  return poses;
}

template <int Dim>
FlowCase<Dim> build_flow(const FlowScene& scene) {
  return {straight_chain<Dim>(scene.fiber), start_poses<Dim>(scene.fiber, scene.start), scene.fluid, {}};
}

std::vector<double> even_times(double duration, int intervals) {
  std::vector<double> times;
  for (int i = 0; i <= intervals; ++i) times.push_back(duration * i / intervals);
  return times;
}

template CantileverCase<2> build_cantilever<2>(const CantileverScene&);
template CantileverCase<3> build_cantilever<3>(const CantileverScene&);
template Release<2> build_release<2>(const ReleaseScene&, double);
template Release<3> build_release<3>(const ReleaseScene&, double);
template Poses<2> start_poses<2>(const Fiber&, const FlowStart&);
template Poses<3> start_poses<3>(const Fiber&, const FlowStart&);
template FlowCase<2> build_flow<2>(const FlowScene&);
template FlowCase<3> build_flow<3>(const FlowScene&);

}  // namespace fiberchain::dem
