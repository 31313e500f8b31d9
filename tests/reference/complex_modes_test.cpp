// Free vibrations with complex moduli: two routes for the chain, polynomials and closed forms for the beam.
#include "reference/complex_modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "reference/damped_beam.hpp"
#include "reference/errors.hpp"

BOOST_AUTO_TEST_SUITE(complex_modes_test)

namespace ref = fiberchain::reference;
using ref::ChainEnds;
using ref::ChainMotion;
using Complex = std::complex<double>;

namespace {

/// R = 1.3 mm, nu = 0.17.
ref::LinearChain odd_chain(int bonds) { return ref::linear_chain({bonds, 1.3e-3, 2.6e6, 0.17, 1130}); }

/// Frequency of the clamped-free beam's first mode [rad/s], to place the relaxation times by.
double first_frequency(const ref::LinearChain& chain) { return ref::first_bending_mode(chain).frequency; }

/// A spectrum of its own for each motion, times spread about 1/omega.
ref::BondSpectra odd_spectra(double omega, double strength) {
  return {{{strength, 0.2 / omega}, {0.3 * strength, 0.01 / omega}},
          {{0.7 * strength, 0.05 / omega}},
          {{1.3 * strength, 0.02 / omega}, {strength, 0.11 / omega}, {0.2 * strength, 3 / omega}},
          {{strength, 1.7 / omega}, {0.6 * strength, 0.13 / omega}, {0.4 * strength, 0.009 / omega}}};
}

/// All roots of s^2 + omega^2 k(s), by the eigenvalues of (q, q', x_j).
Eigen::VectorXcd roots_of_mode(double omega, const ref::PronySeries& series) {
  const Eigen::Index n = 2 + static_cast<Eigen::Index>(series.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
  a(0, 1) = 1;
  a(1, 0) = -omega * omega;
  for (Eigen::Index j = 2; j < n; ++j) {
    const ref::PronyTerm& term = series[static_cast<std::size_t>(j - 2)];
    a(1, j) = -omega * omega * term.strength;
    a(j, 1) = 1;
    a(j, j) = -1 / term.time;
  }
  return a.eigenvalues();
}

Complex oscillating_root(double omega, const ref::PronySeries& series) {
  const Eigen::VectorXcd roots = roots_of_mode(omega, series);
  Eigen::Index best = 0;
  for (Eigen::Index i = 0; i < roots.size(); ++i) {
    if (roots(i).imag() > roots(best).imag()) best = i;
  }
  return roots(best);
}

/// Largest of |T(s) u| over the largest of its parts, for bending, written sphere by sphere.
double residual(const ref::LinearChain& chain, const ref::BondModuli& moduli,
                const ref::ComplexChainMode& mode, bool clamped) {
  const std::size_t n = mode.displacement.size();
  const Complex s = mode.decay.eigenvalue;
  const double arm = chain.spacing / 2;
  const Complex shear = chain.stiffness.shear * moduli.shear(s).value + s * chain.dashpot.shear;
  const Complex bend = chain.stiffness.bend * moduli.bend(s).value + s * chain.dashpot.bend;
  std::vector<Complex> force(n), torque(n);
  double scale = 0;
  for (std::size_t i = 0; i < n; ++i) {
    force[i] = s * s * chain.mass * mode.displacement[i];
    torque[i] = s * s * chain.inertia * mode.rotation[i];
    scale = std::max({scale, std::abs(force[i]) * arm, std::abs(torque[i])});
  }
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const Complex q = shear * (mode.displacement[i + 1] - mode.displacement[i] -
                               arm * (mode.rotation[i] + mode.rotation[i + 1]));
    const Complex m = bend * (mode.rotation[i + 1] - mode.rotation[i]);
    force[i] -= q;
    force[i + 1] += q;
    torque[i] -= arm * q + m;
    torque[i + 1] -= arm * q - m;
    scale = std::max({scale, std::abs(q) * arm, std::abs(m)});
  }
  double worst = 0;
  for (std::size_t i = clamped ? 1 : 0; i < n; ++i) {
    worst = std::max({worst, std::abs(force[i]) * arm, std::abs(torque[i])});
  }
  return worst / scale;
}

double largest_shape_difference(const ref::ComplexChainMode& a, const ref::ComplexChainMode& b) {
  double worst = 0;
  double scale = 0;
  const auto compare = [&](const std::vector<Complex>& x, const std::vector<Complex>& y) {
    BOOST_TEST_REQUIRE(x.size() == y.size());
    scale = worst = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      worst = std::max(worst, std::abs(x[i] - y[i]));
      scale = std::max(scale, std::abs(x[i]));
    }
    return x.empty() ? 0 : worst / scale;
  };
  const double displacement = compare(a.displacement, b.displacement);
  return std::max(displacement, compare(a.rotation, b.rotation));
}

