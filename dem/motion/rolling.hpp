#pragma once

#include "dem/math/small_matrix.hpp"
#include "dem/motion/bond_step.hpp"

// Rolling friction of the bonds, T_r = xi_r |F_n| R/2 against the relative spin w (Eq 21), as a set-valued
// law: at w = 0 any moment up to T_r. With l the angular impulse over J, taken from one sphere of a bond and
// given to the other, and the ball of radius r = dt T_r / J: l = proj(l + w / a), a the number of its spheres
// that are free to turn, an end sphere of half the inertia counting twice. As w = w_free - a l + l_before +
// l_after this is l = proj((w_free + l_before + l_after) / a), solved by Newton's method, its matrix
// eliminated along the chain.
namespace fiberchain::dem {

/// Projection of p onto the ball and its derivative G: the identity inside, (r / |p|)(I - n n^T) outside.
template <class Real, int S>
struct Projection {
  Vec<Real, S> value;
  Square<Real, S> derivative;
};

template <class Real, int S>
Projection<Real, S> project(const Vec<Real, S>& p, const Real& radius) {
  const Real squared = dot(p, p);
  const auto outside = squared > radius * radius;
  const Real size = select(outside, squared, Real(1.0));
  using std::sqrt;
  const Real inverse = Real(1.0) / sqrt(size);
  const Real scale = select(outside, radius * inverse, Real(1.0));
  const Real take = select(outside, scale * inverse * inverse, Real(0.0));
  Projection<Real, S> result{scale * p, {}};
  for (int i = 0; i < S; ++i) {
    for (int j = 0; j < S; ++j) result.derivative[i][j] = (i == j ? scale : Real(0.0)) - take * p[i] * p[j];
  }
  return result;
}

/// In the plane the ball is an interval: no root, no quotient.
template <class Real>
Projection<Real, 1> project(const Vec<Real, 1>& p, const Real& radius) {
  const auto above = p[0] > radius, below = p[0] < -radius;
  Projection<Real, 1> result{{select(above, radius, select(below, -radius, p[0]))}, {}};
  result.derivative[0][0] = select(above || below, Real(0.0), Real(1.0));
  return result;
}

template <Physics P, class Real>
Spin<Real, P.dimension> neighbors(const ChainBlock<P, Real>& chain, int bond) {
  const auto* slots = rolling_slots(chain);
  Spin<Real, P.dimension> sum = slots[bond].free;
  if (bond > 0 && !chain.fixed(bond)) sum = sum + slots[bond - 1].impulse;
  if (bond + 1 < chain.bonds && !chain.fixed(bond + 1)) sum = sum + slots[bond + 1].impulse;
  return sum;
}

/// Spin that a sphere gets of l, in parts of what one between the ends gets.
template <Physics P, class Real>
Real turning(const ChainBlock<P, Real>& chain, int sphere) {
  if (chain.fixed(sphere)) return Real(0.0);
  return chain.is_end(sphere) ? Real(1.0) / chain.parameters.end_share : Real(1.0);
}

/// 1 / a
template <Physics P, class Real>
Real mobility(const ChainBlock<P, Real>& chain, int bond) {
  if (chain.fixed(bond) && chain.fixed(bond + 1)) return Real(0.0);
  return Real(1.0) / (turning(chain, bond) + turning(chain, bond + 1));
}

/// Largest error of an impulse over its limit.
inline constexpr double rolling_tolerance = 1e-10;

template <class Real, int S>
auto within_tolerance(const Vec<Real, S>& off, const Real& limit) {
  const Real allowed = Real(rolling_tolerance) * limit;
  return !(dot(off, off) > allowed * allowed);
}

/// Whether a bond's equation holds with the impulse `l` and those of its neighbors.
template <Physics P, class Real>
auto is_solved(const ChainBlock<P, Real>& chain, int bond, const Spin<Real, P.dimension>& before,
               const Spin<Real, P.dimension>& l, const Spin<Real, P.dimension>& after) {
  const auto& slot = rolling_slots(chain)[bond];
  Spin<Real, P.dimension> sum = slot.free;
  if (bond > 0 && !chain.fixed(bond)) sum = sum + before;
  if (bond + 1 < chain.bonds && !chain.fixed(bond + 1)) sum = sum + after;
  return within_tolerance(project(mobility(chain, bond) * sum, slot.limit).value - l, slot.limit);
}

/// One Newton iteration for all bonds; a lane that is done keeps its impulses. Returns which lanes are done:
/// those whose impulses no longer change, in the plane those that solve the equations, which are linear there
/// until a bond begins or ceases to slide.
template <Physics P, class Real>
auto rolling_iteration(const ChainBlock<P, Real>& chain, const decltype(Real(0.0) > Real(0.0))& done) {
  constexpr int S = spin_size<P.dimension>;
  auto* slots = rolling_slots(chain);
  // with both ends clamped and every bond sticking the impulses are known but for a common one: any will do,
  // and the matrix is kept from being singular
  const Real firm = Real(chain.clamps.first && chain.clamps.last ? 1 - 1e-9 : 1.0);
  for (int i = 0; i < chain.bonds; ++i) {
    const Real share = mobility(chain, i);
    const Projection<Real, S> q = project(share * neighbors(chain, i), slots[i].limit);
    Square<Real, S> B = q.derivative;
    for (int r = 0; r < S; ++r) {
      for (int c = 0; c < S; ++c) B[r][c] = firm * share * B[r][c];
    }
    // l = q + B (change of the neighbors); forward part, the next neighbor left open
    Vec<Real, S> known = q.value;
    Vec<Real, S> around{};
    for (Real& c : around.c) c = Real(0.0);
    const bool has_before = i > 0 && !chain.fixed(i), has_after = i + 1 < chain.bonds && !chain.fixed(i + 1);
    if (has_before) around = around - slots[i - 1].impulse;
    if (has_after) around = around - slots[i + 1].impulse;
    Square<Real, S> A = zero_matrix<Real, S>();
    for (int r = 0; r < S; ++r) A[r][r] = Real(1.0);
    if (has_before) {
      around = around + slots[i - 1].forward;
      A = A - B * slots[i - 1].coupling;
    }
    const Square<Real, S> K = inverse(A);
    slots[i].forward = K * (known + B * around);
    slots[i].coupling = has_after ? K * B : zero_matrix<Real, S>();
  }
  Vec<Real, S> next{};
  for (Real& c : next.c) c = Real(0.0);
  Vec<Real, S> after = next, last = next;
  auto settled = Real(0.0) < Real(1.0), solved = settled;
  for (int i = chain.bonds - 1; i >= 0; --i) {
    after = last, last = next;
    next = slots[i].forward + slots[i].coupling * next;
    if constexpr (S == 1) {
      if (i + 1 < chain.bonds) solved = solved && is_solved(chain, i + 1, next, last, after);
    }
    settled = settled && within_tolerance(next - slots[i].impulse, slots[i].limit);
    for (int c = 0; c < S; ++c) slots[i].impulse[c] = select(done, slots[i].impulse[c], next[c]);
  }
  if constexpr (S == 1) {
    solved = solved && is_solved(chain, 0, next, next, last);
    settled = settled || solved;
  }
  return done || settled;
}

/// Gauss-Seidel on the same equations: always converges, slowly; for the rare step on which Newton circles.
template <Physics P, class Real>
void rolling_sweep(const ChainBlock<P, Real>& chain) {
  constexpr int S = spin_size<P.dimension>;
  auto* slots = rolling_slots(chain);
  for (int i = 0; i < chain.bonds; ++i) {
    slots[i].impulse = project<Real, S>(mobility(chain, i) * neighbors(chain, i), slots[i].limit).value;
  }
}

/// Spins of the spheres are those without rolling friction before, with it after.
template <Physics P, class Real>
void kick_with_rolling(const ChainBlock<P, Real>& chain) {
  auto* slots = rolling_slots(chain);
  for (int i = 0; i < chain.bonds; ++i) slots[i].free = chain.spheres[i + 1].spin - chain.spheres[i].spin;
  constexpr int newton = 30, sweeps = 300;
  auto done = Real(1.0) < Real(0.0);
  int n = 0;
  for (; n < newton && !all(done); ++n) done = rolling_iteration(chain, done);
  if (n == newton && !all(done)) {
    for (int k = 0; k < sweeps; ++k) rolling_sweep(chain);
  }
  for (int i = 0; i < chain.bonds; ++i) {
    MovingSphere<Real, P.dimension>&a = chain.spheres[i], &b = chain.spheres[i + 1];
    if (!chain.fixed(i)) a.spin = a.spin + turning(chain, i) * slots[i].impulse;
    if (!chain.fixed(i + 1)) b.spin = b.spin - turning(chain, i + 1) * slots[i].impulse;
  }
}

}  // namespace fiberchain::dem
