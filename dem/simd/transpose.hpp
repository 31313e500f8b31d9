#pragma once

#include <cstddef>
#include <xsimd/xsimd.hpp>

#include "dem/simd/lane_count.hpp"
#include "dem/simd/storage_layout.hpp"

// Rows of numbers, one row a lane, into vectors and back. Copies only: every instruction set gives the same.
namespace fiberchain::dem {

#ifdef __AVX512F__
/// Eight rows of eight to columns, or back.
inline __attribute__((always_inline)) void transpose_8(__m512d (&r)[8]) {
  __m512d t[8], u[8];
  for (int k = 0; k < 8; k += 2) {
    t[k] = _mm512_unpacklo_pd(r[k], r[k + 1]);
    t[k + 1] = _mm512_unpackhi_pd(r[k], r[k + 1]);
  }
  for (int odd = 0; odd < 2; ++odd) {
    for (int half = 0; half < 2; ++half) {
      const __m512d a = t[4 * half + odd], b = t[4 * half + 2 + odd];
      u[4 * odd + half] = _mm512_shuffle_f64x2(a, b, 0x88);
      u[4 * odd + 2 + half] = _mm512_shuffle_f64x2(a, b, 0xdd);
    }
    r[odd] = _mm512_shuffle_f64x2(u[4 * odd], u[4 * odd + 1], 0x88);
    r[4 + odd] = _mm512_shuffle_f64x2(u[4 * odd], u[4 * odd + 1], 0xdd);
    r[2 + odd] = _mm512_shuffle_f64x2(u[4 * odd + 2], u[4 * odd + 3], 0x88);
    r[6 + odd] = _mm512_shuffle_f64x2(u[4 * odd + 2], u[4 * odd + 3], 0xdd);
  }
}

/// Four by four in both halves.
inline __attribute__((always_inline)) void transpose_4(__m512d (&r)[4]) {
  const __m512i even = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13),
                odd = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
  const __m512d t0 = _mm512_unpacklo_pd(r[0], r[1]), t1 = _mm512_unpackhi_pd(r[0], r[1]);
  const __m512d t2 = _mm512_unpacklo_pd(r[2], r[3]), t3 = _mm512_unpackhi_pd(r[2], r[3]);
  r[0] = _mm512_permutex2var_pd(t0, even, t2);
  r[1] = _mm512_permutex2var_pd(t1, even, t3);
  r[2] = _mm512_permutex2var_pd(t0, odd, t2);
  r[3] = _mm512_permutex2var_pd(t1, odd, t3);
}
#endif

#ifdef __AVX2__
inline __attribute__((always_inline)) void transpose_4(__m256d (&r)[4]) {
  const __m256d t0 = _mm256_unpacklo_pd(r[0], r[1]), t1 = _mm256_unpackhi_pd(r[0], r[1]);
  const __m256d t2 = _mm256_unpacklo_pd(r[2], r[3]), t3 = _mm256_unpackhi_pd(r[2], r[3]);
  r[0] = _mm256_permute2f128_pd(t0, t2, 0x20);
  r[1] = _mm256_permute2f128_pd(t1, t3, 0x20);
  r[2] = _mm256_permute2f128_pd(t0, t2, 0x31);
  r[3] = _mm256_permute2f128_pd(t1, t3, 0x31);
}
#endif

/// Where rows begin, lane by lane.
template <class Real, class Number = double>
struct RowStarts {
  Number* at[lane_count<Real>];
};

#ifdef __AVX512F__
/// Whether rows of N numbers are transposed in registers.
template <int N, int lanes>
inline constexpr bool in_registers = lanes == 8 && (N == 2 || N == 4 || N == 8);

