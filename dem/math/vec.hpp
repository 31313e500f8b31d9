#pragma once

#include <cmath>

// A vector small enough to stay in registers, for any number type: double, a SIMD pack, a dual number.
namespace fiberchain::dem {

template <class Real, int N>
struct Vec {
  Real c[N];

  constexpr Real& operator[](int i) { return c[i]; }
  constexpr const Real& operator[](int i) const { return c[i]; }
};

/// Angular quantities have one component in the plane (about z) and three in space.
template <int Dim>
inline constexpr int spin_size = Dim == 2 ? 1 : 3;

template <class Real, int Dim>
using Spin = Vec<Real, spin_size<Dim>>;

template <class Real, int N>
constexpr Vec<Real, N> operator+(Vec<Real, N> a, const Vec<Real, N>& b) {
  for (int i = 0; i < N; ++i) a[i] = a[i] + b[i];
  return a;
}

template <class Real, int N>
constexpr Vec<Real, N> operator-(Vec<Real, N> a, const Vec<Real, N>& b) {
  for (int i = 0; i < N; ++i) a[i] = a[i] - b[i];
  return a;
}

template <class Real, int N>
constexpr Vec<Real, N> operator*(const Real& s, Vec<Real, N> a) {
  for (int i = 0; i < N; ++i) a[i] = s * a[i];
  return a;
}

template <class Real, int N>
constexpr Vec<Real, N> operator-(Vec<Real, N> a) {
  for (int i = 0; i < N; ++i) a[i] = -a[i];
  return a;
}

template <class Real, int N>
constexpr Real dot(const Vec<Real, N>& a, const Vec<Real, N>& b) {
  Real sum = a[0] * b[0];
  for (int i = 1; i < N; ++i) sum = sum + a[i] * b[i];
  return sum;
}

template <class Real>
constexpr Vec<Real, 3> cross(const Vec<Real, 3>& a, const Vec<Real, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// u + a x b, every product added as it is made: two fused operations a component where there are such.
template <class Real>
constexpr Vec<Real, 3> plus_cross(const Vec<Real, 3>& u, const Vec<Real, 3>& a, const Vec<Real, 3>& b) {
  return {(u[0] + a[1] * b[2]) - a[2] * b[1], (u[1] + a[2] * b[0]) - a[0] * b[2],
          (u[2] + a[0] * b[1]) - a[1] * b[0]};
}

/// Two vectors in the plane: the component about z.
template <class Real>
constexpr Vec<Real, 1> cross(const Vec<Real, 2>& a, const Vec<Real, 2>& b) {
  return {a[0] * b[1] - a[1] * b[0]};
}

/// Spin about z times a vector in the plane.
template <class Real>
constexpr Vec<Real, 2> cross(const Vec<Real, 1>& w, const Vec<Real, 2>& b) {
  return {-(w[0] * b[1]), w[0] * b[0]};
}

template <class Real, int N>
Real norm(const Vec<Real, N>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

}  // namespace fiberchain::dem
