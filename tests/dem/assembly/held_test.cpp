// Spheres that are held, driven and loaded: momentum, energy, equilibria of beams, saved states.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "dem/equilibrium/newton.hpp"
#include "dem/insertion/placement.hpp"
#include "dem/model/invalid_key.hpp"
#include "tests/dem/assembly/gripped_packing.hpp"

BOOST_AUTO_TEST_SUITE(held_test)

using namespace grips;

/// Weight, walls and what holds and loads spheres are the change of momentum in every interval.
BOOST_AUTO_TEST_CASE(all_forces_together_are_the_change_of_momentum) {
  for (const Scheme& scheme : kSchemes) {
    dem::Assembly assembly = gripped_packing(scheme);
    const V weight = mass(assembly) * V{0.2, -0.3, -9.81};
    V before = momentum(assembly);
    double then = 0, largest = 0;
    std::vector<double> seen(assembly.grips().size(), 0);
    std::int64_t touched = 0;
    for (int n = 0; n < 30; ++n) {
      assembly.march(static_cast<int>((n % 3 == 0 ? 0.0013 : 0.0007) / scheme.step));
      const double T = assembly.time() - then;
      V impulse = T * weight;
      double size = norm(impulse);
      const auto take = [&](const dem::WallSample& sample) {
        impulse = impulse - T * sample.mean.force;
        size += T * sample.force_peak;
        BOOST_TEST(norm(sample.mean.force) <= sample.force_peak * (1 + 1e-9));
      };
      for (const dem::WallSample& sample : assembly.wall_samples()) take(sample);
      const auto held = assembly.held_samples();
      for (std::size_t g = 0; g < held.size(); ++g)
        take(held[g]), seen[g] = std::max(seen[g], held[g].force_peak);
      const V now = momentum(assembly);
      largest = std::max(largest, norm(now - before - impulse) / (size + mass(assembly)));
      before = now, then = assembly.time();
      touched = std::max(touched, assembly.touching());
      assembly.begin_wall_interval();
      assembly.begin_held_interval();
    }
    BOOST_TEST_MESSAGE(name(scheme.integrator) << ": impulses off by " << largest << " of their sizes");
    BOOST_TEST(largest < 1e-11);
    BOOST_TEST(touched > 5);
    for (std::size_t g = 0; g < seen.size(); ++g) BOOST_TEST(seen[g] > 1e-5, "grip " << g);
  }
}

/// An end that is shaken, a tip that is loaded: the energy's error falls as the square of the step.
BOOST_AUTO_TEST_CASE(energy_given_by_grips_is_of_second_order) {
  for (const Scheme& scheme : kSchemes) {
    const dem::Chain<3> chain = dem::straight_chain<3>(fiber_with(6, 0.3));
    dem::Grip end = grip(all, all, {{0, 0, 0}}), tip;
    end.body.motion.oscillation = dem::WallOscillation{{0, 0.6, 0.8}, 4e-4, 60, 0.4, 0.005};
    end.body.motion.about = dem::WallAxis{{}, {0, 0, 1}};
    end.body.motion.angular_velocity = 7;
    tip.force = {0, 2e-4, -1e-4}, tip.moment = {2e-7, 0, 0}, tip.ramp = 0.006, tip.spheres = {{0, 0, 6}};
    double off[3], given = 0;
    for (int n = 0; n < 3; ++n) {
      const double step = scheme.step / (scheme.integrator == dem::Integrator::leapfrog ? 2.5 : 1) / (1 << n);
      dem::Domain around;
      around.gravity = {0, 0, -9.81};
      dem::Assembly assembly({{chain, {dem::placed(chain, {{}, {1, 0, 0}})}}}, around,
                             {.step = step,
                              .integrator = scheme.integrator,
                              .form = scheme.form,
                              .account_energy = true,
                              .grips = {end, tip}});
      const double begin = total(assembly.energy());
      assembly.march(std::lround(0.0123 / step));
      const dem::EnergyBalance now = assembly.energy();
      double sum = 0;
      for (const dem::WallSample& sample : assembly.held_samples()) sum += sample.work;
      within(sum / now.held_work, 1, 1e-12, "sum of the grips' work");
      given = std::abs(now.held_work);
      off[n] = total(now) - begin;
    }
    const double order = std::log2(std::abs(off[1] / off[2]));
    BOOST_TEST_MESSAGE(name(scheme.integrator)
                       << ": energy off by " << off[0] / given << ", " << off[1] / given << ", "
                       << off[2] / given << " of what was given, order " << order);
    BOOST_TEST(std::abs(off[2] / given) < 1e-3);
    BOOST_TEST(std::abs(order - 2) < 0.1);
  }
}