template <int N, class Real, class Number>
inline __attribute__((always_inline)) void load_in_registers(const RowStarts<Real, Number>& rows,
                                                             std::ptrdiff_t offset, Real* out) {
  if constexpr (N == 8) {
    __m512d r[8];
    for (int k = 0; k < 8; ++k) r[k] = _mm512_loadu_pd(rows.at[k] + offset);
    transpose_8(r);
    for (int c = 0; c < N; ++c) out[c] = Real(r[c]);
  } else if constexpr (N == 4) {
    __m512d r[4];
    for (int k = 0; k < 4; ++k) {
      r[k] = _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_loadu_pd(rows.at[k] + offset)),
                                _mm256_loadu_pd(rows.at[k + 4] + offset), 1);
    }
    transpose_4(r);
    for (int c = 0; c < N; ++c) out[c] = Real(r[c]);
  } else {
    // rows k, k + 2, k + 4, k + 6; loads that blend go beside the shuffles
    const auto quarters = [&](int k) {
      const auto two = [&](int l) { return _mm_castpd_ps(_mm_loadu_pd(rows.at[l] + offset)); };
      __m512 r = _mm512_castps128_ps512(two(k));
      r = _mm512_mask_broadcast_f32x4(r, 0x00f0, two(k + 2));
      r = _mm512_mask_broadcast_f32x4(r, 0x0f00, two(k + 4));
      return _mm512_castps_pd(_mm512_mask_broadcast_f32x4(r, 0xf000, two(k + 6)));
    };
    const __m512d even = quarters(0), odd = quarters(1);
    out[0] = Real(_mm512_unpacklo_pd(even, odd)), out[1] = Real(_mm512_unpackhi_pd(even, odd));
  }
}

template <int N, class Real>
inline __attribute__((always_inline)) void store_in_registers(const Real* in, const RowStarts<Real>& rows,
                                                              std::ptrdiff_t offset) {
  if constexpr (N == 8) {
    __m512d r[8];
    for (int c = 0; c < 8; ++c) r[c] = in[c];
    transpose_8(r);
    for (int k = 0; k < 8; ++k) _mm512_storeu_pd(rows.at[k] + offset, r[k]);
  } else if constexpr (N == 4) {
    __m512d r[4];
    for (int c = 0; c < N; ++c) r[c] = in[c];
    transpose_4(r);
    for (int k = 0; k < 4; ++k) {
      _mm256_storeu_pd(rows.at[k] + offset, _mm512_castpd512_pd256(r[k]));
      _mm256_storeu_pd(rows.at[k + 4] + offset, _mm512_extractf64x4_pd(r[k], 1));
    }
  } else {
    const __m512d even = _mm512_unpacklo_pd(in[0], in[1]), odd = _mm512_unpackhi_pd(in[0], in[1]);
    const auto quarters = [&](const __m512d& pairs, int k) {
      const __m512 r = _mm512_castpd_ps(pairs);
      const auto two = [&](int l, const __m128& pair) {
        _mm_storeu_pd(rows.at[l] + offset, _mm_castps_pd(pair));
      };
      two(k, _mm512_castps512_ps128(r)), two(k + 2, _mm512_extractf32x4_ps(r, 1));
      two(k + 4, _mm512_extractf32x4_ps(r, 2)), two(k + 6, _mm512_extractf32x4_ps(r, 3));
    };
    quarters(even, 0), quarters(odd, 1);
  }
}
#elif defined(__AVX2__)
template <int N, int lanes>
inline constexpr bool in_registers = lanes == 4 && (N == 2 || N % 4 == 0);

template <int N, class Real, class Number>
inline __attribute__((always_inline)) void load_in_registers(const RowStarts<Real, Number>& rows,
                                                             std::ptrdiff_t offset, Real* out) {
  if constexpr (N == 2) {
    const auto two = [&](int k) {
      return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(rows.at[k] + offset)),
                                  _mm_loadu_pd(rows.at[k + 2] + offset), 1);
    };
    const __m256d even = two(0), odd = two(1);
    out[0] = Real(_mm256_unpacklo_pd(even, odd)), out[1] = Real(_mm256_unpackhi_pd(even, odd));
  } else {
    for (int part = 0; part < N; part += 4) {
      __m256d r[4];
      for (int k = 0; k < 4; ++k) r[k] = _mm256_loadu_pd(rows.at[k] + offset + part);
      transpose_4(r);
      for (int c = 0; c < 4; ++c) out[part + c] = Real(r[c]);
    }
  }
}

