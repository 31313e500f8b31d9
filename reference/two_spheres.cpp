#include "reference/two_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "reference/cvode.hpp"
#include "reference/errors.hpp"
#include "reference/gsl_root.hpp"
#include "reference/planar_contact.hpp"

namespace fiberchain::reference {
namespace {

using detail::ContactMode;
using detail::PlanarContact;
using detail::PlanarNumbers;
using S = detail::PlanarState;

constexpr double interval = 1.0 / 256;  // between looks at the mode, in overlaps over closing speeds
constexpr double longest = 1e4;
constexpr CvodeTolerances tolerances{1e-11, 1e-13, 100000};

struct Units {
  double length, speed, mass;
};

PlanarContact dimensionless(const ElasticBody& first, const ElasticBody& second, const HertzPair& pair,
                            const ContactLaw& law, const Units& unit) {
  const double k = hertz_stiffness(pair), kt = mindlin_stiffness(pair);
  const double force = unit.mass * unit.speed * unit.speed / unit.length, root = std::sqrt(unit.length);
  PlanarContact c{};
  c.stiffness = k * root * unit.length / force;
  c.tangential = kt * root * unit.length / force;
  c.damping = 2 * law.damping_ratio * std::sqrt(1.25 * c.stiffness);
  c.tangential_damping = 2 * law.damping_ratio * std::sqrt(5.0 / 6 * c.tangential);
  c.friction = law.friction;
  c.wall = std::isinf(second.radius);
  c.reach = (first.radius + (c.wall ? 0 : second.radius)) / unit.length;
  c.share[0] = c.wall ? 1 : first.radius / (first.radius + second.radius);
  c.share[1] = 1 - c.share[0];
  c.inverse_mass = {unit.mass / first.mass, unit.mass / second.mass};
  c.inverse_inertia[0] = c.inverse_mass[0] * 2.5 * std::pow(unit.length / first.radius, 2);
  c.inverse_inertia[1] = c.wall ? 0 : c.inverse_mass[1] * 2.5 * std::pow(unit.length / second.radius, 2);
  return c;
}

/// df/dstate by central differences: it only steers Newton's iteration.
void difference_jacobian(const PlanarContact& contact, ContactMode mode, std::span<const double> state,
                         std::span<double> entries) {
  PlanarNumbers s, up, down;
  std::copy(state.begin(), state.end(), s.begin());
  for (std::size_t j = 0; j < S::size; ++j) {
    const double at = s[j], h = 1e-6 * std::max(1e-3, std::abs(at));
    s[j] = at + h;
    contact.rates(s, mode, up);
    s[j] = at - h;
    contact.rates(s, mode, down);
    s[j] = at;
    for (std::size_t i = 0; i < S::size; ++i) entries[i + j * S::size] = (up[i] - down[i]) / (2 * h);
  }
}

/// The motion in one mode, from one moment on.
class Flight {
 public:
  Flight(const PlanarContact& contact, ContactMode mode, double t, const PlanarNumbers& state)
      : cvode_(
            CvodeMethod::adams, [&contact, mode](double, auto s, auto d) { contact.rates(s, mode, d); },
            [&contact, mode](double, auto s, auto j) { difference_jacobian(contact, mode, s, j); }, t, state,
            tolerances, "two spheres in contact") {}

  PlanarNumbers to(double t) {
    PlanarNumbers state;
    std::ranges::copy(cvode_.advance(t), state.begin());
    return state;
  }