constexpr std::array<ChainMotion, 3> motions{ChainMotion::bending, ChainMotion::axial, ChainMotion::twist};
constexpr std::array<ChainEnds, 2> both_ends{ChainEnds::clamped_free, ChainEnds::free_free};

/// The followed modes against those of the linearization: each is among them, with its shape, and none twice.
double compare_routes(const ref::LinearChain& chain, const ref::BondSpectra& spectra, ChainMotion motion,
                      ChainEnds ends, int count) {
  const auto followed = ref::complex_chain_modes(chain, ref::bond_moduli(spectra), motion, ends, count);
  const auto all = ref::all_complex_chain_modes(chain, spectra, motion, ends);
  std::vector<const ref::ComplexChainMode*> used;
  double worst = 0;
  for (const auto& mode : followed) {
    const auto same = std::min_element(all.begin(), all.end(), [&](const auto& a, const auto& b) {
      return std::abs(a.decay.eigenvalue - mode.decay.eigenvalue) <
             std::abs(b.decay.eigenvalue - mode.decay.eigenvalue);
    });
    BOOST_TEST((std::find(used.begin(), used.end(), &*same) == used.end()));
    used.push_back(&*same);
    BOOST_TEST(same->oscillates);
    worst = std::max(worst, std::abs(same->decay.eigenvalue - mode.decay.eigenvalue) / mode.decay.frequency);
    BOOST_TEST(std::abs(same->decay.half_loss_factor - mode.decay.half_loss_factor) < 1e-8);
    // one bond that is free turns its spheres against each other and moves none: no displacement to scale by
    const bool scaled = chain.bonds > 1 || ends == ChainEnds::clamped_free;
    if (scaled) BOOST_TEST(largest_shape_difference(mode, *same) < 1e-6);
  }
  // the lowest oscillations are all found
  int lower = 0;
  for (const auto& each : all) {
    lower += each.oscillates && each.decay.frequency < followed.back().decay.frequency * (1 - 1e-9);
  }
  BOOST_TEST(lower == count - 1);
  return worst;
}

}  // namespace

BOOST_AUTO_TEST_CASE(beam_modes_are_roots_of_their_polynomial) {
  const ref::UniformBeam beam{0.13, 4.1e-6, 3.7e-3};
  const double unit = std::sqrt(4.1e-6 / 3.7e-3) / (0.13 * 0.13);
  for (const double strength : {0.004, 0.2, 2.5}) {
    const ref::PronySeries series{
        {strength, 0.4 / unit}, {0.8 * strength, 0.03 / unit}, {0.3, 0.0011 / unit}};
    for (const ChainEnds ends : both_ends) {
      const auto modes = ref::complex_beam_modes(beam, ref::complex_modulus(series), ends, 6);
      BOOST_TEST(modes.size() == 6U);
      for (const auto& mode : modes) {
        const double omega = unit * mode.beta * mode.beta;
        const Complex exact = oscillating_root(omega, series);
        BOOST_TEST(std::abs(mode.decay.eigenvalue - exact) < 1e-12 * std::abs(exact));
        BOOST_TEST(mode.decay.frequency > omega);  // branches stiffen
        BOOST_TEST(mode.decay.damping == -exact.real() / std::abs(exact), boost::test_tools::tolerance(1e-9));
        BOOST_TEST(mode.decay.half_loss_factor ==
                   ref::loss_factor(ref::complex_modulus(series), mode.decay.frequency) / 2);
        BOOST_TEST(mode.decay.difference == mode.decay.damping - mode.decay.half_loss_factor);
      }
      BOOST_TEST(modes[2].number == 3);
    }
  }
}

