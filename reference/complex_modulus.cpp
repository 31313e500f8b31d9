#include "reference/complex_modulus.hpp"

#include <limits>
#include <utility>

#include "reference/errors.hpp"

namespace fiberchain::reference {

ComplexModulus elastic_modulus() {
  return [](std::complex<double>) { return ModulusValue{1, 0}; };
}

ComplexModulus with_retardation(ComplexModulus modulus, double retardation) {
  require_between("retardation", retardation, 0, std::numeric_limits<double>::max());
  return [modulus = std::move(modulus), retardation](std::complex<double> s) {
    const ModulusValue k = modulus(s);
    return ModulusValue{k.value + retardation * s, k.slope + retardation};
  };
}

double loss_factor(const ComplexModulus& modulus, double omega) {
  require_positive("omega", omega);
  const std::complex<double> k = modulus({0, omega}).value;
  return k.imag() / k.real();
}

}  // namespace fiberchain::reference
