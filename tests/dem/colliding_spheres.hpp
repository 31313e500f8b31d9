#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "dem/contact/laws/hertz_mindlin.hpp"
#include "dem/contact/restitution.hpp"
#include "dem/math/quaternion.hpp"

// Two spheres, or a sphere and a plane wall, marched by a leapfrog with the contact law of the assemblies:
// velocities at half steps, forces from the positions now and the velocities half a step before.
namespace colliding {

namespace dem = fiberchain::dem;
using V = dem::Vec<double, 3>;

struct Sphere {
  double radius, mass;
  V position{}, velocity{}, spin{};

  double inertia() const { return 0.4 * mass * radius * radius; }
};

struct Elastic {
  double modulus, shear_modulus;  ///< E*, G* of the pair [Pa]
  double damping_ratio, friction;
  double rolling = 0;  ///< mu_r
};

inline dem::HertzMindlin::Parameters<double> parameters(const Elastic& e, double radius, double mass,
                                                        double inertia, double dt) {
  const double kn = 4.0 / 3 * e.modulus * std::sqrt(radius), kt = 8 * e.shear_modulus * std::sqrt(radius);
  return {kn,
          kt,
          2 * e.damping_ratio * std::sqrt(1.25 * mass * kn),
          2 * e.damping_ratio * std::sqrt(5.0 / 6 * mass * kt),
          e.friction,
          e.rolling * radius,
          inertia / dt,
          0.5};
}

/// What a pair has lived through.
struct Record {
  dem::HertzMindlin::History<double> history{};
  double overlap = 0;  ///< largest [m]
  int touching = 0;    ///< steps
  int pushing = 0;     ///< steps with a normal force
  bool over = false;
};

/// One step of a pair; loads on the spheres are added to. A wall is `wall`'s half space behind point and
/// normal.
struct PairStep {
  dem::HertzMindlin::Parameters<double> parameters;
  double dt;

  /// Force on the first at arms from both centers to the contact.
  dem::ContactAction<double> act(const Sphere& a, const Sphere* b, const V& normal, double overlap,
                                 double arm_a, double arm_b, Record& record) const {
    dem::TouchingPair<double> pair{};
    pair.normal = normal;
    pair.overlap = overlap;
    const V vb = b ? b->velocity : V{}, wb = b ? b->spin : V{};
    pair.velocity = vb - a.velocity - cross(arm_a * a.spin + arm_b * wb, normal);
    pair.spin = wb - a.spin;
    pair.mean_spin = b ? 0.5 * (a.spin + wb) : a.spin;
    const auto action = dem::HertzMindlin::act(parameters, pair, dt, record.history);
    record.overlap = std::max(record.overlap, overlap);
    ++record.touching;
    if (dot(action.force, normal) < 0) ++record.pushing;
    return action;
  }
};

inline void kick(Sphere& s, const V& force, const V& moment, double dt) {
  s.velocity = s.velocity + (dt / s.mass) * force;
  s.spin = s.spin + (dt / s.inertia()) * moment;
}

/// A step of two spheres.
inline void step(const PairStep& p, Sphere& a, Sphere& b, Record& record) {
  const V r = b.position - a.position;
  const double distance = norm(r), reach = a.radius + b.radius;
  if (distance < reach) {
    const V n = (1 / distance) * r;
    const double arm = a.radius / reach * distance;
    const auto action = p.act(a, &b, n, reach - distance, arm, distance - arm, record);
    const V turn = cross(n, action.force);
    kick(a, action.force, arm * turn + action.moment, p.dt);
    kick(b, -action.force, (distance - arm) * turn - action.moment, p.dt);
  } else {
    record.over = record.touching > 0;
    record.history = {};
  }
  a.position = a.position + p.dt * a.velocity;
  b.position = b.position + p.dt * b.velocity;
}

/// A step of a sphere above the plane through the origin; `up` is its normal, into the room.
inline void step(const PairStep& p, Sphere& a, const V& up, const V& gravity, Record& record) {
  const double distance = dot(a.position, up);
  V force = a.mass * gravity, moment{};
  if (distance < a.radius) {
    const auto action = p.act(a, nullptr, -up, a.radius - distance, distance, 0, record);
    force = force + action.force;
    moment = distance * cross(-up, action.force) + action.moment;
  } else {
    record.over = record.touching > 0;
    record.history = {};
  }
  kick(a, force, moment, p.dt);
  a.position = a.position + p.dt * a.velocity;
}

}  // namespace colliding
