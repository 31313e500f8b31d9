// Smooth fibers whose bonds break: what touches then, momentum, the book, saved states.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/contact/fiber_bodies.hpp"
#include "dem/model/invalid_key.hpp"
#include "tests/dem/assembly/breaking_scenes.hpp"
#include "tests/dem/small_packing.hpp"

BOOST_AUTO_TEST_SUITE(smooth_breaking_test)

using namespace scenes;

namespace {

dem::Chain<3> brittle(int bonds, double spacing = 1, double strain = 0.01) {
  dem::Fiber fiber = odd_fiber(bonds);
  fiber.spacing = spacing;
  fiber.strength = dem::BondStrength{.tension = strain * fiber.material.youngs_modulus};
  dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  chain.smooth = true;
  return chain;
}

}  // namespace

BOOST_AUTO_TEST_CASE(bodies_of_pieces_end_round_and_lone_spheres_are_bodies) {
  dem::FiberBodies bodies;
  bodies.add(brittle(7), 2);
  bodies.parted = {8, 10, 11, 14};  // of the second fiber: 8 | 9 10 | 11 | 12 13 14 | 15
  bodies.build(0);
  for (const std::int64_t alone : {8, 11, 15}) {
    BOOST_TEST((bodies.primitive(alone) == dem::sphere_primitive(alone)));
    BOOST_TEST(bodies.before[alone] == alone);
    BOOST_TEST(bodies.behind[alone] == alone);
  }
  for (const std::int64_t segment : {0, 6, 9, 12, 13})
    BOOST_TEST((bodies.primitive(segment) == dem::segment_primitive(segment) && !bodies.is_none(segment)));
  for (const std::int64_t last : {7, 10, 14}) {
    BOOST_TEST(bodies.is_none(last));
    BOOST_TEST(bodies.body_of(last) == last - 1);
  }
  BOOST_TEST(bodies.before[9] == 9);
  BOOST_TEST(bodies.behind[9] == 10);
  BOOST_TEST(bodies.behind[12] == 14);
  BOOST_TEST(bodies.behind[13] == 14);
  BOOST_TEST(bodies.before[13] == 12);
}

/// A long fiber that breaks in two by hand; then its pieces come together again, end to end and one across
/// the gap: both as spheres and cylinders of their own.
BOOST_AUTO_TEST_CASE(pieces_touch_by_their_round_ends_and_nothing_is_left_between) {
  const dem::Chain<3> chain = brittle(9, 2.2, 1);
  const double R = dem::sphere_radius(chain.fiber), l = dem::bond_length(chain.fiber);
  dem::Chain<3> across_chain = brittle(3, 2.2, 1);
  const dem::ChainState<3> broken = dem::at_rest<3>(chain.poses);
  const V middle = 0.5 * (broken.poses[4].position + broken.poses[5].position);
  // through the gap, which is wider than itself
  dem::ChainState<3> across =
      dem::placed(across_chain, {middle + V{0, -1.5 * l, 2.02 * R}, {0, 1, 0}, {0, 0, -0.2}});
  for (const bool breaks : {false, true}) {
    dem::Assembly assembly({{chain, {broken}}, {across_chain, {across}}}, {},
                           {.account_energy = true, .allow_passage = true});
    const Momenta before = momenta(assembly);
    if (breaks) assembly.break_bond(0, 0, 4);
    std::int64_t most = 0;
    for (int n = 0; n < 400; ++n) {
      assembly.march(std::max(1, static_cast<int>(4 * R / 0.2 / assembly.step() / 400)));
      most = std::max(most, assembly.touching());
    }
    BOOST_TEST((most > 0) == !breaks);
    BOOST_TEST(assembly.pieces() == (breaks ? 3 : 2));
    BOOST_TEST(norm(momenta(assembly).linear - before.linear) < 1e-12 * before.linear_size);
  }
}

