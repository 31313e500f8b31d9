#include "compare/capstan/drum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "compare/study/errors.hpp"

namespace fiberchain::compare {
namespace {

using V = dem::Vec<double, 3>;
using std::numbers::pi;

constexpr double kTurnsApart = 1.5;  ///< diameters between the axes of two turns

/// A line that comes to a helix about the z axis, goes along it and leaves it, by the way along it from where
/// it meets the helix [m]; turned so that it leaves along x.
struct Winding {
  double radius, pitch_angle, length;  ///< of the helix [m], [rad], [m]

  V turned(const V& v) const {
    const double c = std::cos(pitch_angle), s = std::sin(pitch_angle);
    return {c * v[0] + s * v[2], v[1], c * v[2] - s * v[0]};
  }
  V tangent(double way) const {
    const double c = std::cos(pitch_angle), angle = angle_at(std::clamp(way, 0.0, length));
    return turned({c * std::cos(angle), c * std::sin(angle), std::sin(pitch_angle)});
  }
  V place(double way) const {
    const double on = std::clamp(way, 0.0, length), angle = angle_at(on);
    const V at{radius * std::sin(angle), -radius * std::cos(angle), radius * angle * std::tan(pitch_angle)};
    return turned(at) + (way - on) * tangent(on);
  }
  V axis() const { return turned({0, 0, 1}); }

