// Rigid chains with hydrodynamic interactions: the pair functions from Stokes singularities by differences,
// the free-draining limit, periods known, two spheres known exactly.
#include "reference/rigid_chain_mobility.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/equivalent_aspect_ratio.hpp"
#include "reference/errors.hpp"
#include "reference/jeffery.hpp"

BOOST_AUTO_TEST_SUITE(rigid_chain_mobility_test)

namespace ref = fiberchain::reference;
using ref::ChainCoupling;
using Vector = std::array<double, 3>;
using Tensor = std::array<Vector, 3>;

namespace {

constexpr std::array<ChainCoupling, 3> couplings{ChainCoupling::none, ChainCoupling::force_torque,
                                                 ChainCoupling::force_torque_stresslet};
constexpr double step = 2e-3;

/// Over 6 pi mu: (1 + c laplacian) of the Stokeslet (I/r + rr/r^3)/(8 pi mu).
Vector stokeslet(const Vector& x, const Vector& force, double c) {
  const double r2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  const double r = std::sqrt(r2);
  const double along = (x[0] * force[0] + x[1] * force[1] + x[2] * force[2]) / r2;
  Vector u{};
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = 0.75 * (force[k] + along * x[k] + 2 * c / r2 * (force[k] - 3 * along * x[k])) / r;
  }
  return u;
}

template <class Field>
Vector slope(const Field& field, Vector x, std::size_t direction) {
  const auto at = [&](double k) {
    Vector moved = x;
    moved[direction] += k * step;
    return field(moved);
  };
  const Vector a = at(-2), b = at(-1), c = at(1), d = at(2);
  Vector s{};
  for (std::size_t k = 0; k < 3; ++k) s[k] = (a[k] - 8 * b[k] + 8 * c[k] - d[k]) / (12 * step);
  return s;
}

/// Flow of forces with the moment int x_l f_m = moment[l][m].
Vector dipole(const Vector& x, const Tensor& moment, double c) {
  Vector u{};
  for (std::size_t l = 0; l < 3; ++l) {
    const auto field = [&](const Vector& at) { return stokeslet(at, moment[l], c); };
    const Vector s = slope(field, x, l);
    for (std::size_t k = 0; k < 3; ++k) u[k] -= s[k];
  }
  return u;
}

/// Gradient [k][l] = du_k/dx_l.
template <class Field>
Tensor gradient(const Field& field, const Vector& x) {
  Tensor g{};
  for (std::size_t l = 0; l < 3; ++l) {
    const Vector s = slope(field, x, l);
    for (std::size_t k = 0; k < 3; ++k) g[k][l] = s[k];
  }
  return g;
}

constexpr double force_faxen = 1.0 / 6;
constexpr double strain_faxen = 1.0 / 10;

}  // namespace

BOOST_AUTO_TEST_CASE(pairs_across_follow_from_the_singularities) {
  const Tensor torque{{{0, 0, 0}, {0, 0, 0.5}, {0, -0.5, 0}}};  // y f_z - z f_y = 1
  const Tensor stresslet{{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}}};
  for (const double z : {2.0, -2.3, 3.7, -9.1}) {
    const Vector x{0, 0, z};
    const auto pair = ref::detail::across_pair(z);
    // own size of the acting sphere and of the other: (force, torque, stresslet) and (motion, strain)
    const std::array<double, 3> own{force_faxen, 0, strain_faxen};
    for (std::size_t kind = 0; kind < 3; ++kind) {
      const auto field = [&](const Vector& at, double size) {
        const double c = own[kind] + size;
        return kind == 0 ? stokeslet(at, {0, 1, 0}, c) : dipole(at, kind == 1 ? torque : stresslet, c);
      };
      const auto as_strain = [&](const Vector& at) { return field(at, strain_faxen); };
      const Tensor g = gradient(as_strain, x);
      BOOST_TEST(std::abs(pair[0][kind] - field(x, kind == 1 ? 0 : force_faxen)[1]) < 1e-8,
                 kind << " at " << z);
      BOOST_TEST(std::abs(pair[1][kind] - (g[2][1] - g[1][2]) / 2) < 1e-8, kind << " at " << z);
      BOOST_TEST(std::abs(pair[2][kind] - (g[2][1] + g[1][2])) < 1e-8, kind << " at " << z);
    }
  }
}