/// Clamped at one end under its weight and a load at its tip: at rest as Newton's method has it, and what
/// holds it carries both.
BOOST_AUTO_TEST_CASE(a_cantilever_comes_to_its_equilibrium) {
  for (const Scheme& scheme : kSchemes) {
    const bool stiff = scheme.integrator == dem::Integrator::leapfrog_stiff;
    const dem::Fiber fiber = fiber_with(4, stiff ? 20 : 2);
    const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
    const V gravity{0, 1.3, -9.81}, force{0, 0, -0.7 * dem::load_force(fiber, 1)};
    dem::Boundary<3> boundary{{0}, {}};
    V carried{}, moment{};
    dem::Grip end = grip(all, all, {{0, 0, 0}}), tip;
    tip.force = force, tip.ramp = 0.01, tip.spheres = {{0, 0, 4}};
    for (int i = 0; i <= 4; ++i) {
      dem::Load<3> load{i, dem::sphere_mass(fiber) * gravity, {}};
      if (i == 4) load.force = load.force + force;
      boundary.loads.push_back(load);
    }
    const dem::Equilibrium<3> expected = dem::solve_equilibrium<3>(chain, boundary);
    for (const dem::Load<3>& load : boundary.loads) {
      carried = carried + load.force;
      moment = moment + cross(expected.poses[load.sphere].position - expected.poses[0].position, load.force);
    }
    dem::Domain around;
    around.gravity = gravity;
    dem::Assembly assembly({{chain, {dem::placed(chain, {{}, {1, 0, 0}})}}}, around,
                           {.step = stiff ? 4e-5 : 3e-6,
                            .integrator = scheme.integrator,
                            .form = dem::BondForm::total,
                            .grips = {end, tip}});
    assembly.march(stiff ? 6000 : 60000);
    const dem::ChainState<3> now = assembly.state(0, 0);
    const double L = dem::fiber_length(fiber);
    double off = 0;
    for (int i = 0; i <= 4; ++i)
      off = std::max(off, norm(now.poses[i].position - expected.poses[i].position) / L);
    const dem::WallSample held = assembly.held_samples()[0];
    BOOST_TEST_MESSAGE(name(scheme.integrator)
                       << ": places off by " << off << " L, tip at " << now.poses[4].position[2] / L << " L");
    BOOST_TEST(off < 1e-11);
    BOOST_TEST(now.poses[4].position[2] < -0.1 * L);
    assembly.begin_held_interval();
    const dem::WallSample sample = assembly.held_samples()[0];
    BOOST_TEST(norm(sample.mean.force - carried) < 1e-6 * norm(carried));
    BOOST_TEST(norm(sample.mean.moment - moment) < 1e-6 * norm(moment));
    BOOST_TEST(norm(now.poses[0].position) == 0);
    BOOST_TEST(norm(held.center) == 0);
  }
}

