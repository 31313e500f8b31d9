// The kick of rolling friction: the inner loop's solution against brute force and Coulomb's law bond by bond.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "dem/motion/leapfrog.hpp"

BOOST_AUTO_TEST_SUITE(rolling_kick_test)

namespace dem = fiberchain::dem;
using dem::Rolling;

namespace {

constexpr dem::Physics rolling_physics(int dimension, Rolling law) {
  return {dimension, dem::BondForm::incremental, true, false, false, dem::Solved::nothing, law};
}

}  // namespace

namespace {

/// Spins, limits and clamps of one kick, and its solutions.
template <int Dim>
struct Kick {
  static constexpr int S = dem::spin_size<Dim>;
  using V = dem::Vec<double, S>;
  std::vector<V> spin;
  std::vector<double> limit;
  dem::Clamps clamps;
  double end_share = 1;  ///< of an end sphere's inertia

  double inertia(int i) const { return i == 0 || i == bonds() ? end_share : 1.0; }
  int bonds() const { return static_cast<int>(limit.size()); }
  bool fixed(int i) const { return (i == 0 && clamps.first) || (i == bonds() && clamps.last); }

  std::vector<V> after(const std::vector<V>& impulse) const {
    std::vector<V> s = spin;
    for (int i = 0; i < bonds(); ++i) {
      if (!fixed(i)) s[i] = s[i] + (1 / inertia(i)) * impulse[i];
      if (!fixed(i + 1)) s[i + 1] = s[i + 1] - (1 / inertia(i + 1)) * impulse[i];
    }
    return s;
  }

  /// As the inner loop does it.
  std::vector<V> solved(std::vector<V>* impulses = nullptr) const {
    std::vector<dem::MovingSphere<double, Dim>> spheres(spin.size());
    std::vector<dem::RollingSlot<double, Dim>> slots(limit.size());
    for (std::size_t i = 0; i < spin.size(); ++i) spheres[i].spin = spin[i];
    for (std::size_t i = 0; i < limit.size(); ++i) slots[i] = {limit[i], {}, {}, {}, {}};
    dem::ChainBlock<rolling_physics(Dim, Rolling::set_valued), double> chain{
        bonds(), clamps, spheres.data(), nullptr, nullptr, {}, reinterpret_cast<double*>(slots.data())};
    chain.parameters.end_share = end_share;
    dem::kick_with_rolling(chain);
    std::vector<V> result;
    for (const auto& sphere : spheres) result.push_back(sphere.spin);
    if (impulses != nullptr) {
      for (const auto& slot : slots) impulses->push_back(slot.impulse);
    }
    return result;
  }

  /// The least kinetic energy that impulses within the limits can leave, by accelerated projected gradient:
  /// another statement of the problem and another method.
  std::vector<V> brute_force(int iterations) const {
    std::vector<V> l(limit.size(), V{}), y = l;
    double momentum = 1;
    for (int n = 0; n < iterations; ++n) {
      const std::vector<V> s = after(y), before = l;
      double restart = 0;
      for (int i = 0; i < bonds(); ++i) {
        V gradient{};
        if (!fixed(i)) gradient = gradient + s[i];
        if (!fixed(i + 1)) gradient = gradient - s[i + 1];
        const V free = y[i] - (0.25 * end_share) * gradient;
        const double size = dem::norm(free);
        l[i] = size > limit[i] ? (limit[i] / size) * free : free;
        restart += dem::dot(y[i] - l[i], l[i] - before[i]);
      }
      const double next = restart > 0 ? 1.0 : (1 + std::sqrt(1 + 4 * momentum * momentum)) / 2;
      const double ahead = restart > 0 ? 0.0 : (momentum - 1) / next;
      for (int i = 0; i < bonds(); ++i) y[i] = l[i] + ahead * (l[i] - before[i]);
      momentum = next;
    }
    return after(l);
  }

