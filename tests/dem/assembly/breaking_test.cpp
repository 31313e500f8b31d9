// Bonds that break: at which stress, what becomes of their energy, what the pieces do.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "dem/model/errors.hpp"
#include "tests/dem/assembly/breaking_scenes.hpp"

BOOST_AUTO_TEST_SUITE(breaking_test)

using namespace scenes;

namespace {

using dem::BreakCause;

constexpr dem::BondForm forms[] = {dem::BondForm::total, dem::BondForm::incremental};
constexpr dem::Integrator schemes[] = {dem::Integrator::leapfrog, dem::Integrator::leapfrog_stiff};

dem::Fiber fiber_of(int bonds, const dem::BondStrength& strength, double damping = 0) {
  dem::Fiber fiber = odd_fiber(bonds);
  fiber.bond_damping = damping;
  fiber.strength = strength;
  return fiber;
}

dem::AssemblyOptions options_of(dem::BondForm form, dem::Integrator scheme = dem::Integrator::leapfrog) {
  return {.integrator = scheme, .form = form, .account_energy = true, .allow_passage = true};
}

double total_of(const dem::Assembly& assembly) { return dem::total(assembly.energy()); }

/// A strain and the stress that it is, by the beam's own formulas.
struct Case {
  BreakCause cause;
  OneBond strain;
  double stress;
  std::optional<double> dem::BondStrength::*strength;
};

std::vector<Case> cases() {
  const dem::Fiber fiber = odd_fiber(1);
  const double E = fiber.material.youngs_modulus, G = fiber.material.shear_modulus, R = 0.5 * fiber.diameter,
               l = fiber.diameter;
  using S = dem::BondStrength;
  return {{BreakCause::tension, {.stretch = 0.004}, E * 0.004, &S::tension},
          {BreakCause::tension, {.bend = {0, 0.003, -0.004}}, E * R * 0.005 / l, &S::tension},
          {BreakCause::tension,
           {.stretch = 0.002, .bend = {0, 0.003, -0.004}},
           E * (0.002 + R * 0.005 / l),
           &S::tension},
          {BreakCause::tension,
           {.stretch = -0.001, .bend = {0, 0, 0.009}},
           E * (-0.001 + R * 0.009 / l),
           &S::tension},
          {BreakCause::compression, {.stretch = -0.003}, E * 0.003, &S::compression},
          {BreakCause::compression,
           {.stretch = -0.003, .bend = {0, 0.005, 0}},
           E * (0.003 + R * 0.005 / l),
           &S::compression},
          {BreakCause::shear, {.shear = 0.007}, G * 0.007, &S::shear},
          {BreakCause::torsion, {.bend = {-0.008, 0, 0}}, G * R * 0.008 / l, &S::torsion}};
}

}  // namespace

/// Strengths just above the stress bear it, just below they do not.
BOOST_AUTO_TEST_CASE(a_bond_breaks_at_its_strength_exactly) {
  for (const dem::BondForm form : forms) {
    for (const dem::Integrator scheme : schemes) {
      for (const Case& c : cases()) {
        for (const double side : {1 - 1e-9, 1 + 1e-9}) {
          dem::BondStrength strength;
          strength.*c.strength = side * c.stress;
          const dem::Fiber fiber = fiber_of(1, strength);
          dem::Assembly assembly({one_bond(fiber, c.strain)}, {}, options_of(form, scheme));
          const dem::Vec<double, 3> middle =
              0.5 * (assembly.state(0, 0).poses[0].position + assembly.state(0, 0).poses[1].position);
          assembly.march(1);
          const auto breaks = assembly.take_breaks();
          BOOST_TEST_CONTEXT(name(c.cause) << ", " << name(form) << ", " << name(scheme) << ", " << side) {
            BOOST_TEST(assembly.is_broken(0, 0, 0) == (side < 1));
            BOOST_TEST(assembly.pieces() == (side < 1 ? 2 : 1));
            BOOST_REQUIRE(breaks.size() == (side < 1 ? 1u : 0u));
            if (breaks.empty()) continue;
            BOOST_TEST(name(breaks[0].cause) == name(c.cause));
            BOOST_TEST(std::abs(breaks[0].stress / c.stress - 1) < 1e-10);
            BOOST_TEST(breaks[0].step == 0);
            BOOST_TEST(norm(breaks[0].place - middle) < 1e-15);
          }
        }
      }
    }
  }
}

