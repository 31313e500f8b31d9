#pragma once

#include <algorithm>
#include <complex>
#include <optional>
#include <string>
#include <utility>

#include "reference/complex_modes.hpp"
#include "reference/errors.hpp"

namespace fiberchain::reference::detail {

/// Carries the solution at h = 0 to h = 1. `solve(h, from)` gives the solution at h, or nothing if there is
/// none near `from`: the step in h is then halved. Throws NoConvergence, naming `what`, below 1e-4.
template <class Solution, class Solve>
Solution follow(Solution solution, const Solve& solve, const std::string& what) {
  double reached = 0;
  double step = 1;
  while (reached < 1) {
    const double h = std::min(1.0, reached + step);
    if (std::optional<Solution> next = solve(h, solution)) {
      solution = std::move(*next);
      reached = h;
      step *= 2;
    } else {
      step /= 2;
      if (step < 1e-4) throw NoConvergence(what);
    }
  }
  return solution;
}

/// Whether the next eigenvalue still oscillates and is close enough to be the same mode's.
inline bool continues(std::complex<double> from, std::complex<double> to) {
  return to.imag() > 0 && std::abs(to - from) <= 0.3 * std::abs(from);
}

/// s - f(s)/f'(s) until a step is below 1e-9 |s|, so that the error left is of the order of its square.
/// Nothing if that takes more than 30.
template <class Function>
std::optional<std::complex<double>> complex_newton(const Function& function, std::complex<double> s) {
  for (int i = 0; i < 30; ++i) {
    const ModulusValue f = function(s);
    const std::complex<double> change = f.value / f.slope;
    s -= change;
    if (!(std::abs(s) < 1e300)) return std::nullopt;
    if (std::abs(change) <= 1e-9 * std::abs(s)) return s;
  }
  return std::nullopt;
}

/// Frequency, damping and difference from the two numbers.
FreeDecay free_decay(std::complex<double> eigenvalue, double half_loss_factor);

}  // namespace fiberchain::reference::detail
