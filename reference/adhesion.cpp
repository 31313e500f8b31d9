#include "reference/adhesion.hpp"

#include <cmath>
#include <numbers>

#include "reference/errors.hpp"

namespace fiberchain::reference {
double jkr_pull_off(const HertzPair& pair, double w) {
  require_positive("work of adhesion", w);
  return 1.5 * std::numbers::pi * w * pair.radius;
}

double dmt_pull_off(const HertzPair& pair, double w) {
  require_positive("work of adhesion", w);
  return 2 * std::numbers::pi * w * pair.radius;
}

JkrState jkr_state(const HertzPair& pair, double w, double a) {
  require_positive("work of adhesion", w);
  require_positive("contact radius", a);
  const double E = pair.modulus, R = pair.radius;
  return {a * a / R - std::sqrt(2 * std::numbers::pi * w * a / E),
          4 * E * a * a * a / (3 * R) - std::sqrt(8 * std::numbers::pi * w * E * a * a * a)};
}

double jkr_radius_at_touch(const HertzPair& pair, double w) {
  require_positive("work of adhesion", w);
  return std::cbrt(2 * std::numbers::pi * w * pair.radius * pair.radius / pair.modulus);
}

double jkr_radius_at_end(const HertzPair& pair, double w) {
  require_positive("work of adhesion", w);
  return std::cbrt(std::numbers::pi * w * pair.radius * pair.radius / (8 * pair.modulus));
}

double jkr_force(const HertzPair& pair, double w, double overlap) {
  double low = jkr_radius_at_end(pair, w), high = 2 * low;
  while (jkr_state(pair, w, high).overlap < overlap) high *= 2;
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    (jkr_state(pair, w, middle).overlap < overlap ? low : high) = middle;
  }
  return jkr_state(pair, w, low).force;
}

double jkr_cycle_loss(const HertzPair& pair, double w) {
  constexpr int parts = 200;
  const double from = jkr_radius_at_end(pair, w), to = jkr_radius_at_touch(pair, w), h = (to - from) / parts;
  const auto integrand = [&](double a) {
    const double slope = 2 * a / pair.radius - std::sqrt(std::numbers::pi * w / (2 * pair.modulus * a));
    return -jkr_state(pair, w, a).force * slope;
  };
  double sum = integrand(from) + integrand(to);
  for (int i = 1; i < parts; ++i) sum += (i % 2 == 1 ? 4 : 2) * integrand(from + i * h);
  return sum * h / 3;
}

double jkr_sticking_speed(const HertzPair& pair, double w) {
  return std::sqrt(2 * jkr_cycle_loss(pair, w) / pair.mass);
}

}  // namespace fiberchain::reference
