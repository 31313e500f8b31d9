#pragma once

#include <cmath>
#include <vector>

#include "dem/flow/leapfrog_in_flow.hpp"

/// Fibers in flows, for tests of the march with inertia.
namespace flowing {

namespace dem = fiberchain::dem;

/// Viscosity whose drag has 6 pi mu R = rate m.
inline double viscosity_of(const dem::Fiber& fiber, double rate) {
  return rate * dem::sphere_mass(fiber) / dem::stokes_drag({1, {}}, fiber).translation;
}

inline dem::Fiber fiber_of(int bonds, double damping = 0, double youngs_modulus = 3.7e5) {
  return {dem::isotropic_material(youngs_modulus, 0.17, 431.0), 0.0262, bonds, dem::BondModel::paper,
          damping};
}

/// Straight through the origin at its middle, at an angle from x in the plane and, in space, out of it.
template <int Dim>
dem::Poses<Dim> inclined(const dem::Fiber& fiber, double angle, double out_of_plane = 0) {
  dem::Poses<Dim> poses;
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    const double s = (i - 0.5 * fiber.aspect_ratio) * dem::bond_length(fiber);
    if constexpr (Dim == 2) {
      poses.push_back({{s * std::cos(angle), s * std::sin(angle)}, angle});
    } else {
      const auto turn = dem::rotation(dem::Vec<double, 3>{0, 0, angle}) *
                        dem::rotation(dem::Vec<double, 3>{0, -out_of_plane, 0});
      poses.push_back({dem::rotate(turn, dem::Vec<double, 3>{s, 0, 0}), turn});
    }
  }
  return poses;
}

/// An unstrained straight fiber with no load.
template <int Dim>
dem::FlowCase<Dim> straight_case(const dem::Fiber& fiber, const dem::Fluid& fluid, double angle,
                                 double out_of_plane = 0) {
  return {dem::straight_chain<Dim>(fiber), inclined<Dim>(fiber, angle, out_of_plane), fluid, {}};
}

inline std::vector<double> equal_times(double end, int count) {
  std::vector<double> times;
  for (int i = 1; i <= count; ++i) times.push_back(end * i / count);
  return times;
}

template <int Dim>
struct Path {
  dem::FlowRecord record;
  std::vector<double> times;
  std::vector<dem::ChainState<Dim>> states;
};

template <int Dim>
Path<Dim> path(const dem::FlowCase<Dim>& flow, const std::vector<double>& times,
               const dem::FlowOptions& options = {}) {
  Path<Dim> path;
  path.record =
      dem::leapfrog_in_flow<Dim>(flow, times, options, [&](double time, const dem::ChainState<Dim>& state) {
        path.times.push_back(time);
        path.states.push_back(state);
      });
  return path;
}

/// The state at the end of a path.
template <int Dim>
dem::ChainState<Dim> end_state(const dem::FlowCase<Dim>& flow, const std::vector<double>& times,
                               const dem::FlowOptions& options = {}) {
  return path(flow, times, options).states.back();
}

/// Largest distance of the spheres over the fiber's length.
template <int Dim>
double distance(const dem::ChainState<Dim>& a, const dem::ChainState<Dim>& b, const dem::Fiber& fiber) {
  double largest = 0;
  for (std::size_t i = 0; i < a.poses.size(); ++i) {
    largest = std::max(largest, dem::norm(a.poses[i].position - b.poses[i].position));
  }
  return largest / dem::fiber_length(fiber);
}

/// Order that an error shows when the step is halved.
inline double order_of(double coarse, double fine) { return std::log2(coarse / fine); }

}  // namespace flowing