BOOST_AUTO_TEST_CASE(pairs_along_follow_from_the_singularities) {
  const Tensor stresslet{{{-0.5, 0, 0}, {0, -0.5, 0}, {0, 0, 1}}};
  for (const double z : {2.0, -2.9, 5.3}) {
    const Vector x{0, 0, z};
    const auto pair = ref::detail::along_pair(z);
    for (std::size_t kind = 0; kind < 2; ++kind) {
      const auto field = [&](const Vector& at, double size) {
        return kind == 0 ? stokeslet(at, {0, 0, 1}, force_faxen + size)
                         : dipole(at, stresslet, strain_faxen + size);
      };
      const Tensor g = gradient([&](const Vector& at) { return field(at, strain_faxen); }, x);
      BOOST_TEST(std::abs(pair[0][kind] - field(x, force_faxen)[2]) < 1e-8, kind << " at " << z);
      BOOST_TEST(std::abs(pair[1][kind] - 1.5 * g[2][2]) < 1e-8, kind << " at " << z);
    }
  }
}

BOOST_AUTO_TEST_CASE(actions_are_reciprocal) {
  for (const double z : {2.0, 4.4}) {
    const auto there = ref::detail::across_pair(z);
    const auto back = ref::detail::across_pair(-z);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t l = 0; l < 3; ++l) BOOST_TEST(there[k][l] == back[l][k]);
    }
    BOOST_TEST(ref::detail::along_pair(z)[0][1] == ref::detail::along_pair(-z)[1][0]);
  }
}

BOOST_AUTO_TEST_CASE(free_draining_is_exact) {
  for (const int n : {2, 3, 13, 50, 101}) {
    const ref::RigidChain chain{n, ChainCoupling::none};
    BOOST_TEST(ref::rigid_chain_bretherton(chain) == ref::free_draining_bretherton(n),
               boost::test_tools::tolerance(1e-13));
    BOOST_TEST(
        ref::rigid_chain_period(chain, 1.7) == ref::jeffery_period(ref::free_draining_aspect_ratio(n), 1.7),
        boost::test_tools::tolerance(1e-9));
    const auto resistance = ref::rigid_chain_resistance(chain);
    const double number = n;
    const auto tolerance = boost::test_tools::tolerance(1e-13);
    BOOST_TEST(resistance.along == number, tolerance);
    BOOST_TEST(resistance.across == number, tolerance);
    BOOST_TEST(resistance.turning == number * (number * number + 3) / 4, tolerance);
    BOOST_TEST(resistance.spin == number, tolerance);
  }
}

BOOST_AUTO_TEST_CASE(known_periods) {
  using Known = std::pair<int, double>;
  for (const auto& [n, period] :
       {Known{5, 28.77}, {10, 50.71}, {11, 55.01}, {20, 92.82}, {30, 133.61}, {50, 213.03}}) {
    const double found = ref::rigid_chain_period({n, ChainCoupling::force_torque}, 1);
    BOOST_TEST(std::abs(found - period) < 0.0051, n << ": " << found);
  }
  for (const auto& [n, period] :
       {Known{5, 29.98}, {10, 53.26}, {11, 57.82}, {20, 97.86}, {30, 141.03}, {50, 225.06}}) {
    const double found = ref::rigid_chain_period({n, ChainCoupling::force_torque_stresslet}, 1);
    BOOST_TEST(std::abs(found - period) < 0.0051, n << ": " << found);
  }
}

