#include "dem/equilibrium/stability.hpp"

#include <algorithm>
#include <cmath>

#include "dem/chain/pivots.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

template <int Dim>
double unit_stiffness(const Chain<Dim>& chain) {
  return bending_stiffness(chain.fiber) / fiber_length(chain.fiber);
}

/// W of one sphere.
template <int Dim>
SphereVector<Dim> weights(const Chain<Dim>& chain) {
  const double length = fiber_length(chain.fiber);
  SphereVector<Dim> w = SphereVector<Dim>::Ones();
  w.template head<Dim>().setConstant(1 / (length * length));
  return w;
}

template <int Dim>
bool is_clamped(const Boundary<Dim>& boundary, int sphere) {
  return std::ranges::find(boundary.clamped, sphere) != boundary.clamped.end();
}

template <int Dim>
ChainVector<Dim> weighted(const Chain<Dim>& chain, ChainVector<Dim> v) {
  const SphereVector<Dim> w = unit_stiffness(chain) * weights(chain);
  for (auto& x : v) x = x.cwiseProduct(w);
  return v;
}

template <int Dim>
void scale(ChainVector<Dim>& v, double factor) {
  for (auto& x : v) x *= factor;
}

/// A displacement across a straight chain, in all directions a little, mostly along +y.
template <int Dim>
ChainVector<Dim> sideways(const Poses<Dim>& poses, const Boundary<Dim>& boundary) {
  const int count = static_cast<int>(poses.size());
  ChainVector<Dim> v(poses.size(), SphereVector<Dim>::Zero());
  for (int i = 0; i < count; ++i) {
    if (!is_clamped(boundary, i)) v[i][1] = (1 + 0.3 * i) / count;
  }
  return v;
}

