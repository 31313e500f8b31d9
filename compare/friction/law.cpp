#include "compare/friction/law.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace fiberchain::compare {
namespace {

using std::numbers::pi;

/// Over a period, the integral of |s cos^2 t - p cos 2t| |sin t| dt.
double work_of(double s, double p) {
  constexpr int points = 2000;
  double sum = 0;
  for (int n = 0; n < points; ++n) {
    const double t = pi / 2 * (n + 0.5) / points, c = std::cos(t);
    sum += std::abs(s * c * c - p * std::cos(2 * t)) * std::sin(t);
  }
  return 4 * sum * pi / 2 / points;
}

}  // namespace

double small_friction_damping(const dem::Fiber& fiber, const reference::ChainMode& mode) {
  const int bonds = fiber.aspect_ratio;
  const double L = dem::fiber_length(fiber), l = dem::bond_length(fiber);
  const double m = dem::sphere_mass(fiber), J = dem::sphere_inertia(fiber);
  // per frequency squared and for the free end's deflection L: displacement y [m], pull x of the spheres
  // along the fiber
  std::vector<double> y(bonds + 1), angle(bonds + 1), x(bonds + 1, 0.0);
  double energy = 0;
  for (int i = 0; i <= bonds; ++i) {
    y[i] = L * mode.displacement[i].real();
    angle[i] = L * mode.rotation[i].real();
    if (i > 0) x[i] = x[i - 1] + (y[i] - y[i - 1]) * (y[i] - y[i - 1]) / l;
    energy += 0.5 * (m * y[i] * y[i] + J * angle[i] * angle[i]);
  }
  double pulled = 0, pushed = 0, work = 0;
  for (int i = bonds - 1; i >= 0; --i) {
    pulled += m * x[i + 1];
    pushed += m * y[i + 1];
    work += work_of(pushed * (y[i + 1] - y[i]) / l, pulled) * std::abs(angle[i + 1] - angle[i]);
  }
  work *= dem::sphere_radius(fiber) / 2;
  return work / (2 * energy) / (2 * pi);  // log decrement over 2 pi
}

}  // namespace fiberchain::compare