BOOST_AUTO_TEST_CASE(one_sphere) {
  for (const ChainCoupling coupling : couplings) {
    BOOST_TEST(ref::rigid_chain_bretherton({1, coupling}) == 0);
    const auto resistance = ref::rigid_chain_resistance({1, coupling});
    for (const double each : {resistance.along, resistance.across, resistance.turning, resistance.spin}) {
      BOOST_TEST(each == 1, boost::test_tools::tolerance(1e-14));
    }
  }
}

BOOST_AUTO_TEST_CASE(two_touching_spheres_against_exact_solutions) {
  // drag of each over 6 pi mu R: along 0.645 (Stimson and Jeffery 1926), across without rotation 0.724
  // (Goldman, Cox and Brenner 1966)
  const auto best = ref::rigid_chain_resistance({2, ChainCoupling::force_torque_stresslet});
  BOOST_TEST(std::abs(best.along / 2 - 0.645) < 0.004);
  BOOST_TEST(std::abs(best.across / 2 - 0.724) < 0.006);
  const auto simple = ref::rigid_chain_resistance({2, ChainCoupling::force_torque});
  BOOST_TEST(simple.along == 2 / (1 + 0.75 - 0.125), boost::test_tools::tolerance(1e-13));
  BOOST_TEST(std::abs(simple.along / 2 - 0.645) > 0.02);
  BOOST_TEST(simple.spin == 2 / (1 + 0.125), boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(stresslets_resist) {
  // a body that may not strain resists no less than one that may
  for (const int n : {2, 7, 13, 60}) {
    const auto strained = ref::rigid_chain_resistance({n, ChainCoupling::force_torque_stresslet});
    const auto simple = ref::rigid_chain_resistance({n, ChainCoupling::force_torque});
    BOOST_TEST(strained.along > simple.along);
    BOOST_TEST(strained.across > simple.across);
    BOOST_TEST(strained.turning > simple.turning);
    BOOST_TEST(strained.spin == simple.spin);
    BOOST_TEST(strained.along < 1.05 * simple.along);
  }
}

BOOST_AUTO_TEST_CASE(long_chains_tend_to_slender_bodies) {
  double before = 0;
  for (const int n : {5, 20, 80, 320}) {
    const auto resistance = ref::rigid_chain_resistance({n, ChainCoupling::force_torque_stresslet});
    const double ratio = resistance.across / resistance.along;
    BOOST_TEST(ratio > before);
    before = ratio;
    // 4 pi mu L/(ln(2 r) + c): what is left of the logarithm is of order one
    const double rest = 4.0 / 3 * n / resistance.across - std::log(2.0 * n);
    BOOST_TEST(std::abs(rest) < 1, n << ": " << rest);
  }
  BOOST_TEST(before > 1.6);
  BOOST_TEST(before < 2);
}

BOOST_AUTO_TEST_CASE(distant_spheres_drain_freely) {
  for (const ChainCoupling coupling : {ChainCoupling::force_torque, ChainCoupling::force_torque_stresslet}) {
    const auto off = [&](double spacing) {
      return 7 - ref::rigid_chain_resistance({7, coupling, spacing}).across;
    };
    BOOST_TEST(off(1e4) / off(2e4) == 2, boost::test_tools::tolerance(1e-2));
    const double lambda = ref::rigid_chain_bretherton({7, coupling, 50});
    const double free = ref::rigid_chain_bretherton({7, ChainCoupling::none, 50});
    BOOST_TEST(std::abs(lambda - free) < 1e-3);
    BOOST_TEST(std::abs(lambda - free) > 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(nonsense_is_refused) {
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(ref::rigid_chain_bretherton({0, ChainCoupling::none}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::rigid_chain_bretherton({501, ChainCoupling::none}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::rigid_chain_bretherton({5, ChainCoupling::none, 1.9}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::rigid_chain_resistance({5, ChainCoupling::none, not_a_number}),
                    ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::rigid_chain_period({1, ChainCoupling::none}, 1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::rigid_chain_period({5, ChainCoupling::none}, 0), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::rigid_chain_period({5, ChainCoupling::none}, not_a_number), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
