// Orbits of fibers in shear without inertia against Jeffery's.
#include <boost/test/unit_test.hpp>

#include "tests/dem/sheared_fibers.hpp"

BOOST_AUTO_TEST_SUITE(inertialess_orbits_test)

using namespace sheared_fibers;

namespace {

/// Orbit of the end-to-end direction: angle about the vorticity and orbit constant.
struct Orbit {
  double period;  ///< of the second turn; the first settles the bonds [s]
  double first_constant, last_constant;
};

template <int Dim>
Orbit orbit_of(const dem::FlowCase<Dim>& flow, double tolerance, double aspect) {
  dem::InertialessMotion<Dim> motion(flow, tolerance);
  double phase = 0, before = 0, rate_before = 0, crossing = 0;
  Orbit orbit{};
  const double h = 0.05 / kRate;
  for (int n = 0, turns = 0; turns < 2; ++n) {
    const auto state = motion.at(n * h);
    const auto r = state.poses.back().position - state.poses.front().position;
    const auto v = state.velocity.back() - state.velocity.front();
    const double plane = r[0] * r[0] + r[1] * r[1], rate = (r[0] * v[1] - r[1] * v[0]) / plane;
    phase += std::remainder(std::atan2(r[1], r[0]) - phase, 2 * pi);
    if constexpr (Dim == 3) {
      orbit.last_constant = std::sqrt(r[0] * r[0] / (aspect * aspect) + r[1] * r[1]) / std::abs(r[2]);
      if (n == 0) orbit.first_constant = orbit.last_constant;
    }
    if (n > 0 && phase <= -2 * pi * (turns + 1)) {
      const auto at = [&](double u) {  // cubic through angles and rates
        return (1 + 2 * u) * (1 - u) * (1 - u) * before + u * (1 - u) * (1 - u) * h * rate_before +
               u * u * (3 - 2 * u) * phase + u * u * (u - 1) * h * rate;
      };
      double low = 0, high = 1;
      for (int i = 0; i < 60; ++i)
        (at((low + high) / 2) > -2 * pi * (turns + 1) ? low : high) = (low + high) / 2;
      const double now = (n - 1 + low) * h;
      orbit.period = now - crossing;
      crossing = now;
      ++turns;
    }
    before = phase, rate_before = rate;
  }
  return orbit;
}

}  // namespace

BOOST_AUTO_TEST_CASE(stiff_chains_orbit_as_jeffery) {
  for (const int n : {2, 3, 13, 40}) {
    const double aspect = chain_aspect(n);
    const Orbit plane = orbit_of(straight_case<2>(fiber_of(n, 0.05), shear()), 1e-9, aspect);
    BOOST_TEST(std::abs(plane.period / jeffery_period(aspect) - 1) < 2e-6);
  }
}

BOOST_AUTO_TEST_CASE(every_orbit_constant_is_jefferys) {
  for (const int n : {2, 7, 60}) {
    for (const double elevation : {0.2, 0.8, 1.3}) {
      const double aspect = chain_aspect(n);
      const Orbit orbit =
          orbit_of(straight_case<3>(fiber_of(n, 0.003 * n), shear(), elevation), 1e-9, aspect);
      BOOST_TEST(std::abs(orbit.period / jeffery_period(aspect) - 1) < 1e-5);
      BOOST_TEST(std::abs(orbit.last_constant / orbit.first_constant - 1) < 1e-4);
    }
  }
}

/// Strains that a prediction gets wrong by a loose tolerance stand for huge forces here.
BOOST_AUTO_TEST_CASE(very_stiff_bonds_at_a_loose_tolerance_are_right) {
  const double aspect = chain_aspect(101);
  const Orbit orbit = orbit_of(straight_case<2>(fiber_of(101, 0.01), shear()), 1e-7, aspect);
  BOOST_TEST(std::abs(orbit.period / jeffery_period(aspect) - 1) < 2e-4);
}

BOOST_AUTO_TEST_CASE(finite_stiffness_changes_the_period_in_second_order) {
  const double exact = jeffery_period(chain_aspect(11));
  double error[2];
  for (int i = 0; i < 2; ++i) {
    error[i] =
        orbit_of(straight_case<2>(fiber_of(11, i == 0 ? 16 : 48), shear()), 1e-12, 1).period / exact - 1;
  }
  BOOST_TEST(std::log(error[1] / error[0]) / std::log(3.0) == 2, boost::test_tools::tolerance(0.05));
}

/// A fiber rotates with a fluid that rotates, and keeps its shape; stiffness and interactions do not matter.
BOOST_AUTO_TEST_CASE(solid_rotation_carries_the_fiber_along) {
  for (const auto hydrodynamics : {dem::Hydrodynamics::free_draining, dem::Hydrodynamics::stresslets}) {
    auto flow =
        straight_case<3>(fiber_of(5, 100), {kViscosity, {dem::solid_rotation(0.9)}, hydrodynamics}, 0.3);
    const auto state = dem::InertialessMotion<3>(flow, 1e-10).at(7.0);
    for (std::size_t i = 0; i < flow.start.size(); ++i) {
      const auto expected =
          dem::rotate(dem::rotation(dem::Vec<double, 3>{0, 0, 6.3}), flow.start[i].position);
      BOOST_TEST(dem::norm(state.poses[i].position - expected) < 2e-6 * kRadius);
    }
  }
}

/// A flow that reverses brings a stiff fiber back; half way it has turned by the angle of the strain until
/// then.
BOOST_AUTO_TEST_SUITE_END()
