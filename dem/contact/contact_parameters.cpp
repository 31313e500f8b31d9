#include "dem/contact/contact_parameters.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "dem/contact/restitution.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Effective {
  double youngs_modulus, shear_modulus, radius, mass, inertia;
};

/// 1 / (1/a + 1/b), also where one is infinite.
double joined(double a, double b) { return 1 / (1 / a + 1 / b); }

Effective effective(const ContactBody& a, const ContactBody& b) {
  const auto flat = [](const ContactBody& x) {
    return x.youngs_modulus / (1 - x.poisson_ratio * x.poisson_ratio);
  };
  const auto along = [](const ContactBody& x) {
    return x.youngs_modulus / (2 * (1 + x.poisson_ratio) * (2 - x.poisson_ratio));
  };
  return {joined(flat(a), flat(b)), joined(along(a), along(b)), joined(a.radius, b.radius),
          joined(a.mass, b.mass), joined(a.inertia, b.inertia)};
}

void check(const ContactProperties& rules) {
  const auto require = [](const char* what, double value, bool allowed) {
    if (!allowed || !std::isfinite(value)) {
      throw InvalidInput(
          fmt::format("{} = {} is not allowed: it must be finite and 0 or greater", what, value));
    }
  };
  require("friction", rules.friction, rules.friction >= 0);
  require("rolling_friction", rules.rolling_friction, rules.rolling_friction >= 0);
}

}  // namespace

ContactBody sphere_body(const Fiber& fiber) {
  return {fiber.material.youngs_modulus, poisson_ratio(fiber.material), sphere_radius(fiber),
          sphere_mass(fiber), sphere_inertia(fiber)};
}

ContactBody wall_body(const Domain& domain) {
  const double E = domain.wall_youngs_modulus;
  return {E > 0 ? E : infinite, domain.wall_poisson_ratio, infinite, infinite, infinite};
}

ContactParameters<double> contact_parameters(const ContactBody& a, const ContactBody& b,
                                             const ContactProperties& rules, double step) {
  check(rules);
  const Effective e = effective(a, b);
  const double zeta = damping_ratio_for(rules.restitution);
  ContactParameters<double> p{};
  p.normal = 4.0 / 3 * e.youngs_modulus * std::sqrt(e.radius);
  p.tangential = 8 * e.shear_modulus * std::sqrt(e.radius);
  p.normal_damping = 2 * zeta * std::sqrt(5.0 / 4 * e.mass * p.normal);
  p.tangential_damping = 2 * zeta * std::sqrt(5.0 / 6 * e.mass * p.tangential);
  p.friction = rules.friction;
  p.rolling = rules.rolling_friction * e.radius;
  p.rolling_limit = e.inertia / step;
  p.extrapolation = 0.5;
  return p;
}

ContactRates contact_rates(const ContactBody& a, const ContactBody& b, const ContactProperties& rules,
                           double overlap, int neighbors) {
  const Effective e = effective(a, b);
  const double root = std::sqrt(e.radius * overlap), zeta = damping_ratio_for(rules.restitution);
  const double normal = 2 * e.youngs_modulus * root,
               along = rules.friction > 0 ? 8 * e.shear_modulus * root : 0;
  const auto dashpot = [&](double stiffness) { return 2 * zeta * std::sqrt(5.0 / 6 * e.mass * stiffness); };
  const auto about_sphere = [&](double across, double tangential) {
    return std::max(
               {neighbors * (across + 2 * tangential) / 3, neighbors * 5.0 / 3 * tangential, 2 * across}) /
           e.mass;
  };
  return {about_sphere(normal, along), about_sphere(dashpot(normal), 0.5 * dashpot(along))};
}

}  // namespace fiberchain::dem
