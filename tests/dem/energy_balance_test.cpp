// What each mechanism of an assembly takes, against what is gone.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/motion/time_step.hpp"
#include "tests/dem/small_packing.hpp"

BOOST_AUTO_TEST_SUITE(energy_balance_test)

using namespace scenes;

namespace {

/// Three bent fibers let go from rest.
struct Release {
  const char* name;
  double damping, friction = 0;
  dem::AssemblyOptions options{};
  bool curved = false, fluid = false, gravity = false;
};

struct Closing {
  dem::EnergyBalance start, end;
  double turned;  ///< energy that changed its kind [J]
  double off;     ///< of the total at the end, over that
};

Closing released(const Release& r, double part) {
  dem::Fiber fiber = odd_fiber(7);
  fiber.bond_damping = r.damping;
  fiber.rolling_friction = r.friction;
  const double t_b = dem::bond_time_step(fiber);
  const dem::Chain<3> chain = r.curved ? curled(fiber, {0.05, 0.11, -0.17}) : dem::straight_chain<3>(fiber);
  const dem::Chain<3> bent = curled(fiber, {0.1, 0.2, -0.15});
  dem::FiberGroup group{chain, {}};
  for (int k = 0; k < 3; ++k) group.fibers.push_back(dem::placed(bent, {V{0, 0.9 * k, 0}, V{1, 0.3, 0.2}}));
  dem::Domain around;
  if (r.gravity) around.gravity = 0.002 * fiber.diameter / (t_b * t_b) * V{0.3, -0.5, 0.8};
  if (r.fluid) {
    around.fluid =
        dem::Fluid{dem::sphere_mass(fiber) / (60 * t_b) / dem::stokes_drag({1, {}}, fiber).translation, {}};
    if (r.gravity) around.fluid->flow = {dem::simple_shear(0.01 / t_b)};
  }
  dem::AssemblyOptions options = r.options;
  options.step = part * 0.8 * dem::stable_time_step(fiber);
  options.account_energy = true;
  dem::Assembly assembly({group}, around, options);
  Closing c{assembly.energy(), {}, 0, 0};
  assembly.march(static_cast<int>(500 * t_b / *options.step));
  c.end = assembly.energy();
  c.turned = c.start.bonds + std::abs(c.end.gravity - c.start.gravity);
  c.off = (total(c.end) - total(c.start)) / c.turned;
  return c;
}

}  // namespace

BOOST_AUTO_TEST_CASE(bonds_and_fluid_take_what_is_gone) {
  const dem::AssemblyOptions total_form{.form = dem::BondForm::total},
      sign{.rolling = dem::Rolling::explicit_sign}, stiff{.integrator = dem::Integrator::leapfrog_stiff},
      stiff_total{.integrator = dem::Integrator::leapfrog_stiff, .form = dem::BondForm::total};
  for (const Release& r : {Release{"damped", 0.37},
                           {"damped, total form", 0.37, 0, total_form},
                           {"damped, total form, curved", 0.37, 0, total_form, true},
                           {"friction", 0.1, 1.3},
                           {"friction by sign", 0.1, 1.3, sign},
                           {"bonds solved for", 0.37, 0, stiff},
                           {"bonds solved for, total form, curved", 0.37, 0, stiff_total, true},
                           {"bonds solved for, shear and weight", 0.2, 0, stiff, false, true, true},
                           {"still fluid", 0.2, 0, {}, false, true},
                           {"shear and weight", 0.2, 0, {}, false, true, true}}) {
    const Closing coarse = released(r, 0.25), fine = released(r, 0.125);
    BOOST_TEST_MESSAGE(r.name << ": total off by " << coarse.off << ", " << fine.off
                              << " at half the step; damping " << fine.end.bond_damping << ", friction "
                              << fine.end.bond_friction << ", fluid " << fine.end.fluid << " of "
                              << fine.turned << " J");
    BOOST_TEST(std::abs(fine.off) < 1e-3, r.name);
    BOOST_TEST(std::abs(fine.off) < 0.6 * std::abs(coarse.off), r.name);
    // most of it is gone, and into what takes it
    const double kept = fine.end.kinetic + fine.end.bonds;
    if (!r.gravity) BOOST_TEST(kept < 0.1 * fine.start.bonds, r.name);
    BOOST_TEST(fine.end.bond_damping > 0.05 * fine.start.bonds, r.name);
    if (r.friction > 0) {
      BOOST_TEST(fine.end.bond_friction > 0.3 * fine.start.bonds, r.name);
    } else {
      BOOST_TEST(fine.end.bond_friction == 0.0, r.name);
    }
    if (r.fluid) {
      BOOST_TEST(fine.end.fluid > 0.3 * fine.start.bonds, r.name);
    } else {
      BOOST_TEST(fine.end.fluid == 0.0, r.name);
    }
    BOOST_TEST(fine.end.contact_normal == 0.0);
    BOOST_TEST((fine.end.scheme == 0.0) == (r.options.integrator == dem::Integrator::leapfrog), r.name);
  }
}

