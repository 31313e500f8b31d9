#pragma once

#include <vector>

#include "reference/complex_modulus.hpp"

namespace fiberchain::reference {

/// One Maxwell branch: a spring and a dashpot in line, beside the relaxed spring.
struct PronyTerm {
  double strength;  ///< g: the branch's spring over the relaxed one [-]
  double time;      ///< tau: relaxation time [s]
};

/// Generalized Maxwell stiffness K(t) = K_inf (1 + sum g_j exp(-t/tau_j)). Empty: elastic.
using PronySeries = std::vector<PronyTerm>;

/// k(s) = K(s)/K_inf = 1 + sum g_j s tau_j/(1 + s tau_j), infinite at s = -1/tau_j. Throws InvalidArgument.
ComplexModulus complex_modulus(const PronySeries& series);

/// K(t = 0)/K_inf = 1 + sum g_j: of a sudden load.
double unrelaxed_modulus(const PronySeries& series);

/// Throws InvalidArgument unless every strength is 0 or more and every time greater than 0, all finite.
void validate(const PronySeries& series);

}  // namespace fiberchain::reference