namespace {

/// Two spheres that fly apart until their bond breaks.
dem::Assembly torn(dem::BondForm form, double damping, double step, dem::Integrator scheme) {
  const double E = odd_fiber(1).material.youngs_modulus;
  const dem::Fiber fiber = fiber_of(1, {.tension = 0.004 * E, .torsion = 0.01 * E}, damping);
  dem::FiberGroup group = one_bond(fiber, {.stretch = 1e-4, .bend = {1e-3, 4e-4, 0}});
  const double v = 0.011 * std::sqrt(E / fiber.material.density);
  group.fibers[0].velocity = {{-0.5 * v, 0.1 * v, 0}, {0.5 * v, -0.1 * v, 0.02 * v}};
  dem::AssemblyOptions options = options_of(form, scheme);
  options.step = step * dem::bond_time_step(fiber);
  return {{group}, {}, options};
}

}  // namespace

/// What remains are free spheres: they go on as they are, and the book is what it was.
BOOST_AUTO_TEST_CASE(energy_of_breaking_closes_to_round_off) {
  for (const dem::BondForm form : forms) {
    dem::Assembly assembly = torn(form, 0, 0.3, dem::Integrator::leapfrog);
    double before = total_of(assembly), after = before;
    for (int steps = 0; !assembly.is_broken(0, 0, 0) && steps < 100; ++steps) {
      before = after;
      assembly.march(1);
      after = total_of(assembly);
    }
    BOOST_REQUIRE(assembly.is_broken(0, 0, 0));
    const dem::EnergyBalance energy = assembly.energy();
    BOOST_TEST(energy.bonds == 0);
    BOOST_TEST(energy.breaking == assembly.take_breaks().at(0).energy);
    BOOST_TEST(energy.breaking > 0.1 * before);
    BOOST_TEST(std::abs(after - before) < 1e-12 * before, name(form) << ": " << (after - before) / before);
    assembly.march(500);
    BOOST_TEST(std::abs(total_of(assembly) - before) < 1e-12 * before);
  }
}

/// The book of what is damped or solved for is of second order in the step: with a break in it, too.
BOOST_AUTO_TEST_CASE(energy_of_breaking_closes_with_dashpots_and_solved_bonds) {
  for (const dem::BondForm form : forms) {
    for (const dem::Integrator scheme : schemes) {
      double error[2];
      for (int half = 0; half < 2; ++half) {
        dem::Assembly assembly = torn(form, 0.2, half == 0 ? 0.02 : 0.01, scheme);
        const double before = total_of(assembly);
        assembly.march(half == 0 ? 500 : 1000);
        BOOST_TEST(assembly.is_broken(0, 0, 0));
        error[half] = std::abs(total_of(assembly) / before - 1);
      }
      BOOST_TEST_MESSAGE(name(form) << ", " << name(scheme) << ": " << error[0] << ", at half the step "
                                    << error[1]);
      BOOST_TEST(error[0] < 1e-2);
      BOOST_TEST(error[1] < 0.3 * error[0]);
    }
  }
}

namespace {

/// A fiber that is drawn out, bent and turned, without damping.
dem::FiberGroup drawn(const dem::Fiber& fiber) {
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  const double n = fiber.aspect_ratio, l = fiber.diameter, c = std::sqrt(3.7e5 / 431.0);
  dem::ChainState<3> state = strained(
      chain,
      [&](int i) {
        return V{0.03 * l * (i - n / 2), 0.01 * l * std::sin(i * 0.7), 0};
      },
      [&](int i) {
        return V{0.01 * i, 0, 0.014 * std::cos(i * 0.7)};
      });
  for (int i = 0; i <= n; ++i) {
    state.velocity[i] = 0.02 * c * V{i / n - 0.5, 0.3 * std::sin(2.0 * i), 0.2 * std::cos(3.0 * i)};
    state.spin[i] = 0.01 * c / l * V{std::sin(1.0 * i), 0.4, std::cos(2.0 * i)};
  }
  return {chain, {state}};
}

}  // namespace