namespace {

/// Error of the book over what the contact of a segment stored whose bond breaks, in steps of so much of 1e-6
/// s.
double book_of_a_segment_that_goes(int parts) {
  const dem::Chain<3> chain = brittle(5, 2.2, 1), other = brittle(3, 2.2, 1);
  const double R = dem::sphere_radius(chain.fiber), l = dem::bond_length(chain.fiber);
  const dem::ChainState<3> lying = dem::at_rest<3>(chain.poses);
  const V middle = 0.5 * (lying.poses[2].position + lying.poses[3].position);
  const dem::ChainState<3> across =
      dem::placed(other, {middle + V{0.1 * R, -1.4 * l, 1.99 * R}, {0, 1, 0}, {0, 0, 0}});
  dem::Domain around;
  around.contacts = {1, 0, 0};
  dem::Assembly assembly({{chain, {lying}}, {other, {across}}}, around,
                         {.step = 2e-6 / parts, .account_energy = true, .allow_passage = true});
  const double energy = dem::total(assembly.energy());
  assembly.march(4 * parts);
  const double stored = assembly.energy().contacts;
  BOOST_TEST(assembly.touching() == 1);
  assembly.break_bond(0, 0, 2);
  assembly.march(1);
  BOOST_TEST(assembly.touching() == 0);
  BOOST_TEST(std::abs(assembly.energy().breaking / stored - 1) < 0.1);
  assembly.march(100);
  return (dem::total(assembly.energy()) - energy) / stored;
}

}  // namespace

/// It takes what they stored, to second order in the step.
BOOST_AUTO_TEST_CASE(a_segment_that_goes_takes_the_energy_of_its_contacts) {
  const double coarse = book_of_a_segment_that_goes(1), fine = book_of_a_segment_that_goes(2);
  BOOST_TEST_MESSAGE("book off by " << coarse << ", " << fine << " of what the contact stored");
  BOOST_TEST(std::abs(fine) < 2e-3);
  BOOST_TEST(std::abs(coarse / fine) > 3.2);
  BOOST_TEST(std::abs(coarse / fine) < 5);
}

namespace {

dem::Assembly brittle_packing(const dem::AssemblyOptions& options, bool breaks = true) {
  SmallPacking packing = packing_in_a_box(24, 18);
  for (dem::FiberGroup& group : packing.groups) {
    dem::Fiber& fiber = group.chain.fiber;
    group.chain.smooth = true;
    const double E = fiber.material.youngs_modulus;
    if (breaks)
      fiber.strength = dem::BondStrength{.tension = 0.015 * E, .shear = 0.01 * E, .torsion = 0.01 * E};
  }
  return {packing.groups, packing.around, options};
}

}  // namespace

BOOST_AUTO_TEST_CASE(smooth_runs_go_on_to_the_bit_through_breaks_on_any_threads) {
  dem::AssemblyOptions options{.step = 5e-6, .account_energy = true, .allow_passage = true};
  dem::Assembly run = brittle_packing(options), again = brittle_packing(options);
  options.threads = 3;
  dem::Assembly threads = brittle_packing(options);
  dem::Assembly whole = brittle_packing({.step = 5e-6, .account_energy = true, .allow_passage = true}, false);
  const double energy = dem::total(run.energy()), kinetic = run.energy().kinetic;
  std::size_t early = 0;
  while (early < 20 && run.steps() < 6000) {
    run.march(20);
    early += run.take_breaks().size();
  }
  threads.march(run.steps());
  again.restore(run.saved());
  BOOST_TEST(again.pieces() == run.pieces());
  run.march(1500), again.march(1500), threads.march(1500);
  const std::size_t late = run.take_breaks().size();
  whole.march(run.steps());
  BOOST_TEST_MESSAGE("without strengths the book is off by "
                     << (dem::total(whole.energy()) - energy) / kinetic);
  BOOST_TEST_MESSAGE(early << " breaks, then " << late << "; book off by "
                           << (dem::total(run.energy()) - energy) / kinetic
                           << " of the kinetic energy, breaking " << run.energy().breaking / kinetic);
  // as without breaks: shares have no potential
  BOOST_TEST(std::abs(dem::total(run.energy()) - energy) < 4e-3 * kinetic);
  BOOST_TEST(run.energy().breaking > 0.02 * kinetic);
  BOOST_TEST(early > 3u);
  BOOST_TEST(late > 3u);
  BOOST_TEST((run.saved() == again.saved()));
  BOOST_TEST((run.saved() == threads.saved()));
  BOOST_TEST(run.pieces() == 42 + static_cast<int>(early + late));
}

BOOST_AUTO_TEST_CASE(pieces_that_would_overlap_are_refused) {
  const dem::Chain<3> chain = brittle(8, 0.5);
  BOOST_CHECK_THROW(dem::Assembly({{chain, {dem::at_rest<3>(chain.poses)}}}, {}, {}), dem::InvalidKey);
}

BOOST_AUTO_TEST_SUITE_END()
