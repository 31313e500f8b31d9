#pragma once

#include <complex>
#include <functional>

namespace fiberchain::reference {

/// k(s) = K(s)/K_inf of a viscoelastic stiffness and its derivative, s the complex rate of exp(s t) [1/s].
struct ModulusValue {
  std::complex<double> value;  ///< [-]
  std::complex<double> slope;  ///< dk/ds [s]
};

/// A stiffness over its relaxed value as a function of the complex rate: analytic, real for real s, 1 at s =
/// 0.
using ComplexModulus = std::function<ModulusValue(std::complex<double> s)>;

/// k(s) = 1, a spring.
ComplexModulus elastic_modulus();

/// k(s) + retardation s: a dashpot beside it whose retardation time is c/K_inf [s]. Throws InvalidArgument.
ComplexModulus with_retardation(ComplexModulus modulus, double retardation);

/// tan delta = Im k(i omega)/Re k(i omega) at angular frequency omega [rad/s].
double loss_factor(const ComplexModulus& modulus, double omega);

}  // namespace fiberchain::reference
