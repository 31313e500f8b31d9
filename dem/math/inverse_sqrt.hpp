#pragma once

#include <cmath>
#ifdef __AVX512F__
#include <immintrin.h>
#endif

#include "dem/math/near_one.hpp"

namespace fiberchain::dem {

/// 1 / sqrt(q) to round-off, q > 1e-300. Where a processor has an estimate, within 2^-14, a series takes it
/// from there, to fifth order in what is missing: division and root would wait for each other and for those
/// of other vectors.
template <class Real>
Real inverse_sqrt(const Real& q) {
#ifdef __AVX512F__
  if constexpr (sizeof(Real) == sizeof(__m512d)) {
    const Real guess = Real(_mm512_rsqrt14_pd(q));
    const Real rest = Real(1.0) - q * guess * guess;
    return guess + guess * (rest * polynomial(rest, 0.5, 0.375, 0.3125, 0.2734375));
  }
#endif
  using std::sqrt;
  return Real(1.0) / sqrt(q);
}

}  // namespace fiberchain::dem
