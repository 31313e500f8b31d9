#pragma once

#include "dem/math/unroll.hpp"
#include "dem/math/vec.hpp"

// Square matrices small enough for registers, for any number type.
namespace fiberchain::dem {

template <class Real, int N>
struct Square {
  Real c[N][N];

  constexpr Real* operator[](int i) { return c[i]; }
  constexpr const Real* operator[](int i) const { return c[i]; }
};

template <class Real, int N>
constexpr Square<Real, N> zero_matrix() {
  Square<Real, N> zero;
  FIBERCHAIN_UNROLL
  for (int i = 0; i < N; ++i) {
    FIBERCHAIN_UNROLL
    for (int j = 0; j < N; ++j) zero[i][j] = Real(0.0);
  }
  return zero;
}

template <class Real, int N>
constexpr Square<Real, N> diagonal_matrix(const Vec<Real, N>& diagonal) {
  Square<Real, N> A = zero_matrix<Real, N>();
  FIBERCHAIN_UNROLL
  for (int i = 0; i < N; ++i) A[i][i] = diagonal[i];
  return A;
}

template <class Real, int N>
constexpr Vec<Real, N> operator*(const Square<Real, N>& A, const Vec<Real, N>& x) {
  Vec<Real, N> y;
  FIBERCHAIN_UNROLL
  for (int i = 0; i < N; ++i) {
    y[i] = A[i][0] * x[0];
    FIBERCHAIN_UNROLL
    for (int j = 1; j < N; ++j) y[i] = y[i] + A[i][j] * x[j];
  }
  return y;
}

template <class Real, int N>
constexpr Square<Real, N> operator*(const Square<Real, N>& A, const Square<Real, N>& B) {
  Square<Real, N> C;
  FIBERCHAIN_UNROLL
  for (int i = 0; i < N; ++i) {
    FIBERCHAIN_UNROLL
    for (int j = 0; j < N; ++j) {
      C[i][j] = A[i][0] * B[0][j];
      FIBERCHAIN_UNROLL
      for (int k = 1; k < N; ++k) C[i][j] = C[i][j] + A[i][k] * B[k][j];
    }
  }
  return C;
}

template <class Real, int N>
constexpr Square<Real, N> operator+(Square<Real, N> A, const Square<Real, N>& B) {
  FIBERCHAIN_UNROLL
  for (int i = 0; i < N; ++i) {
    FIBERCHAIN_UNROLL
    for (int j = 0; j < N; ++j) A[i][j] = A[i][j] + B[i][j];
  }
  return A;
}

template <class Real, int N>
constexpr Square<Real, N> operator-(Square<Real, N> A, const Square<Real, N>& B) {
  FIBERCHAIN_UNROLL
  for (int i = 0; i < N; ++i) {
    FIBERCHAIN_UNROLL
    for (int j = 0; j < N; ++j) A[i][j] = A[i][j] - B[i][j];
  }
  return A;
}

template <class Real, int N>
constexpr Square<Real, N> transposed(const Square<Real, N>& A) {
  Square<Real, N> T;
  FIBERCHAIN_UNROLL
  for (int i = 0; i < N; ++i) {
    FIBERCHAIN_UNROLL
    for (int j = 0; j < N; ++j) T[i][j] = A[j][i];
  }
  return T;
}

/// L D L^T of a symmetric positive definite matrix, in place: L below the diagonal, 1 / D on it.
template <class Real, int N>
constexpr void factorize(Square<Real, N>& A) {
  FIBERCHAIN_UNROLL
  for (int j = 0; j < N; ++j) {
    FIBERCHAIN_UNROLL
    for (int k = 0; k < j; ++k) {
      const Real scaled = A[j][k] * A[k][k];  // l_jk, from l_jk d_k
      A[j][j] = A[j][j] - A[j][k] * scaled;
      FIBERCHAIN_UNROLL
      for (int i = j + 1; i < N; ++i) A[i][j] = A[i][j] - A[i][k] * scaled;
      A[j][k] = scaled;
    }
    A[j][j] = Real(1.0) / A[j][j];
  }
}

/// Solves with the factors of factorize().
template <class Real, int N>
constexpr Vec<Real, N> solved(const Square<Real, N>& factors, Vec<Real, N> b) {
  FIBERCHAIN_UNROLL
  for (int i = 1; i < N; ++i) {
    FIBERCHAIN_UNROLL
    for (int k = 0; k < i; ++k) b[i] = b[i] - factors[i][k] * b[k];
  }
  FIBERCHAIN_UNROLL
  for (int i = N - 1; i >= 0; --i) {
    b[i] = b[i] * factors[i][i];
    FIBERCHAIN_UNROLL
    for (int k = i + 1; k < N; ++k) b[i] = b[i] - factors[k][i] * b[k];
  }
  return b;
}

template <class Real, int N>
constexpr Square<Real, N> solved(const Square<Real, N>& factors, const Square<Real, N>& B) {
  Square<Real, N> X;
  FIBERCHAIN_UNROLL
  for (int j = 0; j < N; ++j) {
    Vec<Real, N> column;
    FIBERCHAIN_UNROLL
    for (int i = 0; i < N; ++i) column[i] = B[i][j];
    column = solved(factors, column);
    FIBERCHAIN_UNROLL
    for (int i = 0; i < N; ++i) X[i][j] = column[i];
  }
  return X;
}

template <class Real>
constexpr Square<Real, 1> inverse(const Square<Real, 1>& A) {
  return {{{Real(1.0) / A[0][0]}}};
}

/// By the adjugate.
template <class Real>
constexpr Square<Real, 3> inverse(const Square<Real, 3>& A) {
  const auto row = [&](int i) { return Vec<Real, 3>{A[i][0], A[i][1], A[i][2]}; };
  const Vec<Real, 3> a = cross(row(1), row(2)), b = cross(row(2), row(0)), c = cross(row(0), row(1));
  const Real scale = Real(1.0) / dot(row(0), a);
  Square<Real, 3> X;
  FIBERCHAIN_UNROLL
  for (int i = 0; i < 3; ++i) {
    X[i][0] = scale * a[i];
    X[i][1] = scale * b[i];
    X[i][2] = scale * c[i];
  }
  return X;
}

}  // namespace fiberchain::dem