  double energy(const std::vector<V>& s) const {
    double sum = 0;
    for (int i = 0; i <= bonds(); ++i) sum += fixed(i) ? 0.0 : 0.5 * inertia(i) * dem::dot(s[i], s[i]);
    return sum;
  }
};

/// `reach`: limits over spins. From where almost all bonds slide to where almost all stick.
/// `reach`: limits over spins, from where almost all bonds slide to where almost all stick.
template <int Dim>
Kick<Dim> random_kick(std::mt19937& generator, int bonds, dem::Clamps clamps, double reach) {
  std::normal_distribution<double> normal;
  Kick<Dim> kick{{}, std::vector<double>(bonds), clamps};
  for (double& r : kick.limit) r = 3.7 * reach * std::abs(normal(generator));
  for (int i = 0; i <= bonds; ++i) {
    typename Kick<Dim>::V s{};
    for (double& c : s.c) c = kick.fixed(i) ? 0.0 : 3.7 * normal(generator);
    kick.spin.push_back(s);
  }
  return kick;
}

template <int Dim>
double largest_difference(const std::vector<dem::Spin<double, Dim>>& a,
                          const std::vector<dem::Spin<double, Dim>>& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, dem::norm(a[i] - b[i]));
  return worst;
}

template <int Dim>
void kicks_agree_with_brute_force() {
  std::mt19937 generator(31 + Dim);
  double worst = 0;
  for (const int bonds : {1, 2, 3, 6, 7, 23}) {
    for (const double reach : {0.03, 0.4, 1.0, 3.0, 20.0}) {
      for (const dem::Clamps clamps :
           {dem::Clamps{false, false}, dem::Clamps{true, false}, dem::Clamps{true, true}}) {
        Kick<Dim> kick = random_kick<Dim>(generator, bonds, clamps, reach);
        kick.end_share = bonds % 2 == 0 ? 0.5 : 1.0;
        const auto exact = kick.brute_force(4000);
        const double off = largest_difference<Dim>(kick.solved(), exact) / 3.7;
        BOOST_TEST(off < 1e-8, Dim << "D, " << bonds << " bonds, reach " << reach << ": " << off);
        worst = std::max(worst, off);
      }
    }
  }
  BOOST_TEST_MESSAGE(Dim << "D: largest difference from brute force " << worst);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_kick_leaves_the_least_energy_that_the_limits_allow) {
  kicks_agree_with_brute_force<2>();
  kicks_agree_with_brute_force<3>();
}

namespace {

/// Coulomb's law bond by bond: at the limit and against the relative spin, or within it and no relative spin;
/// angular momentum kept, energy not gained.
template <int Dim>
void kicks_obey_the_law() {
  std::mt19937 generator(77 + Dim);
  double worst = 0;
  int sticking = 0, sliding = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const int bonds = 1 + trial % 61;
    const double reach = std::pow(10.0, -1.5 + 3.0 * ((trial * 37) % 101) / 100.0);
    const dem::Clamps clamps{trial % 3 == 1, trial % 7 == 2};
    const Kick<Dim> kick = random_kick<Dim>(generator, bonds, clamps, reach);
    std::vector<typename Kick<Dim>::V> impulse;
    const auto s = kick.solved(&impulse);
    BOOST_TEST(
        kick.energy(s) <= kick.energy(kick.spin) * (1 + 1e-14),
        Dim << "D, " << bonds << " bonds, clamps " << clamps.first << clamps.last << ", reach " << reach);
    typename Kick<Dim>::V gained{};
    for (int i = 0; i <= bonds; ++i) gained = gained + (s[i] - kick.spin[i]);
    if (!clamps.first && !clamps.last) BOOST_TEST(dem::norm(gained) < 1e-13 * 3.7 * bonds);
    for (int i = 0; i < bonds; ++i) {
      const auto w = s[i + 1] - s[i];
      const double size = dem::norm(w), r = kick.limit[i];
      double off = std::max(dem::norm(impulse[i]) - r, 0.0);
      if (size > 1e-7) off = std::max(off, dem::norm(impulse[i] - (r / size) * w));
      if (dem::norm(impulse[i]) < r * (1 - 1e-7)) off = std::max(off, size);
      size > 1e-7 ? ++sliding : ++sticking;
      if (!kick.fixed(i) || !kick.fixed(i + 1)) worst = std::max(worst, off / 3.7);
    }
  }
  BOOST_TEST_MESSAGE(Dim << "D: largest breach of the law " << worst << ", " << sticking << " stick, "
                         << sliding << " slide");
  BOOST_TEST(worst < 1e-6);
  BOOST_TEST(sticking > 10000);
  BOOST_TEST(sliding > 10000);
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_bond_of_a_kick_slides_at_the_limit_or_sticks) {
  kicks_obey_the_law<2>();
  kicks_obey_the_law<3>();
}

BOOST_AUTO_TEST_SUITE_END()
