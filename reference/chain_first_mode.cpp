#include <cmath>
#include <complex>
#include <vector>

#include "reference/chain_modes.hpp"
#include "reference/chain_strains.hpp"
#include "reference/errors.hpp"

namespace fiberchain::reference {
namespace {

using Complex = std::complex<double>;
using Values = std::vector<Complex>;

/// Displacements and rotations of spheres 0 ... bonds, sphere 0 held, and the strains of the bonds. The
/// strains are kept because differences of displacements would lose digits with the cube of the length.
struct Shape {
  Values w;
  Values theta;
  Values shear;
  Values bend;
};

/// u = (K + lambda C)^-1 M v for the clamped-free chain, which is statically determinate: the forces on the
/// spheres are summed from the free end to the bonds' shear forces and moments, those divided by
/// k + lambda c, and the strains summed from the clamp. No difference is taken anywhere.
Shape flexibility_times_mass(const LinearChain& chain, Complex lambda, const Shape& v) {
  const std::size_t n = static_cast<std::size_t>(chain.bonds);
  const double arm = chain.spacing / 2;
  const Complex shear_spring = chain.stiffness.shear + lambda * chain.dashpot.shear;
  const Complex bend_spring = chain.stiffness.bend + lambda * chain.dashpot.bend;
  Shape u{Values(n + 1), Values(n + 1), Values(n), Values(n)};
  Complex force = 0;
  Complex moment = 0;
  for (std::size_t j = n; j >= 1; --j) {
    const Complex beyond = force;
    const double share = j == n ? chain.end_share : 1.0;
    force += share * chain.mass * v.w[j];
    moment += share * chain.inertia * v.theta[j] + arm * (force + beyond);
    u.shear[j - 1] = force / shear_spring;
    u.bend[j - 1] = moment / bend_spring;
  }
  for (std::size_t i = 0; i < n; ++i) {
    u.theta[i + 1] = u.theta[i] + u.bend[i];
    u.w[i + 1] = u.w[i] + u.shear[i] + arm * (u.theta[i] + u.theta[i + 1]);
  }
  return u;
}

void scale_to_tip(Shape& u) {
  const Complex factor = 1.0 / u.w.back();
  for (Values* values : {&u.w, &u.theta, &u.shear, &u.bend}) {
    for (Complex& value : *values) value *= factor;
  }
}

Complex sum_of_squares(const Values& values) {
  Complex sum = 0;
  for (const Complex& value : values) sum += value * value;
  return sum;
}

/// The free end sphere counts by its share.
Complex sum_of_masses(const LinearChain& chain, const Values& values) {
  return sum_of_squares(values) - (1 - chain.end_share) * values.back() * values.back();
}

/// The three coefficients of u^T (M x^2 + C x + K) u, whose root is stationary at a mode.
struct Quadratic {
  Quadratic(const LinearChain& chain, const Shape& u)
      : m(chain.mass * sum_of_masses(chain, u.w) + chain.inertia * sum_of_masses(chain, u.theta)),
        c(chain.dashpot.shear * sum_of_squares(u.shear) + chain.dashpot.bend * sum_of_squares(u.bend)),
        k(chain.stiffness.shear * sum_of_squares(u.shear) + chain.stiffness.bend * sum_of_squares(u.bend)) {}

  /// From a real shape: the oscillation, or of two real roots the slower.
  Complex first_root() const {
    const bool overdamped = c.real() * c.real() > 4 * m.real() * k.real();
    return root_near(overdamped ? Complex{0, 0} : Complex{0, 2 * std::sqrt(k.real() / m.real())});
  }
  Complex root_near(Complex guess) const { return detail::quadratic_root(m, c, k, guess); }

  Complex m, c, k;
};

Shape parabola(int bonds) {
  Shape shape;
  for (int i = 0; i <= bonds; ++i) {
    const double s = static_cast<double>(i) / bonds;
    shape.w.push_back(s * s);
    shape.theta.push_back(0);
  }
  return shape;
}

ChainMode finished(const Shape& u, Complex lambda) {
  if (std::abs(lambda.imag()) < 1e-12 * std::abs(lambda)) lambda = lambda.real();
  ChainMode mode{};
  detail::set_eigenvalue(mode, lambda);
  mode.displacement = u.w;
  mode.rotation = u.theta;
  return mode;
}

}  // namespace

ChainMode first_bending_mode(const LinearChain& chain) {
  validate(chain);
  Shape u = flexibility_times_mass(chain, 0, parabola(chain.bonds));
  scale_to_tip(u);
  Complex lambda = Quadratic(chain, u).first_root();
  for (int i = 0; i < 200; ++i) {
    const Complex tip_slope = u.theta.back();
    u = flexibility_times_mass(chain, lambda, u);
    scale_to_tip(u);
    const Complex next = Quadratic(chain, u).root_near(lambda);
    // the eigenvalue settles twice as fast as the shape: wait for both
    const bool settled = std::abs(next - lambda) <= 1e-14 * std::abs(next) &&
                         std::abs(u.theta.back() - tip_slope) <= 1e-13 * std::abs(tip_slope);
    lambda = next;
    if (settled) return finished(u, lambda);
  }
  throw NoConvergence(
      "first bending mode of the chain (close to critical damping, or a higher mode is as slow)");
}

}  // namespace fiberchain::reference
