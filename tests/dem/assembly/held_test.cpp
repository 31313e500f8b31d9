// Spheres that are held, driven and loaded: momentum, energy, equilibria of beams, saved states.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "dem/equilibrium/newton.hpp"
#include "dem/insertion/placement.hpp"
#include "dem/model/invalid_key.hpp"
#include "tests/dem/small_packing.hpp"

BOOST_AUTO_TEST_SUITE(held_test)

using namespace scenes;

namespace {

void within(double value, double expected, double tolerance, const std::string& what) {
  BOOST_TEST(std::abs(value - expected) <= tolerance, what << ": " << value << ", expected " << expected);
}

dem::Fiber fiber_with(int aspect_ratio, double bond_damping) {
  dem::Fiber fiber{dem::isotropic_material(2.6e6, 0.17, 1130), 1.66e-3, aspect_ratio};
  fiber.bond_damping = bond_damping;
  return fiber;
}

constexpr std::array<bool, 3> all{true, true, true}, none{}, z_only{false, false, true};

dem::Grip grip(const std::array<bool, 3>& place, const std::array<bool, 3>& turn,
               std::vector<dem::SphereAddress> spheres) {
  dem::Grip grip;
  grip.place = place, grip.turn = turn, grip.spheres = std::move(spheres);
  return grip;
}

V momentum(const dem::Assembly& assembly) {
  V sum{};
  for (int group = 0; group < assembly.groups(); ++group) {
    const dem::Fiber& fiber = assembly.chain(group).fiber;
    for (int f = 0; f < assembly.fibers(group); ++f) {
      const dem::ChainState<3> state = assembly.state(group, f);
      for (std::size_t i = 0; i < state.velocity.size(); ++i)
        sum =
            sum + (dem::mass_share(fiber, static_cast<int>(i)) * dem::sphere_mass(fiber)) * state.velocity[i];
    }
  }
  return sum;
}

double mass(const dem::Assembly& assembly) {
  double sum = 0;
  for (int group = 0; group < assembly.groups(); ++group)
    sum += assembly.fibers(group) * dem::fiber_mass(assembly.chain(group).fiber);
  return sum;
}

/// Fibers that fall into a box, some of them clamped, shaken, turned, guided along one axis and loaded.
dem::AssemblyOptions with_grips(dem::AssemblyOptions options) {
  dem::Grip clamped = grip(all, all, {{0, 1, 0}, {0, 1, 1}}),
            shaken = grip({true, false, true}, none, {{1, 2, 13}}),
            turning = grip(all, all, {{1, 0, 4}, {1, 0, 5}}),
            guided = grip(z_only, {false, true, false}, {{0, 3, 8}}), loaded;
  shaken.body.motion.oscillation = dem::WallOscillation{{0.6, 0, 0.8}, 3e-4, 90, 0.3, 0.004};
  turning.body.motion.about = dem::WallAxis{{0.012, 0.011, 0.01}, {0, 0.6, 0.8}};
  turning.body.motion.angular_velocity = 25;
  guided.body.velocity = {0, 0, 0.05};
  guided.body.active_from = 0.0101, guided.body.active_until = 0.0203;
  guided.force = {2e-4, 0, 0};
  loaded.force = {1e-4, -3e-4, 2e-4}, loaded.moment = {1e-7, 0, 3e-7}, loaded.ramp = 0.005;
  loaded.spheres = {{0, 2, 0}, {1, 1, 6}};
  options.grips = {clamped, shaken, turning, guided, loaded};
  return options;
}

struct Scheme {
  dem::Integrator integrator;
  dem::BondForm form;
  double step;
};
constexpr Scheme kSchemes[] = {{dem::Integrator::leapfrog, dem::BondForm::total, 5e-6},
                               {dem::Integrator::leapfrog_stiff, dem::BondForm::incremental, 2e-5}};

dem::Assembly gripped_packing(const Scheme& scheme, bool accounted = false, int threads = 1) {
  return packing_in_a_box(8, 6).assembly(with_grips({.step = scheme.step,
                                                     .integrator = scheme.integrator,
                                                     .form = scheme.form,
                                                     .threads = threads,
                                                     .account_energy = accounted}));
}

}  // namespace

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
BOOST_AUTO_TEST_CASE(what_is_held_goes_where_its_grip_goes) {
  for (const Scheme& scheme : kSchemes) {
    const dem::Chain<3> chain = dem::straight_chain<3>(fiber_with(3, 0.2));
    const V center{2e-3, -1e-3, 4e-4}, axis{0.48, 0.6, 0.64};
    const double omega = 31;
    dem::Grip body = grip(all, all, {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}});
    body.body.motion.about = dem::WallAxis{center, axis};
    body.body.motion.angular_velocity = omega;
    body.body.velocity = {0.1, 0, -0.2};
    body.body.active_from = 0.003;
    const dem::ChainState<3> start = dem::placed(chain, {{1e-3, 2e-3, 0}, {0, 0.6, -0.8}});
    dem::Assembly assembly({{chain, {start}}}, {},
                           {.step = scheme.step,
                            .integrator = scheme.integrator,
                            .form = dem::BondForm::total,
                            .grips = {body}});
    assembly.march(std::lround(0.1 / scheme.step));
    const dem::ChainState<3> now = assembly.state(0, 0);
    double grasped = scheme.step * std::ceil(0.003 / scheme.step * (1 - 1e-12));
    const double held = assembly.time() - grasped;
    const dem::Quaternion<double> turn = dem::rotation((held * omega) * axis);
    const V c0 = center + grasped * body.body.velocity, c1 = center + assembly.time() * body.body.velocity;
    for (int i = 0; i <= 3; ++i) {
      const V expected = c1 + rotate(turn, start.poses[i].position - c0);
      BOOST_TEST(norm(now.poses[i].position - expected) < 1e-12);
      const V end = rotate(now.poses[i].orientation, V{1, 0, 0}),
              was = rotate(start.poses[i].orientation, V{1, 0, 0});
      BOOST_TEST(norm(end - rotate(turn, was)) < 1e-9);
    }
    // what turns a mass about a center pulls it there; of the leapfrog 2 (1 - cos(w dt)) / dt^2 in place of
    // w^2
    assembly.begin_held_interval();
    V force{};
    for (int i = 0; i <= 3; ++i) {
      const V arm = now.poses[i].position - c1;
      force = force + (arm - dot(arm, axis) * axis);
    }
    const double rate = 2 * (1 - std::cos(omega * scheme.step)) / (scheme.step * scheme.step),
                 m = dem::sphere_mass(assembly.chain(0).fiber);
    BOOST_TEST(norm(assembly.held_samples()[0].mean.force - (m * rate) * force) <
               1e-7 * m * rate * norm(force));
  }
}

