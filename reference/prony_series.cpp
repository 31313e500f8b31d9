#include "reference/prony_series.hpp"

#include <limits>

#include "reference/errors.hpp"

namespace fiberchain::reference {

ComplexModulus complex_modulus(const PronySeries& series) {
  validate(series);
  return [series](std::complex<double> s) {
    ModulusValue k{1, 0};
    for (const PronyTerm& term : series) {
      const std::complex<double> yielding = 1.0 + s * term.time;
      k.value += term.strength * s * term.time / yielding;
      k.slope += term.strength * term.time / (yielding * yielding);
    }
    return k;
  };
}

double unrelaxed_modulus(const PronySeries& series) {
  validate(series);
  double sum = 1;
  for (const PronyTerm& term : series) sum += term.strength;
  return sum;
}

void validate(const PronySeries& series) {
  for (const PronyTerm& term : series) {
    require_between("strength", term.strength, 0, std::numeric_limits<double>::max());
    require_positive("relaxation time", term.time);
  }
}

}  // namespace fiberchain::reference
