#include "compare/contact/impact_case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "compare/study/errors.hpp"

namespace fiberchain::compare {
namespace {

using reference::PlanarMotion;

struct Material {
  const char* name;
  double youngs_modulus, poisson_ratio, density;
};

constexpr Material kGlass{"glass", 48e9, 0.20, 2800}, kLimestone{"limestone", 20e9, 0.25, 2500},
    kAlloyHeadOn{"aluminium alloy", 70e9, 0.30, 2699}, kMagnesium{"magnesium alloy", 40e9, 0.35, 1800},
    kOxide{"aluminium oxide", 380e9, 0.23, 4000}, kIron{"cast iron", 100e9, 0.25, 7000},
    kAlloy{"aluminium alloy", 70e9, 0.33, 2700}, kSteel{"steel", 208e9, 0.30, 7850},
    kPolyethylene{"polyethylene", 1e9, 0.40, 1400}, kNylon{"nylon", 2.5e9, 0.40, 1000},
    kCopper{"copper", 120e9, 0.35, 8900};

ImpactBody sphere(const Material& m, double radius) {
  return {radius, m.youngs_modulus, m.poisson_ratio, m.density};
}

double tangent(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

/// Two of a kind that meet head on.
ImpactCase head_on(int test, const Material& m, double radius, double speed) {
  const ImpactBody body = sphere(m, radius);
  return {test, m.name, body, body, 1, 0.35, {{speed, 0}, 0}, {{-speed, 0}, 0}};
}

ImpactCase on_plane(int test, const Material& m, double radius, double restitution, double friction,
                    const PlanarMotion& motion) {
  return {test, m.name, sphere(m, radius), std::nullopt, restitution, friction, motion, {}};
}

std::vector<ImpactCase> by_restitution(const Material& m) {
  std::vector<ImpactCase> all;
  for (const double e : {0.2, 0.4, 0.6, 0.8, 1.0}) all.push_back(on_plane(3, m, 2.5e-3, e, 0, {{3.9, 0}, 0}));
  return all;
}

/// The small sphere spins into one of five times its radius and a thousand times its density.
ImpactCase unlike(const Material& m, const char* variant, double stiffer, double speed, double spin) {
  Material other = m;
  other.youngs_modulus *= stiffer, other.density *= 1000;
  return {8,
          fmt::format("{} {}", m.name, variant),
          sphere(m, 0.1),
          sphere(other, 0.5),
          0.5,
          0.4,
          {{speed, 0}, spin},
          {{}, 0}};
}

/// A case of a test whose angle varies.
ImpactCase oblique(int test, const Material& m, double degrees) {
  const double t = tangent(degrees);
  switch (test) {
    case 4: {
      const double normal = 3.9 / std::hypot(1, t);
      return on_plane(4, m, 2.5e-3, 0.98, 0.092, {{normal, normal * t}, 0});
    }
    case 5:
      return on_plane(5, m, 1e-5, 1, 0.3, {{5, 5 * t}, 0});
    case 6:
      return on_plane(6, m, 0.1, 0.5, 0.4, {{0.2, 0}, 0.2 * t / 0.1});
    default: {
      // the spheres turn as wheels in mesh do
      const double spin = 0.2 * t / 0.1;
      return {7, m.name, sphere(m, 0.1), sphere(m, 0.1), 0.5, 0.4, {{0.2, 0}, spin}, {{-0.2, 0}, -spin}};
    }
  }
}

std::vector<ImpactCase> oblique_cases(int test, const Material& one, const Material& other,
                                      const std::vector<double>& angles) {
  std::vector<ImpactCase> all;
  for (const Material* m : {&one, &other}) {
    for (const double angle : angles) all.push_back(oblique(test, *m, angle));
  }
  return all;
}

std::vector<ImpactCase> unlike_cases(const std::vector<double>& angles) {
  std::vector<ImpactCase> all;
  for (const Material& m : {kAlloy, kNylon}) {
    for (const auto& [variant, stiffer] : {std::pair{"A", 1000.0}, {"B", 1.0}}) {
      for (const double angle : angles)
        all.push_back(unlike(m, variant, stiffer, 0.2, 0.2 * tangent(angle) / 0.1));
    }
  }
  return all;
}

}  // namespace

std::vector<double> impact_angles() {
  std::vector<double> all;
  for (int degrees = 5; degrees <= 85; degrees += 5) all.push_back(degrees);
  return all;
}

std::vector<double> few_impact_angles() { return {5, 25, 45, 65, 85}; }

std::vector<ImpactCase> impact_cases(int test, const std::vector<double>& angles) {
  switch (test) {
    case 1:
      return {head_on(1, kGlass, 0.01, 10), head_on(1, kLimestone, 0.01, 10)};
    case 2:
      return {on_plane(2, kAlloyHeadOn, 0.1, 1, 0, {{0.2, 0}, 0}),
              on_plane(2, kMagnesium, 0.1, 1, 0, {{0.2, 0}, 0})};
    case 3: {
      std::vector<ImpactCase> all = by_restitution(kOxide);
      for (ImpactCase& c : by_restitution(kIron)) all.push_back(std::move(c));
      return all;
    }
    case 4:
      return oblique_cases(4, kOxide, kAlloy, angles);
    case 5:
      return oblique_cases(5, kSteel, kPolyethylene, angles);
    case 6:
      return oblique_cases(6, kAlloy, kNylon, angles);
    case 7:
      return oblique_cases(7, kAlloy, kCopper, angles);
    case 8:
      return unlike_cases(angles);
    default:
      throw InputError(fmt::format("impact test = {} is not allowed; allowed: 1 to {}", test, impact_tests));
  }
}

reference::ElasticBody elastic_body(const ImpactBody& body) {
  const double volume = 4.0 / 3 * std::numbers::pi * std::pow(body.radius, 3);
  return {body.radius, volume * body.density, body.youngs_modulus, body.poisson_ratio};
}

reference::ElasticBody second_body(const ImpactCase& impact) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (impact.second) return elastic_body(*impact.second);
  return {infinite, infinite, infinite, 0.3};
}

double closing_speed(const ImpactCase& impact) {
  return impact.first_motion.velocity[0] - impact.second_motion.velocity[0];
}

double slip(const ImpactCase& impact, const PlanarMotion& first, const PlanarMotion& second) {
  const double turning = impact.second ? impact.second->radius * second.spin : 0;
  return second.velocity[1] - turning - first.velocity[1] - impact.first.radius * first.spin;
}

}  // namespace fiberchain::compare
