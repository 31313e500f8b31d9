#pragma once

#include <cmath>
#include <xsimd/xsimd.hpp>

#include "compare/bench/peak.hpp"

// Included by one source file an instruction set; everything here is a template on that set's number type, as
// in dem/motion/kernels/instantiate.hpp.
namespace fiberchain::compare {

/// Independent chains of operations: enough to fill two units four cycles deep, few enough for sixteen
/// registers.
inline constexpr int peak_chains = 12;

template <class Real>
inline constexpr int peak_lanes = static_cast<int>(sizeof(Real) / sizeof(double));

template <class Real>
double peak_sum(const Real (&x)[peak_chains]) {
  double parts[peak_chains * sizeof(Real) / sizeof(double)], sum = 0;
  for (int i = 0; i < peak_chains; ++i) {
    if constexpr (peak_lanes<Real> == 1) {
      parts[i] = x[i];
    } else {
      x[i].store_unaligned(parts + i * peak_lanes<Real>);
    }
  }
  for (const double part : parts) sum += part;
  return sum;
}

/// Applies `operation` to every chain, `rounds` times.
template <class Real, class Operation>
double peak_run(long rounds, double start, const Operation& operation) {
  Real x[peak_chains];
  for (int i = 0; i < peak_chains; ++i) x[i] = Real(start + 0.01 * i);
  for (long n = 0; n < rounds; ++n) {
    for (int i = 0; i < peak_chains; ++i) x[i] = operation(x[i]);
  }
  return peak_sum<Real>(x);
}

template <class Real>
double peak_multiply_add(long rounds, double start) {
  const Real factor(1.0 - 1e-9), term(1e-10);
  return peak_run<Real>(rounds, start, [&](const Real& x) { return x * factor + term; });
}

template <class Real>
double peak_divide(long rounds, double start) {
  const Real one(1.1);
  return peak_run<Real>(rounds, start, [&](const Real& x) { return one / x; });
}

template <class Real>
double peak_square_root(long rounds, double start) {
  return peak_run<Real>(rounds, start, [](const Real& x) {
    using std::sqrt;
    return sqrt(x);
  });
}

/// Sine of a cosine: two operations a round.
template <class Real>
double peak_sine(long rounds, double start) {
  return peak_run<Real>(rounds, start, [](const Real& x) {
    using std::cos;
    using std::sin;
    return sin(cos(x));
  });
}

template <class Real>
double peak_arc_tangent(long rounds, double start) {
  return peak_run<Real>(rounds, start, [](const Real& x) {
    using std::atan;
    return atan(x);
  });
}

template <class Real>
PeakLoops peak_loops_of() {
#if defined(__FMA__) || defined(__AVX512F__)
  constexpr bool fused = true;
#else
  constexpr bool fused = false;
#endif
  constexpr int doubles = peak_chains * peak_lanes<Real>;
  return {fused,
          {peak_multiply_add<Real>, (fused ? 1 : 2) * doubles},
          {peak_divide<Real>, doubles},
          {peak_square_root<Real>, doubles},
          {peak_sine<Real>, 2 * doubles},
          {peak_arc_tangent<Real>, doubles}};
}

}  // namespace fiberchain::compare
