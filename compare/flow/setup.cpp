#include "compare/flow/setup.hpp"

#include <cmath>
#include <numbers>

#include "compare/static/case.hpp"

namespace fiberchain::compare {
namespace {

using Triple = std::array<double, 3>;

double hydrodynamic_length(const dem::Fiber& fiber) { return fiber.diameter * (fiber.aspect_ratio + 1); }

/// Slope of the start's curve at xi from -1 to 1 along the fiber: a (1 - xi^2) + b (5 xi^3 - 3 xi)/2 over the
/// length 2.
double slope(const dem::FlowStart& start, double xi) {
  return 2 * (-2 * start.bend * xi + start.s_bend * (7.5 * xi * xi - 1.5));
}

template <int Dim>
dem::Vec<double, Dim> turned(const dem::FlowStart& start, double angle) {
  dem::Vec<double, Dim> axis;
  for (int i = 0; i < Dim; ++i) {
    axis[i] = std::cos(angle) * start.direction[i] + std::sin(angle) * start.bend_direction[i];
  }
  return axis;
}

double orientation(const dem::FlowStart& start, const dem::Vec<double, 2>&, double angle) {
  const Triple& p = start.direction;
  const Triple& n = start.bend_direction;
  return std::atan2(p[1], p[0]) + std::copysign(1.0, p[0] * n[1] - p[1] * n[0]) * angle;
}

/// The x axis turned into the fiber's line (by way of -x where that is nearer), then by the slope.
dem::Quaternion<double> orientation(const dem::FlowStart& start, const dem::Vec<double, 3>&,
                                    double angle) {
  const dem::Vec<double, 3> p{start.direction[0], start.direction[1], start.direction[2]},
      n{start.bend_direction[0], start.bend_direction[1], start.bend_direction[2]},
      x{std::copysign(1.0, p[0]), 0, 0};
  const dem::Quaternion<double> first =
      p[0] < 0 ? dem::Quaternion<double>{0, {0, 0, 1}} : dem::Quaternion<double>{1, {}};
  const auto line = dem::normalized(dem::Quaternion<double>{1 + std::abs(p[0]), dem::cross(x, p)}) * first;
  return dem::rotation(angle * dem::cross(p, n)) * line;
}

}  // namespace

dem::Fiber fiber_of_spheres(int spheres, double poisson_ratio) {
  const dem::Fiber fiber = nominal_fiber(spheres - 1, poisson_ratio, dem::BondModel::paper);
  dem::check(fiber);
  return fiber;
}

double elasto_viscous_number(const dem::Fiber& fiber, double viscosity, double rate) {
  return 3 * std::numbers::pi * viscosity * rate * std::pow(hydrodynamic_length(fiber), 4) /
         dem::bending_stiffness(fiber);
}

double viscosity_of(const dem::Fiber& fiber, double elasto_viscous, double rate) {
  return elasto_viscous / elasto_viscous_number(fiber, 1.0, rate);
}

template <int Dim>
dem::Poses<Dim> start_poses(const dem::Fiber& fiber, const dem::FlowStart& start) {
  const int bonds = fiber.aspect_ratio;
  const auto xi = [&](double i) { return 2 * i / bonds - 1; };
  dem::Poses<Dim> poses;
  dem::Vec<double, Dim> place{}, sum{};
  for (int i = 0; i <= bonds; ++i) {
    if (i > 0) place = place + dem::bond_length(fiber) * turned<Dim>(start, slope(start, xi(i - 0.5)));
    poses.push_back({place, orientation(start, place, slope(start, xi(i)))});
    sum = sum + place;
  }
  for (auto& pose : poses) pose.position = pose.position - (1.0 / (bonds + 1)) * sum;
  return poses;
}

template dem::Poses<2> start_poses<2>(const dem::Fiber&, const dem::FlowStart&);
template dem::Poses<3> start_poses<3>(const dem::Fiber&, const dem::FlowStart&);

}  // namespace fiberchain::compare
