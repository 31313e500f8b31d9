#include "reference/planar_contact.hpp"

#include <algorithm>
#include <cmath>

namespace fiberchain::reference::detail {
namespace {

using S = PlanarState;

double sign(ContactMode mode) {
  return mode == ContactMode::sticks ? 0 : mode == ContactMode::slides_forward ? 1 : -1;
}

ContactMode sliding(double direction) {
  return direction < 0 ? ContactMode::slides_backward : ContactMode::slides_forward;
}

}  // namespace

/// What a state amounts to at the contact.
struct PlanarContact::AtContact {
  std::array<double, 2> normal;
  double distance, overlap;
  double quarter;                  ///< overlap^(1/4)
  double normal_velocity, across;  ///< relative velocity of the centers along normal and tangent
  double spin;                     ///< of both bodies, by their shares
  double slip, normal_force;
  double turning;  ///< rate of the normal's angle

  double along_normal(double u, double v) const { return u * normal[0] + v * normal[1]; }
  double along_tangent(double u, double v) const { return v * normal[0] - u * normal[1]; }
};

PlanarContact::AtContact PlanarContact::at_contact(std::span<const double> s) const {
  AtContact l{};
  const double x = s[S::x], y = wall ? 0 : s[S::y];
  l.distance = std::hypot(reach + x, y);
  l.normal = {(reach + x) / l.distance, y / l.distance};
  l.overlap =
      -(2 * reach * x + x * x + y * y) / (reach + l.distance);  // reach - distance without cancellation
  const double d = std::max(l.overlap, 0.0);
  l.quarter = std::sqrt(std::sqrt(d));
  const double u = s[S::u2] - s[S::u1], v = s[S::v2] - s[S::v1];
  l.normal_velocity = l.along_normal(u, v);
  l.across = l.along_tangent(u, v);
  l.spin = share[0] * s[S::w1] + share[1] * s[S::w2];
  l.slip = l.across - l.distance * l.spin;
  l.turning = wall ? 0 : l.across / l.distance;
  l.normal_force = std::max(0.0, stiffness * d * std::sqrt(d) - damping * l.quarter * l.normal_velocity);
  return l;
}

double PlanarContact::dashpot(const AtContact& l) const { return tangential_damping * l.quarter * l.slip; }

double PlanarContact::softening(const AtContact& l) const {
  return std::max(l.normal_velocity, 0.0) / (2 * std::max(l.overlap, 1e-300));
}

double PlanarContact::stick_rate(const AtContact& l, double spring_now) const {
  return tangential * l.quarter * l.quarter * l.slip - softening(l) * spring_now;
}

double PlanarContact::slide_rate(const AtContact& l, double spring_now, double tangential_force) const {
  if (damping == 0) return 0;  // T is known then
  return tangential * l.quarter / tangential_damping * (tangential_force - spring_now) -
         softening(l) * spring_now;
}

double PlanarContact::spring(std::span<const double> s, ContactMode mode) const {
  if (mode == ContactMode::sticks || damping > 0) return s[S::spring];
  const AtContact l = at_contact(s);
  return sign(mode) * friction * l.normal_force;
}

void PlanarContact::rates(std::span<const double> s, ContactMode mode, std::span<double> d) const {
  const AtContact l = at_contact(s);
  const bool sticks = mode == ContactMode::sticks;
  const double tangential_force = sticks ? s[S::spring] + dashpot(l) : sign(mode) * friction * l.normal_force;
  const double fx = -l.normal_force * l.normal[0] - tangential_force * l.normal[1],
               fy = -l.normal_force * l.normal[1] + tangential_force * l.normal[0];
  d[S::x] = s[S::u2] - s[S::u1];
  d[S::y] = s[S::v2] - s[S::v1];
  d[S::u1] = fx * inverse_mass[0];
  d[S::v1] = fy * inverse_mass[0];
  d[S::u2] = -fx * inverse_mass[1];
  d[S::v2] = -fy * inverse_mass[1];
  // force and arm both change sign from the first body to the second: both turn the same way
  d[S::w1] = share[0] * l.distance * tangential_force * inverse_inertia[0];
  d[S::w2] = share[1] * l.distance * tangential_force * inverse_inertia[1];
  d[S::spring] = sticks ? stick_rate(l, s[S::spring]) : slide_rate(l, s[S::spring], tangential_force);
}

double PlanarContact::overlap(std::span<const double> s) const { return at_contact(s).overlap; }
double PlanarContact::normal_velocity(std::span<const double> s) const {
  return at_contact(s).normal_velocity;
}

double PlanarContact::lasting(std::span<const double> s) const {
  // the normal force over sqrt(overlap), which passes zero with a slope
  const AtContact l = at_contact(s);
  return l.overlap <= 0 ? stiffness * l.overlap
                        : stiffness * l.overlap - damping / l.quarter * l.normal_velocity;
}

double PlanarContact::holding(std::span<const double> s, ContactMode mode) const {
  const AtContact l = at_contact(s);
  if (l.overlap <= 0 || friction == 0) return 1;
  const double limit = friction * l.normal_force;
  if (mode == ContactMode::sticks) return limit - std::abs(s[S::spring] + dashpot(l));
  if (damping > 0) return sign(mode) * (s[S::spring] + dashpot(l)) - limit;
  const double limit_rate = -1.5 * friction * stiffness * l.quarter * l.quarter * l.normal_velocity;
  return sign(mode) * stick_rate(l, spring(s, mode)) - limit_rate;
}

ContactMode PlanarContact::next(std::span<const double> s, ContactMode mode) const {
  return mode == ContactMode::sticks ? sliding(s[S::spring] + dashpot(at_contact(s))) : ContactMode::sticks;
}

ContactMode PlanarContact::first(std::span<const double> s) const {
  const AtContact l = at_contact(s);
  // force ~ d^(1/4) with dashpots, else ~ d^(3/2): sqrt(d) integrates to 2/3 d^(3/2) / d'
  const bool slides = damping > 0
                          ? tangential_damping * std::abs(l.slip) > friction * damping * -l.normal_velocity
                          : tangential * std::abs(l.slip) > 1.5 * friction * stiffness * -l.normal_velocity;
  return slides || friction == 0 ? sliding(l.slip) : ContactMode::sticks;
}

}  // namespace fiberchain::reference::detail
