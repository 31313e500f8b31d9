#pragma once

#include "dem/math/near_one.hpp"
#include "dem/math/vec.hpp"

namespace fiberchain::dem {

/// Unit quaternion: rotation by 2 acos(w) about v.
template <class Real>
struct Quaternion {
  Real w;
  Vec<Real, 3> v;
};

template <class Real>
Quaternion<Real> operator*(const Quaternion<Real>& a, const Quaternion<Real>& b) {
  return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}

template <class Real>
Quaternion<Real> conjugate(const Quaternion<Real>& q) {
  return {q.w, -q.v};
}

template <class Real>
Quaternion<Real> normalized(const Quaternion<Real>& q) {
  using std::sqrt;
  const Real scale = Real(1.0) / sqrt(q.w * q.w + dot(q.v, q.v));
  return {scale * q.w, scale * q.v};
}

/// q u q*: two cross products.
template <class Real>
Vec<Real, 3> rotate(const Quaternion<Real>& q, const Vec<Real, 3>& u) {
  const Vec<Real, 3> t = Real(2.0) * cross(q.v, u);
  return u + q.w * t + cross(q.v, t);
}

/// Rotation by the vector phi, exact: exp(phi / 2).
inline Quaternion<double> rotation(const Vec<double, 3>& phi) {
  const double half = norm(phi) / 2;
  const double s = half > 1e-8 ? std::sin(half) / (2 * half) : 0.5;
  return {std::cos(half), s * phi};
}

/// Rotation vector of q, of at most pi.
inline Vec<double, 3> rotation_vector(Quaternion<double> q) {
  if (q.w < 0) q = {-q.w, -q.v};
  const double s = norm(q.v);
  return (s > 1e-12 ? 2 * std::atan2(s, q.w) / s : 2.0) * q.v;
}

/// Rotation whose half-angle tangent vector is b (Cayley): exact in direction, angle 2 atan |b|.
template <class Real>
Quaternion<Real> cayley_turn(const Vec<Real, 3>& b, const Quaternion<Real>& q) {
  const Quaternion<Real> turned = Quaternion<Real>{Real(1.0), b} * q;
  const Real scale = inverse_sqrt_near_one(turned.w * turned.w + dot(turned.v, turned.v));
  return {scale * turned.w, scale * turned.v};
}

}  // namespace fiberchain::dem
