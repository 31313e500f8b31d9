#include "dem/contact/contact_body.hpp"

#include <limits>

namespace fiberchain::dem {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// 1 / (1/a + 1/b), also where one is infinite.
double joined(double a, double b) { return 1 / (1 / a + 1 / b); }

}  // namespace

ContactBody sphere_body(const Fiber& fiber, const ContactProperties& contacts) {
  const auto [E, nu] = contact_elasticity(fiber.material);
  return {contacts.youngs_modulus.value_or(E), contacts.poisson_ratio.value_or(nu), sphere_radius(fiber),
          sphere_mass(fiber), sphere_inertia(fiber)};
}

ContactBody wall_body(const Domain& domain) {
  const double E = domain.wall_youngs_modulus;
  return {E > 0 ? E : infinite, domain.wall_poisson_ratio, infinite, infinite, infinite};
}

EffectiveBody effective_body(const ContactBody& a, const ContactBody& b) {
  const auto flat = [](const ContactBody& x) {
    return x.youngs_modulus / (1 - x.poisson_ratio * x.poisson_ratio);
  };
  const auto along = [](const ContactBody& x) {
    return x.youngs_modulus / (2 * (1 + x.poisson_ratio) * (2 - x.poisson_ratio));
  };
  return {joined(flat(a), flat(b)), joined(along(a), along(b)), joined(a.radius, b.radius),
          joined(a.mass, b.mass), joined(a.inertia, b.inertia)};
}

}  // namespace fiberchain::dem
