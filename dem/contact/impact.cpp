#include "dem/contact/impact.hpp"

#include <cmath>

#include "dem/contact/contact_law.hpp"
#include "dem/contact/smooth_contacts.hpp"

namespace fiberchain::dem {
namespace {

/// Integral of f over 0 to 1 by Gauss's rule of three points: exact for polynomials of degree 5.
template <class Function>
double integral(const Function& f) {
  const double reach = std::sqrt(0.15);
  return (5 * f(0.5 - reach) + 8 * f(0.5) + 5 * f(0.5 + reach)) / 18;
}

/// Work to an overlap D: the integral of (D - s) K(s), K the normal stiffness, with s = D u^2, which makes it
/// a polynomial where K grows as the root of the overlap.
double work_to(double overlap, const EffectiveBody& body, const ContactProperties& properties) {
  const ContactLaw& law = law_of(properties);
  return 2 * overlap * overlap * integral([&](double u) {
           return u * (1 - u * u) * law.stiffness(body, properties, overlap * u * u).normal;
         });
}

/// Where the work has taken this energy [J].
double overlap_of(double energy, const EffectiveBody& body, const ContactProperties& properties) {
  double low = 0, high = body.radius;
  while (work_to(high, body, properties) < energy) low = high, high *= 2;
  for (int i = 0; i < 100 && high - low > 1e-14 * high; ++i) {
    const double middle = (low + high) / 2;
    (work_to(middle, body, properties) < energy ? low : high) = middle;
  }
  return high;
}

}  // namespace

Impact elastic_impact(const ContactBody& a, const ContactBody& b, const ContactProperties& properties,
                      double speed) {
  constexpr int parts = 100;
  const EffectiveBody both = crossed_body(a, b);
  const double energy = 0.5 * both.mass * speed * speed, deepest = overlap_of(energy, both, properties);
  // 2 / v times the integral of 1 / sqrt(1 - work / energy) over the overlap, deepest (1 - u^2)
  double sum = 0;
  for (int i = 0; i < parts; ++i) {
    const double u = (i + 0.5) / parts;
    sum += 2 * u / std::sqrt(1 - work_to(deepest * (1 - u * u), both, properties) / energy);
  }
  return {deepest, 2 * deepest / speed * sum / parts};
}

}  // namespace fiberchain::dem
