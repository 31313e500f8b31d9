#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include "dem/simd/as_numbers.hpp"
#include "dem/simd/gather.hpp"
#include "dem/simd/transpose.hpp"

// Templates on the number type that consist of numbers only (a law's Parameters and History, a wall's shape):
// with doubles they are a row of numbers in memory, with packs a lane each.
namespace fiberchain::dem {

/// Numbers of such a template.
template <template <class> class Struct>
inline constexpr int numbers_in = sizeof(Struct<double>) / sizeof(double);

template <class Real, template <class> class Struct>
Real* pack_numbers(Struct<Real>& value) {
  static_assert(sizeof(Struct<Real>) == numbers_in<Struct> * sizeof(Real) &&
                std::is_standard_layout_v<Struct<double>>);
  return as_numbers<Real>(value);
}

/// The same numbers in every lane.
template <template <class> class Struct, class Real>
Struct<Real> broadcast(const double* numbers) {
  Struct<Real> value;
  Real* out = pack_numbers<Real, Struct>(value);
  for (int n = 0; n < numbers_in<Struct>; ++n) out[n] = Real(numbers[n]);
  return value;
}

/// Number entry[k] of a table in lane k.
template <template <class> class Struct, class Real>
Struct<Real> gather(const double* table, const std::int32_t* entry) {
  std::int32_t index[lane_count<Real>];
  for (int k = 0; k < lane_count<Real>; ++k) index[k] = entry[k] * numbers_in<Struct>;
  Struct<Real> value;
  Real* out = pack_numbers<Real, Struct>(value);
  for (int n = 0; n < numbers_in<Struct>; ++n) out[n] = gather_lanes<Real>(table + n, index);
  return value;
}

/// From rows of `size` numbers, one a lane, the first of which are the value's.
template <int size, template <class> class Struct, class Real>
Struct<Real> load_struct(const RowStarts<Real>& rows) {
  static_assert(numbers_in<Struct> <= size);
  Real row[size];
  load_rows<size>(rows, 0, row);
  Struct<Real> value;
  Real* out = pack_numbers<Real, Struct>(value);
  for (int n = 0; n < numbers_in<Struct>; ++n) out[n] = row[n];
  return value;
}

/// The way back, zeros behind.
template <int size, template <class> class Struct, class Real>
void store_struct(Struct<Real> value, const RowStarts<Real>& rows) {
  const Real* in = pack_numbers<Real, Struct>(value);
  Real row[size];
  for (int n = 0; n < size; ++n) row[n] = n < numbers_in<Struct> ? in[n] : Real(0.0);
  store_rows<size>(row, rows, 0);
}

}  // namespace fiberchain::dem
