#pragma once

#include <cmath>

// 1 / sqrt(q) and atan(x) / x where the argument is nearly always close to one value: polynomials that a
// processor takes a fraction of the time for, with the exact function where the argument is not close. Every
// lane decides for itself, so that a result does not depend on its neighbors or on how many there are.
namespace fiberchain::dem {

constexpr double select(bool condition, double yes, double no) { return condition ? yes : no; }
constexpr bool all(bool condition) { return condition; }

/// Number types with comparisons by lane; others (dual numbers) take the exact function always.
template <class Real>
concept Selectable = requires(const Real& a) {
  select(a < a, a, a);
  all(a < a);
};

/// Horner's scheme, coefficients from the constant term on.
template <class Real>
constexpr Real polynomial(const Real&, double last) {
  return Real(last);
}

template <class Real, class... More>
constexpr Real polynomial(const Real& x, double first, More... more) {
  return Real(first) + x * polynomial(x, more...);
}

/// 1 / sqrt(q) to round-off; fast for |q - 1| < 0.08.
template <class Real>
Real inverse_sqrt_near_one(const Real& q) {
  using std::sqrt;
  if constexpr (Selectable<Real>) {
    const Real h = q - Real(1.0);
    // minimax, within 1.41e-6; then one step of third order, 7e-18
    const Real guess =
        polynomial(h, 0.99999859089844625, -0.49999703796270046, 0.37675864755959006, -0.31443586184350294);
    const Real rest = Real(1.0) - q * (guess * guess);
    const Real close = guess + guess * (rest * (Real(0.5) + Real(0.375) * rest));
    const auto near = h * h < Real(0.08 * 0.08);
    if (all(near)) [[likely]]
      return close;
    return select(near, close, Real(1.0) / sqrt(q));
  } else {
    return Real(1.0) / sqrt(q);
  }
}

/// (1 - t)^(-1/2) for t that vanishes with the step; what is left out is of fourth order.
template <class Real>
Real inverse_sqrt_below_one(const Real& t) {
  return polynomial(t, 1.0, 0.5, 0.375, 0.3125);
}

/// atan(x) / x as a function of x^2, smooth at zero; fast for |x| < 0.2.
template <class Real>
Real atan_ratio(const Real& x_squared) {
  using std::atan;
  using std::sqrt;
  const auto exact = [&] {
    const Real x = sqrt(x_squared + Real(1e-300));
    return atan(x) / x;
  };
  if constexpr (Selectable<Real>) {
    const Real series = polynomial(x_squared, 1.0, -1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11, 1.0 / 13,
                                   -1.0 / 15, 1.0 / 17, -1.0 / 19, 1.0 / 21);
    const auto near = x_squared < Real(0.04);
    if (all(near)) [[likely]]
      return series;
    return select(near, series, exact());
  } else {
    return exact();
  }
}

}  // namespace fiberchain::dem