/// From the moment a bond breaks at, its fiber is two fibers that start there; what is gone is the bond's
/// energy.
BOOST_AUTO_TEST_CASE(a_broken_fiber_is_two_fibers_from_that_moment_on) {
  const int n = 9, broken = 3;
  const dem::Fiber fiber = fiber_of(n, {.tension = 1e9});
  dem::AssemblyOptions options = options_of(dem::BondForm::total);
  options.step = 0.3 * dem::bond_time_step(fiber);
  dem::Assembly whole({drawn(fiber)}, {}, options);
  whole.march(7);
  const dem::ChainState<3> now = whole.state(0, 0);
  const double before = total_of(whole);
  dem::Fiber first = fiber, second = fiber;
  first.aspect_ratio = broken, second.aspect_ratio = n - broken - 1;
  dem::Assembly parts({{dem::straight_chain<3>(first), {part_of(now, 0, broken)}},
                       {dem::straight_chain<3>(second), {part_of(now, broken + 1, n)}}},
                      {}, options);
  const double left = total_of(parts);
  BOOST_TEST(parts.touching() == 0);
  whole.break_bond(0, 0, broken);
  whole.march(400), parts.march(400);
  const auto breaks = whole.take_breaks();
  BOOST_REQUIRE(breaks.size() == 1);
  BOOST_TEST(name(breaks[0].cause) == "by_hand");
  BOOST_TEST(breaks[0].step == 7);
  BOOST_TEST(std::abs(before - left - breaks[0].energy) < 1e-12 * before);
  const dem::ChainState<3> end = whole.state(0, 0), a = parts.state(0, 0), b = parts.state(1, 0);
  double off = 0;
  for (int i = 0; i <= n; ++i) {
    const bool in_first = i <= broken;
    const auto& other = in_first ? a : b;
    const int j = in_first ? i : i - broken - 1;
    off = std::max(off, norm(end.poses[i].position - other.poses[j].position) / fiber.diameter);
    off = std::max(off, norm(end.spin[i] - other.spin[j]) / norm(end.spin[i]));
  }
  BOOST_TEST_MESSAGE("pieces are off two fibers by " << off);
  BOOST_TEST(off < 1e-10);
  BOOST_TEST(std::abs(total_of(whole) - breaks[0].energy - total_of(parts)) < 1e-12 * before);
}

/// Overlapping spheres that are left by a pressed bond push each other off: their contact's energy comes out
/// of the bond's. Half of the kick that the contact begins with counts: second order in the step.
BOOST_AUTO_TEST_CASE(a_bond_that_breaks_pressed_leaves_a_contact) {
  for (const dem::Integrator scheme : schemes) {
    double error[2];
    for (int half = 0; half < 2; ++half) {
      dem::Fiber fiber = fiber_of(1, {.compression = 0.02 * 3.7e5});
      dem::FiberGroup group = one_bond(fiber, {.stretch = -0.03});
      dem::Domain around;
      around.contacts.restitution = 1;
      dem::AssemblyOptions options = options_of(dem::BondForm::total, scheme);
      options.step = (half == 0 ? 0.1 : 0.05) * dem::bond_time_step(fiber);
      dem::Assembly assembly({group}, around, options);
      const double before = total_of(assembly);
      assembly.march(1);
      BOOST_TEST(assembly.touching() == 1);
      const double released = assembly.energy().breaking, bond = assembly.take_breaks().at(0).energy;
      BOOST_TEST(released > 0.05 * bond);
      BOOST_TEST(released < 0.99 * bond);
      assembly.march(half == 0 ? 2000 : 4000);
      BOOST_TEST(assembly.touching() == 0);
      BOOST_TEST(assembly.energy().kinetic > 0.05 * before);
      error[half] = std::abs(total_of(assembly) / before - 1);
    }
    BOOST_TEST_MESSAGE(name(scheme) << ": energy off by " << error[0] << ", at half the step " << error[1]);
    BOOST_TEST(error[0] < 1e-3);
    BOOST_TEST(error[1] < 0.4 * error[0]);
  }
}

/// The kick of spheres that no bond joins is that of free ones: nothing of it is left in the matrix.
BOOST_AUTO_TEST_CASE(a_broken_bond_has_no_stiffness_where_bonds_are_solved_for) {
  for (const dem::BondForm form : forms) {
    dem::Assembly assembly = torn(form, 0.2, 5, dem::Integrator::leapfrog_stiff);
    assembly.march(20);
    BOOST_REQUIRE(assembly.is_broken(0, 0, 0));
    const dem::ChainState<3> before = assembly.state(0, 0);
    assembly.march(100);
    const dem::ChainState<3> after = assembly.state(0, 0);
    for (int i : {0, 1}) {
      BOOST_TEST(norm(after.velocity[i] - before.velocity[i]) < 1e-14 * norm(before.velocity[i]));
      BOOST_TEST(norm(after.spin[i] - before.spin[i]) <= 1e-14 * norm(before.spin[i]));
    }
    BOOST_TEST(norm(before.velocity[1] - before.velocity[0]) > 0.1 * norm(before.velocity[0]));
  }
}

BOOST_AUTO_TEST_CASE(what_is_not_built_together_is_refused) {
  dem::Fiber fiber = fiber_of(3, {.tension = -1});
  BOOST_CHECK_THROW(dem::check(fiber), dem::InvalidInput);
  fiber = fiber_of(3, {.tension = 1e5});
  fiber.rolling_friction = 0.1;
  BOOST_CHECK_THROW(dem::check(fiber), dem::InvalidInput);
  fiber = odd_fiber(3);
  fiber.yield = dem::BondYield{1e-3, 1};
  BOOST_CHECK_THROW(dem::check(fiber), dem::InvalidInput);
}

BOOST_AUTO_TEST_SUITE_END()