/// Saved amid an interval and restored on two threads: the bits of the run that was not stopped.
BOOST_AUTO_TEST_CASE(restored_runs_with_grips_go_on_to_the_bit) {
  for (const Scheme& scheme : kSchemes) {
    const auto steps = [&](double time) { return std::lround(time / scheme.step); };
    dem::Assembly whole = gripped_packing(scheme, true), other = gripped_packing(scheme, true, 2);
    whole.march(steps(0.008));
    whole.begin_held_interval();
    whole.march(steps(0.004));  // one has come meanwhile
    other.restore(whole.saved());
    for (dem::Assembly* assembly : {&whole, &other}) assembly->march(steps(0.01));
    const auto a = whole.held_samples(), b = other.held_samples();
    for (std::size_t g = 0; g < a.size(); ++g) {
      for (int c = 0; c < 3; ++c) {
        BOOST_TEST(a[g].mean.force[c] == b[g].mean.force[c]);
        BOOST_TEST(a[g].mean.moment[c] == b[g].mean.moment[c]);
        BOOST_TEST(a[g].center[c] == b[g].center[c]);
      }
      BOOST_TEST(a[g].force_peak == b[g].force_peak);
      BOOST_TEST(a[g].work == b[g].work);
    }
    const dem::PlacedSpheres x = whole.placed(), y = other.placed();
    for (std::size_t i = 0; i < x.position.size(); ++i) {
      for (int c = 0; c < 3; ++c) BOOST_TEST_REQUIRE(x.position[i][c] == y.position[i][c]);
    }
  }
}