 private:
  /// About the drum, 0 where it leaves.
  double angle_at(double on) const { return (on - length) * std::cos(pitch_angle) / radius; }
};

/// Opposite ones by half a turn about z, across which they lie.
dem::Quaternion<double> shortest_turn(const V& from, const V& to) {
  const V across = cross(from, to);
  const double sine = norm(across), cosine = dot(from, to);
  if (sine > 1e-12) return dem::rotation((std::atan2(sine, cosine) / sine) * across);
  return cosine > 0 ? dem::Quaternion<double>{1, {}} : dem::Quaternion<double>{0, {0, 0, 1}};
}

/// Spheres along the line without twist, stretched by a thread's tension so that little is left to settle.
dem::ChainState<3> along(const Winding& line, const dem::Chain<3>& chain, const CapstanCase& asked,
                         const WoundFiber& sizes, double before) {
  dem::ChainState<3> state = dem::at_rest<3>(chain.poses);
  const double strain = sizes.held_force / dem::axial_stiffness(chain.fiber),
               growth = asked.friction * asked.turning / line.length, l = dem::bond_length(chain.fiber);
  V last{1, 0, 0};
  dem::Quaternion<double> turn{1, {}};
  double way = -before;
  for (auto& pose : state.poses) {
    const V next = line.tangent(way);
    turn = normalized(shortest_turn(last, next) * turn);
    last = next;
    pose = {line.place(way), turn};
    way += l * (1 + strain * std::exp(growth * std::clamp(way, 0.0, line.length)));
  }
  return state;
}

bool is_ring(const CapstanCase& asked) {
  return asked.surface == DrumSurface::ring || asked.surface == DrumSurface::spheres;
}

bool is_smooth(const CapstanCase& asked) {
  return asked.surface == DrumSurface::smooth || asked.surface == DrumSurface::ring;
}

/// A thick fiber of one bond along the drum's axis.
dem::FiberGroup thick_drum(const WoundFiber& sizes, const Winding& line, double height) {
  dem::Fiber fiber = sizes.fiber;
  fiber.diameter = 2 * sizes.drum_radius, fiber.aspect_ratio = 1, fiber.spacing = height / fiber.diameter;
  dem::FiberGroup group{dem::straight_chain<3>(fiber), {}};
  group.chain.smooth = true;
  const V middle = line.place(line.length / 2), axis = line.axis();
  dem::ChainState<3> state = dem::at_rest<3>(group.chain.poses);
  for (int i = 0; i < 2; ++i) {
    state.poses[i].position = (dot(middle, axis) + (i - 0.5) * height) * axis;
    state.poses[i].orientation = shortest_turn({1, 0, 0}, axis);
  }
  group.fibers = {state};
  return group;
}

/// The fiber itself as a ring that almost closes, its outer side on the drum's surface.
dem::FiberGroup ring_drum(const CapstanCase& asked, const WoundFiber& sizes) {
  dem::Fiber fiber = sizes.fiber;
  const double radius = sizes.drum_radius - dem::sphere_radius(fiber),
               angle = 2 * std::asin(dem::bond_length(fiber) / (2 * radius));
  fiber.aspect_ratio = static_cast<int>(std::floor(2 * pi / angle)) - 1;
  dem::FiberGroup group{dem::straight_chain<3>(fiber), {}};
  group.chain.smooth = is_smooth(asked);
  dem::ChainState<3> state = dem::at_rest<3>(group.chain.poses);
  for (int i = 0; i <= fiber.aspect_ratio; ++i)
    state.poses[i] = {{radius * std::cos(i * angle), radius * std::sin(i * angle), 0},
                      dem::rotation(V{0, 0, i * angle + pi / 2})};
  group.fibers = {state};
  return group;
}

std::vector<dem::SphereAddress> spheres_of_fiber(int group, int bonds) {
  std::vector<dem::SphereAddress> all;
  for (int i = 0; i <= bonds; ++i) all.push_back({group, 0, i});
  return all;
}

double length_on(const CapstanCase& asked, const WoundFiber& sizes) {
  const double c = std::cos(sizes.pitch_angle);
  return asked.turning * sizes.axis_radius / (c * c);  // curvature c^2 / rho
}

/// Beyond which bending at an end is gone: of this, exp(-4).
double tail_of(const CapstanCase& asked, const WoundFiber& sizes) {
  return 4 * std::sqrt(asked.bending) * sizes.axis_radius + 4 * sizes.fiber.diameter;
}

}  // namespace

WoundFiber wound_fiber(const CapstanCase& asked) {
  if (!is_smooth(asked) && asked.spacing != 1)
    throw InputError("only smooth fibers have bonds of another length than they are thick");
  if (is_ring(asked) && asked.turning > 1.01 * pi)
    throw InputError("a fiber goes around a ring by half a turn at most");
  WoundFiber sizes{};
  dem::Fiber& fiber = sizes.fiber;
  fiber = {dem::isotropic_material(2.6e7, 0.17, 1130), 1.66e-3, 1};
  fiber.bond_model = dem::BondModel::corrected, fiber.mass = dem::MassModel::cylinder;
  fiber.bond_damping = 0.3, fiber.spacing = asked.spacing;
  const double r = dem::sphere_radius(fiber), R = asked.drum * r;
  sizes.drum_radius = R;
  sizes.axis_radius = R + r;
  if (asked.turning > 1.01 * pi)
    sizes.pitch_angle = std::atan(kTurnsApart * fiber.diameter / (2 * pi * sizes.axis_radius));
  const double rho = sizes.axis_radius / std::pow(std::cos(sizes.pitch_angle), 2);
  sizes.held_force = dem::bending_stiffness(fiber) / (asked.bending * rho * rho);
  sizes.speed = asked.speed * std::sqrt(fiber.material.youngs_modulus / fiber.material.density);
  const double part = sizes.held_force / dem::axial_stiffness(fiber), l = dem::bond_length(fiber);
  const double whole = length_on(asked, sizes) + 2 * tail_of(asked, sizes);
  fiber.aspect_ratio = static_cast<int>(std::ceil(whole / ((1 + part) * l)));
  sizes.sound_time = fiber.aspect_ratio * l * asked.speed / sizes.speed;
  return sizes;
}

dem::Assembly drum_assembly(const CapstanCase& asked) {
  const WoundFiber sizes = wound_fiber(asked);
  const Winding line{sizes.axis_radius, sizes.pitch_angle, length_on(asked, sizes)};
  dem::Chain<3> chain = dem::straight_chain<3>(sizes.fiber);
  chain.smooth = is_smooth(asked);
  std::vector<dem::FiberGroup> groups{{chain, {along(line, chain, asked, sizes, tail_of(asked, sizes))}}};
  dem::Domain around;
  around.contacts = {.restitution = 0.3,
                     .friction = asked.friction,
                     .youngs_modulus = 0.2 * sizes.fiber.material.youngs_modulus};
  around.wall_youngs_modulus = around.contacts.youngs_modulus.value();
  around.wall_poisson_ratio = 0.17;
  dem::Grip hold, fast, drum, plane;
  hold.force = -sizes.held_force * line.tangent(0), hold.spheres = {{0, 0, 0}};
  fast.place = {true, false, false}, fast.spheres = {{0, 0, sizes.fiber.aspect_ratio}};
  const dem::WallMotion turning{.about = dem::WallAxis{{}, line.axis()},
                                .angular_velocity = -sizes.speed / sizes.drum_radius};
  drum.place = drum.turn = {true, true, true}, drum.body.motion = turning;
  std::vector<dem::Grip> grips{hold, fast};
  if (asked.surface == DrumSurface::wall) {
    around.walls = {{.shape = dem::Cylinder{{}, line.axis(), sizes.drum_radius, -1}, .motion = turning}};
  } else {
    const double wound = line.length * std::sin(sizes.pitch_angle);
    groups.push_back(is_ring(asked) ? ring_drum(asked, sizes)
                                    : thick_drum(sizes, line, wound + 20 * sizes.fiber.diameter));
    drum.spheres = spheres_of_fiber(1, groups[1].chain.fiber.aspect_ratio);
    grips.push_back(drum);
  }
  if (is_ring(asked)) {
    grips[1].place[2] = true;
    plane.place = {false, false, true}, plane.spheres = spheres_of_fiber(0, sizes.fiber.aspect_ratio - 1);
    grips.push_back(plane);
  }
  return {std::move(groups), around, {.form = dem::BondForm::total, .speed = sizes.speed, .grips = grips}};
}

}  // namespace fiberchain::compare