 private:
  detail::Cvode cvode_;
};

struct Moment {
  double t;
  PlanarNumbers state;
};

/// Where `positive` passes zero on the way from `from` to `to`.
Moment passage(const PlanarContact& contact, ContactMode mode, const Moment& from, double to,
               const std::function<double(const PlanarNumbers&)>& positive, const char* what) {
  const auto at = [&](double t) { return Flight(contact, mode, from.t, from.state).to(t); };
  // right after a change the margin is zero to round-off
  const double low = from.t + 1e-4 * (to - from.t);
  const auto f = [&](double t) { return positive(at(t)); };
  if (f(low) <= 0) return {low, at(low)};
  const double t =
      detail::find_root(f, low, to, {.residual = 0, .interval = 1e-13, .max_iterations = 100}, what);
  return {t, at(t)};
}

double kinetic(const ElasticBody& body, const PlanarMotion& m) {
  if (std::isinf(body.mass)) return 0;
  const double surface = body.radius * m.spin;
  return 0.5 * body.mass *
         (m.velocity[0] * m.velocity[0] + m.velocity[1] * m.velocity[1] + 0.4 * surface * surface);
}

PlanarMotion motion_of(const double* numbers, const Units& unit) {
  return {{numbers[0] * unit.speed, numbers[1] * unit.speed}, numbers[2] * unit.speed / unit.length};
}

}  // namespace

Impact collide(const ElasticBody& first, const ElasticBody& second, const ContactLaw& law,
               const PlanarMotion& first_motion, const PlanarMotion& second_motion) {
  require_between("damping ratio", law.damping_ratio, 0, std::nextafter(1.0, 0.0));
  require_between("friction", law.friction, 0, std::numeric_limits<double>::max());
  require_positive("first radius", first.radius);
  require_positive("first mass", first.mass);
  const HertzPair pair = hertz_pair(first, second);
  const double closing = first_motion.velocity[0] - second_motion.velocity[0];
  const Units unit{hertz_collision(pair, closing).overlap, closing, pair.mass};
  const PlanarContact contact = dimensionless(first, second, pair, law, unit);

  Moment now{0, {}};
  const auto put = [&](std::size_t at, const PlanarMotion& m) {
    now.state[at] = m.velocity[0] / unit.speed;
    now.state[at + 1] = m.velocity[1] / unit.speed;
    now.state[at + 2] = m.spin * unit.length / unit.speed;
  };
  put(S::u1, first_motion);
  put(S::u2, second_motion);

  ContactMode mode = contact.first(now.state);
  Impact impact{};
  impact.starts_sliding = mode != ContactMode::sticks;
  const auto right = [&](const PlanarNumbers& s) {
    return std::min(contact.lasting(s), contact.holding(s, mode));
  };
  const auto closes = [&](const PlanarNumbers& s) { return -contact.normal_velocity(s); };
  std::optional<Flight> flight(std::in_place, contact, mode, now.t, now.state);
  while (now.t < longest) {
    Moment next{now.t + interval, {}};
    next.state = flight->to(next.t);
    const bool changes = right(next.state) <= 0;
    if (changes)
      next = passage(contact, mode, now, next.t, right, "change of a contact between sticking and sliding");
    if (closes(now.state) > 0 && closes(next.state) <= 0) {
      const Moment turn = passage(contact, mode, now, next.t, closes, "largest overlap");
      impact.overlap = unit.length * contact.overlap(turn.state);
    }
    now = next;
    if (!changes) continue;
    if (contact.lasting(now.state) <= contact.holding(now.state, mode)) break;
    now.state[S::spring] = contact.spring(now.state, mode);
    mode = contact.next(now.state, mode);
    ++impact.changes;
    flight.emplace(contact, mode, now.t, now.state);
  }
  if (now.t >= longest) throw NoConvergence("end of a contact");

  impact.first = motion_of(&now.state[S::u1], unit);
  impact.second = motion_of(&now.state[S::u2], unit);
  impact.separation = {unit.length * (contact.reach + now.state[S::x]), unit.length * now.state[S::y]};
  impact.time = now.t * unit.length / unit.speed;
  impact.ends_sliding = mode != ContactMode::sticks;
  impact.dissipated = kinetic(first, first_motion) + kinetic(second, second_motion) -
                      kinetic(first, impact.first) - kinetic(second, impact.second);
  return impact;
}

}  // namespace fiberchain::reference