/// A loaded cantilever at rest goes on in another assembly: it stays at rest, its load neither gone nor
/// twice.
BOOST_AUTO_TEST_CASE(held_fibers_go_on_in_another_assembly) {
  const dem::Fiber fiber = fiber_with(4, 2);
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  dem::Grip end = grip(all, all, {{0, 0, 0}}), tip;
  tip.force = {0, 0, -0.5 * dem::load_force(fiber, 1)}, tip.spheres = {{0, 0, 4}};
  const dem::ChainState<3> start = dem::placed(chain, {{}, {1, 0, 0}});
  const auto options = [&](std::vector<dem::Grip> grips) {
    return dem::AssemblyOptions{.step = 3e-6, .form = dem::BondForm::total, .grips = std::move(grips)};
  };
  dem::Assembly before({{chain, {start}}}, {}, options({end, tip}));
  before.march(60000);
  const dem::CarriedState carried = dem::carried_state(before.saved());
  BOOST_TEST(carried.groups[0].loads[4 * 8 + 2] == 0);
  dem::Assembly same({{chain, {carried.groups[0].fibers[0]}}}, {}, options({end, tip})),
      free({{chain, {carried.groups[0].fibers[0]}}}, {}, options({end}));
  same.take_over(carried), free.take_over(carried);
  const double tip_before = carried.groups[0].fibers[0].poses[4].position[2];
  same.march(400), free.march(400);
  const double stayed = same.state(0, 0).poses[4].position[2] - tip_before,
               went = free.state(0, 0).poses[4].position[2] - tip_before;
  BOOST_TEST_MESSAGE("the tip goes " << stayed << " m with its load, " << went << " m without");
  BOOST_TEST(went > 1e-5);
  BOOST_TEST(std::abs(stayed) < 1e-4 * went);
}

BOOST_AUTO_TEST_CASE(grips_that_make_no_sense_are_refused) {
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber_with(4, 0.2));
  const auto refused = [&](std::vector<dem::Grip> grips, const std::string& words, dem::Domain around = {},
                           double rolling = 0) {
    dem::Chain<3> own = chain;
    own.fiber.rolling_friction = rolling;
    try {
      dem::Assembly({{own, {dem::placed(own, {{}, {1, 0, 0}})}}}, around,
                    {.step = 1e-6, .grips = std::move(grips)});
      BOOST_ERROR("taken: " << words);
    } catch (const dem::InvalidKey& error) {
      BOOST_TEST(std::string(error.what()).find(words) != std::string::npos, error.what());
      BOOST_TEST(error.key == "held");
    }
  };
  refused({grip(all, all, {})}, "no sphere");
  refused({grip(all, all, {{0, 0, 5}})}, "not there");
  refused({grip(all, all, {{0, 1, 0}})}, "not there");
  refused({grip(all, all, {{1, 0, 0}})}, "not there");
  refused({grip(all, none, {{0, 0, 1}}), grip(z_only, all, {{0, 0, 1}})}, "held twice");
  refused({grip(all, none, {{0, 0, 1}, {0, 0, 1}})}, "held twice");
  dem::Grip driven = grip(all, none, {{0, 0, 1}});
  driven.body.motion.drive = dem::WallDrive{.axis = {1, 0, 0}, .mass = 1};
  refused({driven}, "drives");
  dem::Domain wet;
  wet.fluid = dem::Fluid{1e-3, {}};
  refused({grip(all, none, {{0, 0, 1}})}, "fluid", wet);
  refused({grip(all, none, {{0, 0, 1}})}, "rolling friction", {}, 0.1);
}

BOOST_AUTO_TEST_SUITE_END()