BOOST_AUTO_TEST_CASE(both_routes_agree) {
  for (const int bonds : {1, 2, 5, 13}) {
    const ref::LinearChain chain = odd_chain(bonds);
    for (const double strength : {0.01, 0.4}) {
      const ref::BondSpectra spectra = odd_spectra(first_frequency(chain), strength);
      for (const ChainMotion motion : motions) {
        for (const ChainEnds ends : both_ends) {
          BOOST_TEST(compare_routes(chain, spectra, motion, ends, std::min(bonds, 5)) < 1e-10);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(both_routes_agree_with_dashpots_beside_and_a_cylinders_mass) {
  ref::LinearChain chain = ref::with_cylinder_mass(odd_chain(11));
  chain.stiffness.shear = 0.75 * chain.stiffness.stretch;
  chain = ref::with_bond_damping(chain, 0.23);
  const ref::BondSpectra spectra = odd_spectra(first_frequency(chain), 0.15);
  for (const ChainMotion motion : motions) {
    for (const ChainEnds ends : both_ends) {
      BOOST_TEST(compare_routes(chain, spectra, motion, ends, 4) < 1e-10);
    }
  }
}

BOOST_AUTO_TEST_CASE(fifty_bonds_by_both_routes) {
  const ref::LinearChain chain = odd_chain(50);
  ref::BondSpectra spectra = odd_spectra(first_frequency(chain), 0.05);
  spectra.bend.resize(2);
  BOOST_TEST(compare_routes(chain, spectra, ChainMotion::bending, ChainEnds::clamped_free, 5) < 1e-9);
  BOOST_TEST(compare_routes(chain, spectra, ChainMotion::twist, ChainEnds::free_free, 5) < 1e-9);
}

BOOST_AUTO_TEST_CASE(bending_modes_balance_every_sphere) {
  for (const int bonds : {7, 50, 130}) {
    const ref::LinearChain chain = ref::with_bond_damping(odd_chain(bonds), 0.02);
    const ref::BondModuli moduli = ref::bond_moduli(odd_spectra(first_frequency(chain), 0.12));
    for (const ChainEnds ends : both_ends) {
      for (const auto& mode : ref::complex_chain_modes(chain, moduli, ChainMotion::bending, ends, 5)) {
        BOOST_TEST(residual(chain, moduli, mode, ends == ChainEnds::clamped_free) < 1e-8);
        BOOST_TEST(mode.decay.damping > 0.01);
        BOOST_TEST(mode.oscillates);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(rods_follow_the_scalar_root) {
  // M^-1 B^T B has its eigenvalues whatever the spring: each mode is one relaxed frequency
  const ref::LinearChain chain = odd_chain(9);
  const ref::BondSpectra spectra = odd_spectra(first_frequency(chain), 0.3);
  for (const ChainMotion motion : {ChainMotion::axial, ChainMotion::twist}) {
    const auto& series = motion == ChainMotion::axial ? spectra.stretch : spectra.twist;
    for (const ChainEnds ends : both_ends) {
      const auto modes = ref::complex_chain_modes(chain, ref::bond_moduli(spectra), motion, ends, 9);
      for (int k = 1; k <= 9; ++k) {
        const double omega = ref::rod_eigenvalue(chain, motion, ends, k).imag();
        const Complex exact = oscillating_root(omega, series);
        const ref::FreeDecay& decay = modes[static_cast<std::size_t>(k - 1)].decay;
        BOOST_TEST(std::abs(decay.eigenvalue - exact) < 1e-10 * std::abs(exact));
        const double half_loss = ref::loss_factor(ref::complex_modulus(series), decay.frequency) / 2;
        BOOST_TEST(decay.half_loss_factor == half_loss, boost::test_tools::tolerance(1e-9));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(one_spectrum_in_all_motions_leaves_the_elastic_shapes) {
  const ref::LinearChain chain = odd_chain(23);
  const double omega = first_frequency(chain);
  const ref::PronySeries one{{0.2, 0.9 / omega}, {0.1, 0.06 / omega}};
  const auto elastic = ref::chain_modes(chain, ChainMotion::bending, ChainEnds::clamped_free);
  const auto modes = ref::complex_chain_modes(chain, ref::bond_moduli({one, one, one, one}),
                                              ChainMotion::bending, ChainEnds::clamped_free, 6);
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const Complex exact = oscillating_root(elastic[k].frequency, one);
    BOOST_TEST(std::abs(modes[k].decay.eigenvalue - exact) < 1e-11 * std::abs(exact));
    for (std::size_t i = 0; i < 24; ++i) {
      BOOST_TEST(std::abs(modes[k].displacement[i] - elastic[k].displacement[i]) < 1e-7);
    }
  }
}

BOOST_AUTO_TEST_CASE(dashpots_alone_are_the_quadratic_problem) {
  const ref::LinearChain chain = ref::with_bond_damping(odd_chain(17), 0.6);
  const auto quadratic = ref::chain_modes(chain, ChainMotion::bending, ChainEnds::free_free);
  const auto modes =
      ref::complex_chain_modes(chain, ref::bond_moduli({}), ChainMotion::bending, ChainEnds::free_free, 5);
  for (std::size_t k = 0; k < modes.size(); ++k) {
    BOOST_TEST(std::abs(modes[k].decay.eigenvalue - quadratic[k].eigenvalue) <
               1e-10 * quadratic[k].frequency);
    // not exactly alike, since the shape is complex: shear and bending have different retardation times
    BOOST_TEST(std::abs(modes[k].decay.difference) < 1e-3 * modes[k].decay.damping);
  }
  const auto first = ref::first_bending_mode(ref::with_bond_damping(odd_chain(300), 0.6));
  const auto same =
      ref::complex_chain_modes(ref::with_bond_damping(odd_chain(300), 0.6), ref::bond_moduli({}),
                               ChainMotion::bending, ChainEnds::clamped_free, 1);
  BOOST_TEST(std::abs(same[0].decay.eigenvalue - first.eigenvalue) < 1e-10 * first.frequency);
}

BOOST_AUTO_TEST_CASE(bending_branches_tend_to_the_beam_at_second_order) {
  // at one relaxed frequency the share of shear in a mode's energy is what differs: (spacing/length)^2
  const auto off = [](int bonds, std::size_t k) {
    const ref::LinearChain chain = odd_chain(bonds);
    const double omega = ref::chain_modes(chain, ChainMotion::bending, ChainEnds::clamped_free)[k].frequency;
    const ref::PronySeries bend{{0.3, 0.8 / omega}};
    const auto mode =
        ref::complex_chain_modes(chain, ref::bond_moduli({{}, {}, {}, bend}), ChainMotion::bending,
                                 ChainEnds::clamped_free, static_cast<int>(k) + 1)[k];
    return ref::single_mode_decay(omega, ref::complex_modulus(bend)).damping / mode.decay.damping - 1;
  };
  for (const std::size_t k : {0U, 1U, 2U}) {
    const double order = std::log(off(30, k) / off(60, k)) / std::log(2.0);
    BOOST_TEST(off(60, k) > 0);
    BOOST_TEST(order > 1.85, "mode " << k + 1 << ": " << order);
    BOOST_TEST(order < 2.15, "mode " << k + 1 << ": " << order);
  }
}

BOOST_AUTO_TEST_CASE(creeping_motions_are_counted) {
  // one real root between -1/tau and 0 for every branch of a bond
  const ref::LinearChain chain = odd_chain(6);
  const ref::BondSpectra spectra = odd_spectra(first_frequency(chain), 0.1);
  const auto all =
      ref::all_complex_chain_modes(chain, spectra, ChainMotion::bending, ChainEnds::clamped_free);
  const auto creeping =
      std::count_if(all.begin(), all.end(), [](const auto& mode) { return !mode.oscillates; });
  BOOST_TEST(creeping == 6 * 4);
  BOOST_TEST(all.size() == 6U * 4 + 12);
  for (const auto& mode : all) BOOST_TEST(mode.decay.eigenvalue.real() < 0);
}

BOOST_AUTO_TEST_CASE(nonsense_is_refused) {
  const ref::LinearChain chain = odd_chain(5);
  const ref::BondModuli elastic = ref::bond_moduli({});
  const auto bending = ChainMotion::bending;
  const auto clamped = ChainEnds::clamped_free;
  BOOST_CHECK_THROW(ref::complex_chain_modes(chain, elastic, bending, clamped, 11), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::complex_chain_modes(chain, elastic, bending, clamped, 0), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::complex_chain_modes(odd_chain(301), elastic, bending, clamped, 1),
                    ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::all_complex_chain_modes(chain, {{}, {{-1, 1}}, {}, {}}, bending, clamped),
                    ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::single_mode_decay(0, ref::elastic_modulus()), ref::InvalidArgument);
  // an overdamped mode has no oscillation to follow
  BOOST_CHECK_THROW(ref::single_mode_decay(1, ref::with_retardation(ref::elastic_modulus(), 2.1)),
                    ref::NoConvergence);
  BOOST_CHECK_THROW(ref::complex_beam_modes({1, 1, 0}, ref::elastic_modulus(), clamped, 1),
                    ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::free_free_beta(0), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
