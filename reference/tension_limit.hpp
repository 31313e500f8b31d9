#pragma once

#include "reference/linear_chain.hpp"

namespace fiberchain::reference {

/// Largest step [s] at which no small motion of an endless chain grows that is pulled by `tension` [N],
/// marched with beta dt^2 K in the matrix (bonds_in_step(beta)) and the tension's own stiffness tension/l (w2
/// - w1)^2 across the chain explicit: M + dt^2 ((beta - 1/4) K - G/4) is positive definite for every wave. At
/// beta = 1/4 that is sqrt(m l/tension), above it 8 sqrt((beta - 1/4) m K_bend)/tension for waves much longer
/// than a bond. A free end that is itself pulled halves the latter, as for a beam on an elastic foundation;
/// a short chain pulled at both free ends, which turns rigidly, bears less still: finite_stable_step() knows
/// ends. Infinite for beta >= 1/4 without tension or under compression (whose
/// buckling is the chain's own, at any step). Throws InvalidArgument.
double tension_limited_step(const LinearChain& chain, double beta, double tension);

}  // namespace fiberchain::reference
