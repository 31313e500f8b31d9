#include "dem/contact/contact_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fiberchain::dem {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

bool is_wall(const ContactBody& body) { return std::isinf(body.radius); }

/// A sphere with the elasticity of these properties, where they have one.
ContactBody with_elasticity(ContactBody body, const ContactProperties& contacts) {
  if (is_wall(body)) return body;
  body.youngs_modulus = contacts.youngs_modulus.value_or(body.youngs_modulus);
  body.poisson_ratio = contacts.poisson_ratio.value_or(body.poisson_ratio);
  return body;
}

/// Whether spheres have another elasticity against some bodies than against others.
bool by_pair(const Domain& domain) {
  const auto differs = [](const auto& some) {
    return some.contacts.youngs_modulus || some.contacts.poisson_ratio;
  };
  return std::ranges::any_of(domain.walls, differs) || std::ranges::any_of(domain.pairs, differs);
}

/// 1 / (1/a + 1/b), also where one is infinite.
double joined(double a, double b) { return 1 / (1 / a + 1 / b); }

}  // namespace

ContactBody sphere_body(const Fiber& fiber, const ContactProperties& contacts) {
  const auto [E, nu] = contact_elasticity(fiber.material);
  return with_elasticity({E, nu, sphere_radius(fiber), sphere_mass(fiber), sphere_inertia(fiber)}, contacts);
}

ContactBody sphere_body(const Chain<3>& chain, const Domain& domain) {
  ContactBody body = sphere_body(chain.fiber, by_pair(domain) ? ContactProperties{} : domain.contacts);
  body.surface = chain.surface;
  body.smooth = chain.smooth;
  return body;
}

ContactBody wall_body(const Domain& domain) {
  const double E = domain.wall_youngs_modulus;
  return {E > 0 ? E : infinite, domain.wall_poisson_ratio, infinite, infinite, infinite};
}

ContactBody wall_body(const Domain& domain, const Wall& wall) {
  ContactBody body = wall_body(domain);
  body.youngs_modulus = wall.youngs_modulus.value_or(body.youngs_modulus);
  body.poisson_ratio = wall.poisson_ratio.value_or(body.poisson_ratio);
  body.surface = wall.surface;
  body.contacts = wall.contacts;
  return body;
}

std::vector<ContactBody> wall_bodies(const Domain& domain) {
  std::vector<ContactBody> all;
  for (const Wall& wall : domain.walls) {
    const ContactBody body = wall_body(domain, wall);
    if (std::ranges::find(all, body) == all.end()) all.push_back(body);
  }
  return all;
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

ContactPair contact_pair(const Domain& domain, const ContactBody& first, const ContactBody& second) {
  ContactProperties properties = with(with(domain.contacts, first.contacts), second.contacts);
  for (const SurfacePair& pair : domain.pairs) {
    const auto are = [&](int a, int b) { return first.surface == a && second.surface == b; };
    if (are(pair.first, pair.second) || are(pair.second, pair.first))
      properties = with(properties, pair.contacts);
  }
  return {with_elasticity(first, properties), with_elasticity(second, properties), properties};
}

bool rolls(const Domain& domain) {
  const auto roll = [](const auto& some) { return some.contacts.rolling_friction > 0.0; };
  return domain.contacts.rolling_friction > 0 || std::ranges::any_of(domain.walls, roll) ||
         std::ranges::any_of(domain.pairs, roll);
}

std::vector<ContactPair> contact_pairs(const Domain& domain, const std::vector<ContactBody>& spheres) {
  const std::vector<ContactBody> walls = wall_bodies(domain);
  std::vector<ContactPair> all;
  for (std::size_t a = 0; a < spheres.size(); ++a) {
    for (std::size_t b = a; b < spheres.size(); ++b)
      all.push_back(contact_pair(domain, spheres[a], spheres[b]));
    for (const ContactBody& wall : walls) all.push_back(contact_pair(domain, spheres[a], wall));
  }
  return all;
}

}  // namespace fiberchain::dem
