#pragma once

#include <cstddef>
#include <type_traits>

// Value types of the inner loops (poses, spheres, bond histories, parameters) consist of numbers of one type
// and nothing else: an array of them is an array of numbers, in lanes or in rows. This header holds the only
// casts between the two.
namespace fiberchain::dem {

/// Numbers of type Real that a value type consists of; none for an empty type.
template <class Value, class Real = double>
inline constexpr std::size_t numbers_of = std::is_empty_v<Value> ? 0 : sizeof(Value) / sizeof(Real);

/// Whether a type consists of whole numbers of type Real, or of nothing.
template <class Value, class Real>
constexpr bool is_made_of =
    std::is_trivially_copyable_v<Value> && !std::is_pointer_v<Value> &&
    (std::is_empty_v<Value> || (sizeof(Value) % sizeof(Real) == 0 && alignof(Value) >= alignof(Real)));

/// The numbers of a value, in the order of its members.
template <class Real, class Value>
Real* as_numbers(Value& value) {
  static_assert(is_made_of<Value, Real>, "numbers only, without padding");
  return reinterpret_cast<Real*>(&value);
}

template <class Real, class Value>
const Real* as_numbers(const Value& value) {
  static_assert(is_made_of<Value, Real>, "numbers only, without padding");
  return reinterpret_cast<const Real*>(&value);
}

/// An array of numbers as an array of values; of SIMD packs where the value consists of them (aligned as
/// LaneArray is).
template <class Value, class Real>
Value* as_values(Real* numbers) {
  static_assert(is_made_of<Value, Real>, "numbers only, without padding");
  return reinterpret_cast<Value*>(numbers);
}

template <class Value, class Real>
const Value* as_values(const Real* numbers) {
  static_assert(is_made_of<Value, Real>, "numbers only, without padding");
  return reinterpret_cast<const Value*>(numbers);
}

/// A value whose numbers stand `stride` doubles apart from `first` on.
template <class Value>
Value get_strided(const double* first, std::size_t stride) {
  Value value{};
  double* numbers = as_numbers<double>(value);
  for (std::size_t n = 0; n < numbers_of<Value>; ++n) numbers[n] = first[n * stride];
  return value;
}

template <class Value>
void put_strided(const Value& value, double* first, std::size_t stride) {
  const double* numbers = as_numbers<double>(value);
  for (std::size_t n = 0; n < numbers_of<Value>; ++n) first[n * stride] = numbers[n];
}

}  // namespace fiberchain::dem
