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
struct PlanarContact::Look {
  std::array<double, 2> normal;
  double distance, overlap;
  double quarter;          ///< overlap^(1/4)
  double opening, across;  ///< relative velocity of the centers along normal and tangent
  double spin;             ///< of both bodies, by their shares
  double slip, push;
  double turning;  ///< rate of the normal's angle

  double along_normal(double u, double v) const { return u * normal[0] + v * normal[1]; }
  double along_tangent(double u, double v) const { return v * normal[0] - u * normal[1]; }
};

PlanarContact::Look PlanarContact::look(std::span<const double> s) const {
  Look l{};
  const double x = s[S::x], y = wall ? 0 : s[S::y];
  l.distance = std::hypot(reach + x, y);
  l.normal = {(reach + x) / l.distance, y / l.distance};
  l.overlap =
      -(2 * reach * x + x * x + y * y) / (reach + l.distance);  // reach - distance without cancellation
  const double d = std::max(l.overlap, 0.0);
  l.quarter = std::sqrt(std::sqrt(d));
  const double u = s[S::u2] - s[S::u1], v = s[S::v2] - s[S::v1];
  l.opening = l.along_normal(u, v);
  l.across = l.along_tangent(u, v);
  l.spin = share[0] * s[S::w1] + share[1] * s[S::w2];
  l.slip = l.across - l.distance * l.spin;
  l.turning = wall ? 0 : l.across / l.distance;
  l.push = std::max(0.0, stiffness * d * std::sqrt(d) - damping * l.quarter * l.opening);
  return l;
}

double PlanarContact::dashpot(const Look& l) const { return tangential_damping * l.quarter * l.slip; }

double PlanarContact::softening(const Look& l) const {
  return std::max(l.opening, 0.0) / (2 * std::max(l.overlap, 1e-300));
}

double PlanarContact::stick_rate(const Look& l, double spring_now) const {
  return tangential * l.quarter * l.quarter * l.slip - softening(l) * spring_now;
}

double PlanarContact::slide_rate(const Look& l, double spring_now, double drag) const {
  if (damping == 0) return 0;  // T is known then
  return tangential * l.quarter / tangential_damping * (drag - spring_now) - softening(l) * spring_now;
}

double PlanarContact::spring(std::span<const double> s, ContactMode mode) const {
  if (mode == ContactMode::sticks || damping > 0) return s[S::spring];
  const Look l = look(s);
  return sign(mode) * friction * l.push;
}

void PlanarContact::rates(std::span<const double> s, ContactMode mode, std::span<double> d) const {
  const Look l = look(s);
  const bool sticks = mode == ContactMode::sticks;
  const double drag = sticks ? s[S::spring] + dashpot(l) : sign(mode) * friction * l.push;
  const double fx = -l.push * l.normal[0] - drag * l.normal[1],
               fy = -l.push * l.normal[1] + drag * l.normal[0];
  d[S::x] = s[S::u2] - s[S::u1];
  d[S::y] = s[S::v2] - s[S::v1];
  d[S::u1] = fx * inverse_mass[0];
  d[S::v1] = fy * inverse_mass[0];
  d[S::u2] = -fx * inverse_mass[1];
  d[S::v2] = -fy * inverse_mass[1];
  // force and arm both change sign from the first body to the second: both turn the same way
  d[S::w1] = share[0] * l.distance * drag * inverse_inertia[0];
  d[S::w2] = share[1] * l.distance * drag * inverse_inertia[1];
  d[S::spring] = sticks ? stick_rate(l, s[S::spring]) : slide_rate(l, s[S::spring], drag);
}

double PlanarContact::overlap(std::span<const double> s) const { return look(s).overlap; }
double PlanarContact::opening(std::span<const double> s) const { return look(s).opening; }

double PlanarContact::lasting(std::span<const double> s) const {
  // the normal force over sqrt(overlap), which passes zero with a slope
  const Look l = look(s);
  return l.overlap <= 0 ? stiffness * l.overlap : stiffness * l.overlap - damping / l.quarter * l.opening;
}

double PlanarContact::holding(std::span<const double> s, ContactMode mode) const {
  const Look l = look(s);
  if (l.overlap <= 0 || friction == 0) return 1;
  const double limit = friction * l.push;
  if (mode == ContactMode::sticks) return limit - std::abs(s[S::spring] + dashpot(l));
  if (damping > 0) return sign(mode) * (s[S::spring] + dashpot(l)) - limit;
  const double limit_rate = -1.5 * friction * stiffness * l.quarter * l.quarter * l.opening;
  return sign(mode) * stick_rate(l, spring(s, mode)) - limit_rate;
}

ContactMode PlanarContact::next(std::span<const double> s, ContactMode mode) const {
  return mode == ContactMode::sticks ? sliding(s[S::spring] + dashpot(look(s))) : ContactMode::sticks;
}

ContactMode PlanarContact::first(std::span<const double> s) const {
  const Look l = look(s);
  // force ~ d^(1/4) with dashpots, else ~ d^(3/2): sqrt(d) integrates to 2/3 d^(3/2) / d'
  const bool slides = damping > 0 ? tangential_damping * std::abs(l.slip) > friction * damping * -l.opening
                                  : tangential * std::abs(l.slip) > 1.5 * friction * stiffness * -l.opening;
  return slides || friction == 0 ? sliding(l.slip) : ContactMode::sticks;
}

}  // namespace fiberchain::reference::detail
