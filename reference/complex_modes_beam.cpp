#include <cmath>
#include <numbers>

#include "reference/complex_modes.hpp"
#include "reference/damped_beam.hpp"
#include "reference/errors.hpp"
#include "reference/gsl_root.hpp"
#include "reference/mode_following.hpp"

namespace fiberchain::reference {

FreeDecay detail::free_decay(std::complex<double> eigenvalue, double half_loss_factor) {
  const double frequency = std::abs(eigenvalue);
  const double damping = -eigenvalue.real() / frequency;
  return {eigenvalue, frequency, damping, half_loss_factor, damping - half_loss_factor};
}

FreeDecay single_mode_decay(double omega, const ComplexModulus& modulus) {
  require_positive("omega", omega);
  // s = omega x: x^2 + 1 + h (k(omega x) - 1) = 0
  const auto solve = [&](double h, std::complex<double> from) -> std::optional<std::complex<double>> {
    const auto function = [&](std::complex<double> x) {
      const ModulusValue k = modulus(omega * x);
      return ModulusValue{x * x + 1.0 + h * (k.value - 1.0), 2.0 * x + h * omega * k.slope};
    };
    const auto root = detail::complex_newton(function, from);
    return root && detail::continues(from, *root) ? root : std::nullopt;
  };
  const std::complex<double> s =
      omega * detail::follow(std::complex<double>{0, 1}, solve, "root of a mode's complex modulus");
  return detail::free_decay(s, loss_factor(modulus, std::abs(s)) / 2);
}

double free_free_beta(int n) {
  require_between("n", n, 1, 1e7);
  const double middle = (n + 0.5) * std::numbers::pi;
  if (n > 11) return middle;  // the root is within 2 exp(-beta) < 1e-15 of it
  const auto f = [](double beta) { return std::cos(beta) - 1 / std::cosh(beta); };
  return detail::find_root(f, middle - 0.5, middle + 0.5, {}, "frequency of the free-free beam");
}

std::vector<ComplexBeamMode> complex_beam_modes(const UniformBeam& beam, const ComplexModulus& modulus,
                                                ChainEnds ends, int count) {
  require_positive("length", beam.length);
  require_positive("bending", beam.bending);
  require_positive("mass_per_length", beam.mass_per_length);
  require_between("count", count, 1, 1e6);
  const double unit = std::sqrt(beam.bending / beam.mass_per_length) / (beam.length * beam.length);
  std::vector<ComplexBeamMode> modes;
  for (int n = 1; n <= count; ++n) {
    const double beta = ends == ChainEnds::clamped_free ? clamped_free_beta(n) : free_free_beta(n);
    modes.push_back({n, beta, single_mode_decay(unit * beta * beta, modulus)});
  }
  return modes;
}

}  // namespace fiberchain::reference
