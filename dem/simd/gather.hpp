#pragma once

#include <cstdint>
#include <xsimd/xsimd.hpp>

#include "dem/simd/lane_count.hpp"

namespace fiberchain::dem {

template <class Real>
Real load_lanes(const double* source) {
  if constexpr (lane_count<Real> == 1) {
    return *source;
  } else {
    return Real::load_unaligned(source);
  }
}

template <class Real>
void store_lanes(const Real& value, double* target) {
  if constexpr (lane_count<Real> == 1) {
    *target = value;
  } else {
    value.store_unaligned(target);
  }
}

/// Of the lanes, 0 if all are negative.
template <class Real>
double largest_lane(const Real& value) {
  double numbers[lane_count<Real>], largest = 0;
  store_lanes(value, numbers);
  for (const double number : numbers) largest = number > largest ? number : largest;
  return largest;
}

/// source[index[lane]]
template <class Real>
Real gather_lanes(const double* source, const std::int32_t* index) {
#ifdef __AVX512F__
  if constexpr (lane_count<Real> == 8) {
    return Real(_mm512_i32gather_pd(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(index)), source, 8));
  }
#endif
  double numbers[lane_count<Real>];
  for (int k = 0; k < lane_count<Real>; ++k) numbers[k] = source[index[k]];
  return load_lanes<Real>(numbers);
}

/// Bit k is set where a < b in lane k.
template <class Real>
unsigned less_mask(const Real& a, const Real& b) {
  if constexpr (lane_count<Real> == 1) {
    return a < b ? 1u : 0u;
#ifdef __AVX512F__
  } else if constexpr (lane_count<Real> == 8) {
    return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ);
#endif
#ifdef __AVX2__
  } else if constexpr (lane_count<Real> == 4) {
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_LT_OQ)));
#endif
  } else {
    alignas(64) bool less[lane_count<Real>];
    (a < b).store_aligned(less);
    unsigned mask = 0;
    for (int k = 0; k < lane_count<Real>; ++k) mask |= less[k] ? 1u << k : 0u;
    return mask;
  }
}

/// Bit k is flag k, each 0 or 1.
template <class Real>
unsigned flag_mask(const std::uint8_t* flags) {
  if constexpr (lane_count<Real> == 8) {
    std::uint64_t bytes;
    __builtin_memcpy(&bytes, flags, 8);
    return static_cast<unsigned>((bytes * 0x0102040810204080ull) >> 56);
  } else {
    unsigned mask = 0;
    for (int k = 0; k < lane_count<Real>; ++k) mask |= static_cast<unsigned>(flags[k]) << k;
    return mask;
  }
}

/// base + k for every set bit k goes to `target`, in order; up to lanes_beyond numbers behind it are written
/// over.
template <class Real>
inline __attribute__((always_inline)) void append_lanes(unsigned bits, std::int32_t base,
                                                        std::int32_t* target) {
#ifdef __AVX512F__
  if constexpr (lane_count<Real> == 8) {
    const __m512i lanes = _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
    _mm512_storeu_si512(target,
                        _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits),
                                                    _mm512_add_epi32(lanes, _mm512_set1_epi32(base))));
    return;
  }
#endif
  for (; bits != 0; bits &= bits - 1) *target++ = base + __builtin_ctz(bits);
}

}  // namespace fiberchain::dem