template <int N, class Real>
inline __attribute__((always_inline)) void store_in_registers(const Real* in, const RowStarts<Real>& rows,
                                                              std::ptrdiff_t offset) {
  if constexpr (N == 2) {
    const __m256d even = _mm256_unpacklo_pd(in[0], in[1]), odd = _mm256_unpackhi_pd(in[0], in[1]);
    _mm_storeu_pd(rows.at[0] + offset, _mm256_castpd256_pd128(even)),
        _mm_storeu_pd(rows.at[1] + offset, _mm256_castpd256_pd128(odd));
    _mm_storeu_pd(rows.at[2] + offset, _mm256_extractf128_pd(even, 1)),
        _mm_storeu_pd(rows.at[3] + offset, _mm256_extractf128_pd(odd, 1));
  } else {
    for (int part = 0; part < N; part += 4) {
      __m256d r[4];
      for (int c = 0; c < 4; ++c) r[c] = in[part + c];
      transpose_4(r);
      for (int k = 0; k < 4; ++k) _mm256_storeu_pd(rows.at[k] + offset + part, r[k]);
    }
  }
}
#else
template <int N, int lanes>
inline constexpr bool in_registers = false;
#endif

/// Number c of the row `offset` numbers behind a lane's start becomes that lane of out[c].
template <int N, class Real, class Number>
inline __attribute__((always_inline)) void load_rows(const RowStarts<Real, Number>& rows,
                                                     std::ptrdiff_t offset, Real* out) {
  constexpr int lanes = lane_count<Real>;
  if constexpr (lanes > 1 && N == 6) {
    load_rows<4>(rows, offset, out);
    load_rows<2>(rows, offset + 4, out + 4);
  } else if constexpr (in_registers<N, lanes>) {
    load_in_registers<N>(rows, offset, out);
  } else {
    for (int c = 0; c < N; ++c) {
      if constexpr (lanes == 1) {
        out[c] = rows.at[0][offset + c];
      } else {
        alignas(64) double numbers[lanes];
        for (int k = 0; k < lanes; ++k) numbers[k] = rows.at[k][offset + c];
        out[c] = Real::load_aligned(numbers);
      }
    }
  }
}

/// The way back.
template <int N, class Real>
inline __attribute__((always_inline)) void store_rows(const Real* in, const RowStarts<Real>& rows,
                                                      std::ptrdiff_t offset) {
  constexpr int lanes = lane_count<Real>;
  if constexpr (lanes > 1 && N == 6) {
    store_rows<4>(in, rows, offset);
    store_rows<2>(in + 4, rows, offset + 4);
  } else if constexpr (in_registers<N, lanes>) {
    store_in_registers<N>(in, rows, offset);
  } else {
    for (int c = 0; c < N; ++c) {
      if constexpr (lanes == 1) {
        rows.at[0][offset + c] = in[c];
      } else {
        alignas(64) double numbers[lanes];
        in[c].store_aligned(numbers);
        for (int k = 0; k < lanes; ++k) rows.at[k][offset + c] = numbers[k];
      }
    }
  }
}

/// Zero to N numbers of every lane's row.
template <int N, class Real>
inline __attribute__((always_inline)) void clear_rows(const RowStarts<Real>& rows, std::ptrdiff_t offset) {
  for (int k = 0; k < lane_count<Real>; ++k) {
#ifdef __AVX512F__
    if constexpr (lane_count<Real> == 8 && N == 8) {
      _mm512_storeu_pd(rows.at[k] + offset, _mm512_setzero_pd());
      continue;
    }
#endif
    for (int c = 0; c < N; ++c) rows.at[k][offset + c] = 0;
  }
}

}  // namespace fiberchain::dem
