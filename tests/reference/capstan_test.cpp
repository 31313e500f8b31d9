// A rod drawn over a drum: the thread's limit, what thickness and bending take, no friction.
#include "reference/capstan.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/errors.hpp"

BOOST_AUTO_TEST_SUITE(capstan_test)

namespace ref = fiberchain::reference;

namespace {

constexpr double rho = 0.37, force = 1.9;

ref::Capstan rod(double mu, double turning, double thickness, double bending) {
  return {mu, turning, rho, thickness * rho, bending * force * rho * rho};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_thread_has_eulers_ratio) {
  for (const double turning : {0.7, 3.3, 11.0}) {
    const double euler = ref::euler_eytelwein(0.23, turning);
    BOOST_TEST(std::abs(euler - std::exp(0.23 * turning)) < 1e-12 * euler);
    BOOST_TEST(std::abs(ref::drawn_over(rod(0.23, turning, 0, 1e-6), force).force / force / euler - 1) <
               2e-6);
  }
}

/// To first order, by hand: ln of the ratio loses mu phi r/rho and (1 + mu^2)/2 E I/rho^2 (1/F_0 - 1/F).
BOOST_AUTO_TEST_CASE(thickness_and_bending_take_what_first_order_says) {
  constexpr double mu = 0.23, turning = 4.1;
  const double euler = ref::euler_eytelwein(mu, turning);
  for (const double small : {1e-3, 1e-4}) {
    const double bent = std::log(ref::drawn_over(rod(mu, turning, 0, small), force).force / force / euler);
    BOOST_TEST(std::abs(bent / (-0.5 * (1 + mu * mu) * small * (1 - 1 / euler)) - 1) < 40 * small);
    const ref::Capstan thick = rod(mu, turning, small, 1e-9);
    BOOST_TEST(std::abs(ref::tension_growth(thick) / (mu * (1 - small - mu * mu * small)) - 1) <
               small * small * 2);
  }
}

/// The free ends are elasticas whose curvature where they touch is the drum's.
BOOST_AUTO_TEST_CASE(without_friction_the_tension_is_the_same_on_both_sides) {
  const ref::CapstanPull pull = ref::drawn_over(rod(0, 2.1, 0.05, 0.17), force);
  BOOST_TEST(std::abs(pull.force / force - 1) < 1e-12);
  BOOST_TEST(std::abs(pull.held_angle - std::acos(1 - 0.17 / 2)) < 1e-9);
  BOOST_TEST(std::abs(pull.drawn_angle - pull.held_angle) < 1e-9);
  BOOST_TEST(std::abs(pull.touching - (2.1 - 2 * pull.held_angle)) < 1e-9);
}

/// Both forces and friction about the drum's axis: what friction gives follows from the pressures.
BOOST_AUTO_TEST_CASE(moments_about_the_axis_are_in_balance) {
  const ref::Capstan c = rod(0.31, 3.7, 0.04, 0.12);
  const ref::CapstanPull pull = ref::drawn_over(c, force);
  const double couple = c.friction * c.rod_radius, growth = ref::tension_growth(c);
  // arms of the forces: the elastica's moment where it leaves is force times the distance of its line
  const auto arm = [&](double f, double angle) {
    return rho * std::cos(angle) + std::sqrt(2 * c.bending_stiffness * (1 - std::cos(angle)) / f);
  };
  const double begin = force * (std::cos(pull.held_angle) + c.friction * std::sin(pull.held_angle)) /
                       (1 + c.friction * couple / (rho + couple * growth));
  const double end = begin * std::exp(growth * pull.touching), pressure = 1 / (rho + couple * growth);
  const double points =
      (begin - force * std::cos(pull.held_angle)) + (pull.force * std::cos(pull.drawn_angle) - end);
  const double along = c.friction * pressure * rho * (end - begin) / growth;
  const double given = pull.force * arm(pull.force, pull.drawn_angle) - force * arm(force, pull.held_angle);
  BOOST_TEST(std::abs((points + along) * (rho - c.rod_radius) / given - 1) < 1e-9);
}

BOOST_AUTO_TEST_CASE(what_has_no_arc_in_contact_is_refused) {
  BOOST_CHECK_THROW(ref::drawn_over(rod(0.3, 0.4, 0, 0.3), force), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::drawn_over(rod(0.3, 3, 0, 5), force), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::drawn_over(rod(0.3, 3, 0, 0), force), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::drawn_over(rod(-0.1, 3, 0, 0.1), force), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::drawn_over(rod(0.9, 12, 0.1, 0.1), force), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