BOOST_AUTO_TEST_CASE(a_fiber_that_sinks_steadily_gives_its_weight_to_the_fluid) {
  dem::Fiber fiber = odd_fiber(3);
  dem::Domain around;
  around.gravity = {0.5, 0.2, -9.81};
  const double time = 0.011, m = dem::sphere_mass(fiber), g2 = dot(around.gravity, around.gravity);
  around.fluid = dem::Fluid{m / time / dem::stokes_drag({1, {}}, fiber).translation, {}};
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  dem::Assembly assembly({{chain, {dem::placed(chain, {{}, {1, 2, 3}})}}}, around, {.account_energy = true});
  assembly.march(static_cast<int>(20 * time / assembly.step()));
  const dem::EnergyBalance before = assembly.energy();
  const double t = assembly.time();
  assembly.march(2000);
  const dem::EnergyBalance after = assembly.energy();
  const double power = (after.fluid - before.fluid) / (assembly.time() - t);
  BOOST_TEST(power == 4 * m * g2 * time,
             boost::test_tools::tolerance(1e-6));  // weight times terminal speed g m / c
  BOOST_TEST(before.gravity - after.gravity == after.fluid - before.fluid,
             boost::test_tools::tolerance(1e-6));
}

namespace {

struct Packed {
  double off;  ///< largest at ten moments, over the energy turned over
  dem::EnergyBalance end;
};

Packed packed(const SmallPacking& packing, double part) {
  const double step = part * packing.assembly({}).step();
  dem::Assembly assembly = packing.assembly({.step = step, .account_energy = true});
  const dem::EnergyBalance start = assembly.energy();
  Packed p{};
  for (int n = 0; n < 10; ++n) {
    assembly.march(static_cast<int>(2.4e-3 / step));
    p.end = assembly.energy();
    p.off = std::max(p.off, std::abs(total(p.end) - total(start)));
  }
  BOOST_TEST(assembly.touching() > 2);
  p.off /= start.kinetic + start.gravity - p.end.gravity + p.end.wall_work;
  return p;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_balance_of_a_packing_closes_with_the_step) {
  for (const bool periodic : {false, true}) {
    for (const double damping : {0.0, 0.3}) {
      SmallPacking packing = periodic ? packing_in_a_periodic_box(24, 15) : packing_in_a_box(24, 15);
      for (auto& group : packing.groups) group.chain.fiber.bond_damping = damping;
      const Packed coarse = packed(packing, 1), fine = packed(packing, 0.25);
      BOOST_TEST_MESSAGE((periodic ? "periodic" : "box")
                         << ", xi_b = " << damping << ": off by " << coarse.off << ", " << fine.off
                         << " at a quarter of the step");
      BOOST_TEST(coarse.off < 1.5e-3);
      BOOST_TEST(fine.off < 0.3 * coarse.off);
      for (const double taken :
           {fine.end.contact_normal, fine.end.contact_tangential, fine.end.contact_rolling}) {
        BOOST_TEST(taken > 1e-6);
      }
      BOOST_TEST((fine.end.bond_damping > 1e-5) == (damping > 0));
      BOOST_TEST((std::abs(fine.end.wall_work) > 1e-7) == periodic);  // the plate that comes down
    }
  }
}

/// At the step that is chosen.
BOOST_AUTO_TEST_CASE(the_balance_of_a_packing_closes_to_a_thousandth) {
  for (const bool periodic : {false, true}) {
    for (const double damping : {0.1, 0.3}) {
      SmallPacking packing = periodic ? packing_in_a_periodic_box(24, 15) : packing_in_a_box(24, 15);
      if (damping == 0.1) packing.around.contacts.rolling_friction = 0.2;
      for (auto& group : packing.groups) group.chain.fiber.bond_damping = damping;
      dem::Assembly assembly = packing.assembly({.account_energy = true});
      const dem::EnergyBalance start = assembly.energy();
      for (int n = 0; n < 10; ++n) {
        assembly.march(static_cast<int>(2.4e-3 / assembly.step()));
        const dem::EnergyBalance now = assembly.energy();
        const double turned = start.kinetic + start.gravity - now.gravity + now.wall_work;
        BOOST_TEST(std::abs(total(now) - total(start)) < 1e-3 * turned, (total(now) - total(start)) / turned
                                                                            << " at " << assembly.time()
                                                                            << " s, xi_b = " << damping);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
