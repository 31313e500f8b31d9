#include <cmath>
#include <cstdio>

#include "dem/equilibrium/newton.hpp"

/// Tip deflection of a cantilever at a small load against P L^3/(3 E I) and the chain's own error of it,
/// (3E/(16G) - 1/4)/r_f^2. Returns 0 if they agree.
int main() {
  namespace dem = fiberchain::dem;
  const dem::Fiber fiber{dem::isotropic_material(2.6e6, 0.17, 1100), 1.3e-3, 13};
  const double load = 1e-5;
  const dem::Boundary<2> boundary{{0}, {{13, {0, dem::load_force(fiber, load)}, {}}}};
  const auto rest = dem::solve_equilibrium<2>(dem::straight_chain<2>(fiber), boundary);
  const double measured = rest.poses.back().position[1] / dem::fiber_length(fiber) / (load / 3) - 1;
  const double expected = (3 * 2 * 1.17 / 16 - 0.25) / (13 * 13);
  std::printf("departure %.9g, expected %.9g\n", measured, expected);
  return std::abs(measured - expected) < 1e-6 * std::abs(expected) ? 0 : 1;
}
