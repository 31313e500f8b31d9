// Spheres that are held: where they go, saved states, other assemblies, what is refused.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/insertion/placement.hpp"
#include "dem/model/invalid_key.hpp"
#include "tests/dem/assembly/gripped_packing.hpp"

BOOST_AUTO_TEST_SUITE(held_states_test)

using namespace grips;

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