/// Lowest eigenvalue by bisection on the count of pivots, between bounds that are doubled until they hold it.
template <int Dim>
double lowest_eigenvalue(const Chain<Dim>& chain, const ChainTangent<Dim>& K, const Boundary<Dim>& boundary) {
  double high = 1;
  while (eigenvalues_below(chain, K, boundary, high) == 0) high *= 2;
  double low = high > 1 ? high / 2 : -1;
  while (eigenvalues_below(chain, K, boundary, low) > 0) low *= 2;
  while (high - low > 1e-6 * std::max(std::abs(low), std::abs(high)) + zero_eigenvalue(chain)) {
    const double middle = 0.5 * (low + high);
    (eigenvalues_below(chain, K, boundary, middle) > 0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

/// K with the smallest shift that makes it positive definite with some distance.
template <int Dim>
ChainTangent<Dim> positive(const Chain<Dim>& chain, const ChainTangent<Dim>& K,
                           const Boundary<Dim>& boundary) {
  if (eigenvalues_below(chain, K, boundary, zero_eigenvalue(chain)) == 0) return K;
  double shift = 1e-3;
  while (eigenvalues_below(chain, K, boundary, -shift) > 0) shift *= 4;
  return shifted(chain, K, boundary, -2 * shift);
}

/// A rotation or displacement over L of more than this in one step leaves the range where the step means
/// anything.
constexpr double longest_descent = 0.3;
constexpr int most_descents = 500;

}  // namespace

template <int Dim>
bool has_potential(const Boundary<Dim>& boundary) {
  if constexpr (Dim == 2) return true;
  return std::ranges::all_of(boundary.loads,
                             [](const Load<Dim>& load) { return dot(load.moment, load.moment) == 0; });
}

template <int Dim>
double potential_energy(const Chain<Dim>& chain, const Poses<Dim>& poses, const Boundary<Dim>& boundary) {
  double energy = elastic_energy(chain, poses);
  for (const Load<Dim>& load : boundary.loads) {
    const Pose<double, Dim>& pose = poses[load.sphere];
    energy -= dot(load.force, pose.position);
    if constexpr (Dim == 2) energy -= load.moment[0] * pose.orientation;
  }
  return energy;
}

template <int Dim>
ChainTangent<Dim> shifted(const Chain<Dim>& chain, ChainTangent<Dim> K, const Boundary<Dim>& boundary,
                          double lambda) {
  const SphereVector<Dim> w = lambda * unit_stiffness(chain) * weights(chain);
  for (int i = 0; i < K.blocks(); ++i) {
    if (!is_clamped(boundary, i)) K.diagonal[i].diagonal() -= w;
  }
  return K;
}

template <int Dim>
int eigenvalues_below(const Chain<Dim>& chain, const ChainTangent<Dim>& K, const Boundary<Dim>& boundary,
                      double lambda) {
  ChainTangent<Dim> A = shifted(chain, K, boundary, lambda);
  for (const int sphere : boundary.clamped) {  // columns as rows: symmetric
    if (sphere > 0) A.upper[sphere - 1].setZero();
    if (sphere + 1 < A.blocks()) A.lower[sphere + 1].setZero();
  }
  return negative_pivots(A);
}

template <int Dim>
double zero_eigenvalue(const Chain<Dim>& chain) {
  const double length = fiber_length(chain.fiber);
  return 1e-9 + 1e-15 * bond_stiffness(chain.fiber).stretch * length * length / unit_stiffness(chain);
}

template <int Dim>
Stability stability_of(const Chain<Dim>& chain, const Poses<Dim>& poses, const Boundary<Dim>& boundary) {
  if (!has_potential(boundary)) return Stability::undecided;
  const ChainTangent<Dim> K = stiffness(chain, poses, boundary);
  const double zero = zero_eigenvalue(chain);
  if (eigenvalues_below(chain, K, boundary, zero) == 0) return Stability::stable;
  return eigenvalues_below(chain, K, boundary, -zero) > 0 ? Stability::unstable : Stability::neutral;
}

template <int Dim>
LowestMode<Dim> lowest_mode(const Chain<Dim>& chain, const Poses<Dim>& poses, const Boundary<Dim>& boundary) {
  const ChainTangent<Dim> K = stiffness(chain, poses, boundary);
  const double lambda = lowest_eigenvalue(chain, K, boundary);
  const ChainFactors<sphere_motions<Dim>> factors(
      shifted(chain, K, boundary, lambda - 1e-4 * std::max(std::abs(lambda), 1e-3)));
  ChainVector<Dim> v = sideways(poses, boundary);
  for (int n = 0; n < 12; ++n) {
    v = weighted(chain, v);
    for (const int sphere : boundary.clamped) v[sphere].setZero();
    factors.solve_in_place(v);
    scale<Dim>(v, 1 / size_of<Dim>(v, fiber_length(chain.fiber)));
  }
  if (dot_product<Dim>(v, sideways(poses, boundary)) < 0) scale<Dim>(v, -1);
  return {lambda, v};
}

template <int Dim>
Poses<Dim> descend(const Chain<Dim>& chain, Poses<Dim> poses, const Boundary<Dim>& boundary, double tolerance,
                   int& iterations) {
  const double length = fiber_length(chain.fiber);
  double energy = potential_energy(chain, poses, boundary);
  for (int n = 0; n < most_descents; ++n) {
    ChainVector<Dim> step = net_forces(chain, poses, boundary, 1.0);
    const ChainVector<Dim> force = step;
    solve_in_place(positive(chain, stiffness(chain, poses, boundary), boundary), step);
    ++iterations;
    const double size = size_of<Dim>(step, length);
    if (!(size < 1e300)) break;
    if (size < tolerance) return poses;
    if (size > longest_descent) scale<Dim>(step, longest_descent / size);
    // the energy cannot tell steps apart that change it by less than its own rounding
    const double expected = dot_product<Dim>(force, step), rounding = 1e-13 * std::abs(energy);
    for (int halving = 0; halving < 40; ++halving, scale<Dim>(step, 0.5)) {
      Poses<Dim> next = poses;
      move(chain, boundary, next, step);
      const double there = potential_energy(chain, next, boundary);
      if (there <= energy + rounding - 1e-4 * std::ldexp(expected, -halving)) {
        poses = std::move(next);
        energy = there;
        break;
      }
      if (halving == 39)
        throw NoConvergence("no stable equilibrium found: the potential energy falls no more");
    }
  }
  throw NoConvergence("no stable equilibrium found by falling potential energy");
}

#define FIBERCHAIN_INSTANTIATE(Dim)                                                                      \
  template bool has_potential<Dim>(const Boundary<Dim>&);                                                \
  template double potential_energy<Dim>(const Chain<Dim>&, const Poses<Dim>&, const Boundary<Dim>&);     \
  template int eigenvalues_below<Dim>(const Chain<Dim>&, const ChainTangent<Dim>&, const Boundary<Dim>&, \
                                      double);                                                           \
  template ChainTangent<Dim> shifted<Dim>(const Chain<Dim>&, ChainTangent<Dim>, const Boundary<Dim>&,    \
                                          double);                                                       \
  template double zero_eigenvalue<Dim>(const Chain<Dim>&);                                               \
  template Stability stability_of<Dim>(const Chain<Dim>&, const Poses<Dim>&, const Boundary<Dim>&);      \
  template LowestMode<Dim> lowest_mode<Dim>(const Chain<Dim>&, const Poses<Dim>&, const Boundary<Dim>&); \
  template Poses<Dim> descend<Dim>(const Chain<Dim>&, Poses<Dim>, const Boundary<Dim>&, double, int&);
FIBERCHAIN_INSTANTIATE(2)
FIBERCHAIN_INSTANTIATE(3)
#undef FIBERCHAIN_INSTANTIATE

}  // namespace fiberchain::dem
