// The chain's tangent at rest against beam theory: departure (3E/(16G) - 1/4) / r_f^2 of the paper's bond,
// none of the corrected one. Every bond bends under P (L - s) at its middle and shears under P.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "dem/equilibrium/newton.hpp"

BOOST_AUTO_TEST_SUITE(small_load_test)

namespace dem = fiberchain::dem;

namespace {

/// y_max / (P L^3 / 3EI) - 1 from the tangent at zero load.
template <int Dim>
double departure(const dem::Fiber& fiber) {
  const auto chain = dem::straight_chain<Dim>(fiber);
  const double P = 0.37, L = dem::fiber_length(fiber);
  dem::Load<Dim> load{fiber.aspect_ratio, {}, {}};
  load.force[1] = P;
  const auto motion = dem::linear_response(chain, chain.poses, dem::Boundary<Dim>{{0}, {load}});
  return motion.back()[1] / (P * L * L * L / (3 * dem::bending_stiffness(fiber))) - 1;
}

double expected(const dem::Fiber& fiber) {
  const double ratio = fiber.material.youngs_modulus / fiber.material.shear_modulus;
  return (3 * ratio / 16 - 0.25) / std::pow(fiber.aspect_ratio, 2);
}

dem::Fiber odd_fiber(int aspect_ratio, double nu, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> exponent(-3, 3);
  return {dem::isotropic_material(std::pow(10, 5 + exponent(generator)), nu,
                                  std::pow(10, 3 + exponent(generator))),
          0.0137 * std::pow(10, exponent(generator) / 3), aspect_ratio};
}

}  // namespace

BOOST_AUTO_TEST_CASE(departure_at_vanishing_load_is_exact) {
  int combinations = 0;
  for (const int aspect_ratio : {2, 3, 7, 13, 17, 25, 36, 57}) {
    for (const double nu : {-0.2, -0.07, 0.0, 0.17, 0.31, 0.49}) {
      const dem::Fiber fiber = odd_fiber(aspect_ratio, nu, ++combinations);
      const double tolerance = aspect_ratio <= 25 ? 1e-6 : 1e-4;
      BOOST_TEST_CONTEXT("aspect_ratio " << aspect_ratio << " nu " << nu) {
        BOOST_TEST(std::abs(departure<2>(fiber) / expected(fiber) - 1) < tolerance);
        BOOST_TEST(std::abs(departure<3>(fiber) / expected(fiber) - 1) < tolerance);
      }
    }
  }
  BOOST_TEST(combinations >= 20);
}

BOOST_AUTO_TEST_CASE(corrected_bond_has_no_departure_at_vanishing_load) {
  for (const int aspect_ratio : {2, 5, 13, 25}) {
    for (const double nu : {-0.2, 0.17, 0.49}) {
      dem::Fiber fiber = odd_fiber(aspect_ratio, nu, 77);
      fiber.bond_model = dem::BondModel::corrected;
      BOOST_TEST(std::abs(departure<2>(fiber)) < 1e-10);
      BOOST_TEST(std::abs(departure<3>(fiber)) < 1e-10);
    }
  }
}

BOOST_AUTO_TEST_CASE(axial_and_twisting_response_are_exact) {
  const dem::Fiber fiber = odd_fiber(13, 0.17, 5);
  const auto chain = dem::straight_chain<3>(fiber);
  const dem::Load<3> pull{13, {0.7, 0, 0}, {0.2, 0, 0}};
  const auto motion = dem::linear_response(chain, chain.poses, dem::Boundary<3>{{0}, {pull}});
  const dem::BondStiffness K = dem::bond_stiffness(fiber);
  for (int i = 0; i <= 13; ++i) {
    BOOST_TEST(std::abs(motion[i][0] - 0.7 * i / K.stretch) < 1e-13 * 0.7 * 13 / K.stretch);
    BOOST_TEST(std::abs(motion[i][3] - 0.2 * i / K.twist) < 1e-13 * 0.2 * 13 / K.twist);
  }
}

BOOST_AUTO_TEST_SUITE_END()