/// Supports at both ends, the middle driven down and stopped: half of it is a cantilever, which the chain's
/// departure from a beam is known of: (3 E / (16 G) - 1/4) / r_f^2 (README.md).
BOOST_AUTO_TEST_CASE(three_point_bending_is_that_of_the_beam) {
  for (const Scheme& scheme : kSchemes) {
    const bool stiff = scheme.integrator == dem::Integrator::leapfrog_stiff;
    const dem::Fiber fiber = fiber_with(8, stiff ? 20 : 2), half = fiber_with(4, 0);
    const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
    const double L = dem::fiber_length(fiber), down = 0.003 * L, speed = 0.02, stops = down / speed;
    dem::Grip supports = grip(z_only, none, {{0, 0, 0}, {0, 0, 8}}), drives = grip(z_only, none, {{0, 0, 4}}),
              holds = drives;
    drives.body.velocity = {0, 0, -speed};
    drives.body.active_until = holds.body.active_from = stops;
    dem::Assembly assembly({{chain, {dem::placed(chain, {{}, {1, 0, 0}})}}}, {},
                           {.step = stiff ? 4e-5 : 3e-6,
                            .integrator = scheme.integrator,
                            .form = dem::BondForm::total,
                            .grips = {supports, drives, holds}});
    assembly.march(std::lround((stops + (stiff ? 0.2 : 0.35)) / assembly.step()));
    assembly.begin_held_interval();
    const auto held = assembly.held_samples();
    const dem::ChainState<3> now = assembly.state(0, 0);
    const double deflection = -now.poses[4].position[2], force = held[2].mean.force[2];
    within(deflection, down, 1.01 * speed * assembly.step(), "driven down");
    within(held[0].mean.force[2] / force, -1, 1e-7, "carried by the supports");
    within(norm(held[1].mean.force), 0, 0, "what has let go");
    // the half of it as a cantilever with half of the force
    dem::Load<3> load{4, {0, 0, 0.5 * force}, {}};
    const auto expected = dem::solve_equilibrium<3>(dem::straight_chain<3>(half), {{0}, {load}});
    const double EI = dem::bending_stiffness(fiber), beam = force * L * L * L / (48 * EI),
                 departure =
                     (3 * fiber.material.youngs_modulus / (16 * fiber.material.shear_modulus) - 0.25) / 16;
    BOOST_TEST_MESSAGE(name(scheme.integrator)
                       << ": deflection over Newton's " << deflection / expected.poses[4].position[2] - 1
                       << ", over the beam's " << deflection / beam - 1 << ", known departure " << departure);
    within(deflection / expected.poses[4].position[2], 1, 1e-11, "the chain's equilibrium");
    within(deflection / beam - 1, departure, 0.01 * departure, "departure from the beam");
  }
}

/// A fiber between two plates that a force presses together, pulled by its end: both rub.
BOOST_AUTO_TEST_CASE(pull_out_of_pressed_plates_takes_their_friction) {
  const dem::Fiber fiber = fiber_with(5, 0.5);
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  const double R = dem::sphere_radius(fiber), force = 6e-3, friction = 0.37, speed = 0.02;
  dem::Domain around;
  around.contacts = {.restitution = 0.3, .friction = friction};
  dem::Wall plate{dem::Plane{{0, 0, 2 * R}, {0, 0, -1}}};
  plate.motion.drive = dem::WallDrive{.axis = {0, 0, -1}, .mass = 1e-4, .force = force, .damping = 0.5};
  around.walls = {side({0, 0, 0}, {0, 0, 1}), plate};
  dem::Grip pull = grip({true, false, false}, none, {{0, 0, 5}});
  pull.body.velocity = {speed, 0, 0};
  pull.body.active_from = 0.02;
  dem::Assembly assembly({{chain, {dem::placed(chain, {{0, 0, R}, {1, 0, 0}})}}}, around,
                         {.step = 5e-6, .account_energy = true, .grips = {pull}});
  assembly.march(std::lround(0.08 / 5e-6));
  assembly.begin_held_interval();
  const double work = assembly.held_samples()[0].work, x = assembly.state(0, 0).poses[5].position[0],
               rubbed = assembly.energy().contact_tangential;
  assembly.march(400);
  const dem::WallSample held = assembly.held_samples()[0];
  const double way = assembly.state(0, 0).poses[5].position[0] - x;
  within(held.mean.force[0] / (-2 * friction * force), 1, 1e-6, "pull");
  within((held.work - work) / (2 * friction * force * way), 1, 1e-6, "work");
  within((assembly.energy().contact_tangential - rubbed) / (held.work - work), 1, 1e-5, "taken by friction");
  within(way, 400 * 5e-6 * speed, 1e-12, "way");
}

/// A fiber held by all its spheres turns as the rigid body does.
BOOST_AUTO_TEST_SUITE_END()
