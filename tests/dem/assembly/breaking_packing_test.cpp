// Packings whose fibers break: to the bit on any threads and through saved states, with their books.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "tests/dem/assembly/breaking_scenes.hpp"
#include "tests/dem/small_packing.hpp"

BOOST_AUTO_TEST_SUITE(breaking_packing_test)

using namespace scenes;

namespace {

constexpr dem::BondForm forms[] = {dem::BondForm::total, dem::BondForm::incremental};
constexpr dem::Integrator schemes[] = {dem::Integrator::leapfrog, dem::Integrator::leapfrog_stiff};

dem::AssemblyOptions options_of(dem::BondForm form, dem::Integrator scheme = dem::Integrator::leapfrog) {
  return {.integrator = scheme, .form = form, .account_energy = true, .allow_passage = true};
}

double total_of(const dem::Assembly& assembly) { return dem::total(assembly.energy()); }

}  // namespace

namespace {

/// Strong bends and torsions among many fibers that meet in a box.
std::vector<dem::FiberGroup> brittle(std::vector<dem::FiberGroup> groups) {
  for (dem::FiberGroup& group : groups) {
    dem::Fiber& fiber = group.chain.fiber;
    const double E = fiber.material.youngs_modulus;
    fiber.strength = dem::BondStrength{.tension = 0.015 * E,
                                       .compression = 0.02 * E,
                                       .shear = 0.01 * E,
                                       .torsion = 0.01 * E,
                                       .weibull = dem::WeibullSpread{4, dem::fiber_length(fiber), 11}};
  }
  return groups;
}

dem::Assembly brittle_packing(const dem::AssemblyOptions& options) {
  const SmallPacking packing = packing_in_a_box(24, 18);
  return {brittle(packing.groups), packing.around, options};
}

}  // namespace

BOOST_AUTO_TEST_CASE(runs_go_on_to_the_bit_through_breaks_on_any_threads) {
  for (const dem::BondForm form : forms) {
    for (const dem::Integrator scheme : schemes) {
      dem::AssemblyOptions options = options_of(form, scheme);
      options.step = scheme == dem::Integrator::leapfrog ? 5e-6 : 2e-5;
      dem::Assembly run = brittle_packing(options), again = brittle_packing(options);
      options.threads = 3;
      dem::Assembly threads = brittle_packing(options);
      const int steps = scheme == dem::Integrator::leapfrog ? 2000 : 500;
      std::vector<dem::BondBreak> early;
      while (early.size() < 20) {
        run.march(20);
        for (const dem::BondBreak& one : run.take_breaks()) early.push_back(one);
      }
      threads.march(run.steps());
      again.restore(run.saved());
      BOOST_TEST(again.pieces() == run.pieces());
      run.march(steps), again.march(steps), threads.march(steps);
      const auto late = run.take_breaks(), same = again.take_breaks();
      BOOST_TEST_MESSAGE(name(form) << ", " << name(scheme) << ": " << early.size() << " breaks, then "
                                    << late.size());
      BOOST_TEST(early.size() > 3);
      BOOST_TEST(late.size() > 3);
      BOOST_REQUIRE(late.size() == same.size());
      for (std::size_t n = 0; n < late.size(); ++n) {
        BOOST_TEST(late[n].step == same[n].step);
        BOOST_TEST(late[n].fiber == same[n].fiber);
        BOOST_TEST(late[n].bond == same[n].bond);
        BOOST_TEST(late[n].stress == same[n].stress);
      }
      BOOST_TEST((run.saved() == again.saved()));
      BOOST_TEST((run.saved() == threads.saved()));
      BOOST_TEST(run.pieces() == 42 + static_cast<int>(early.size() + late.size()));
    }
  }
}

namespace {

/// Error of the whole book over the kinetic energy at first.
double book_error(dem::Assembly assembly, double time, dem::EnergyBalance& end) {
  const double before = total_of(assembly), kinetic = assembly.energy().kinetic;
  assembly.march(std::llround(time / assembly.step()));
  end = assembly.energy();
  end.breaking /= kinetic;
  return (dem::total(assembly.energy()) - before) / kinetic;
}

}  // namespace

/// The book of a packing that breaks closes about as that of one that does not.
BOOST_AUTO_TEST_CASE(energy_of_a_breaking_packing_closes) {
  for (const dem::Integrator scheme : schemes) {
    dem::AssemblyOptions options = options_of(dem::BondForm::incremental, scheme);
    options.step = 4e-6;
    dem::EnergyBalance end{}, plain_end{};
    const double error = book_error(brittle_packing(options), 0.016, end),
                 plain = book_error(packing_in_a_box(24, 18).assembly(options), 0.016, plain_end);
    BOOST_TEST_MESSAGE(name(scheme) << ": breaking took " << end.breaking
                                    << " of the kinetic energy; the total is off by " << error
                                    << ", without strengths by " << plain);
    BOOST_TEST(end.breaking > 0.02);
    BOOST_TEST(std::abs(error) < 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(pieces_keep_momentum_and_angular_momentum) {
  for (const dem::BondForm form : forms) {
    dem::FiberGroup group = scattered(dem::straight_chain<3>(odd_fiber(11)), 13, 0.03, 3);
    const dem::Fiber plain = group.chain.fiber;
    dem::Assembly assembly(brittle({group}), {}, options_of(form));
    const auto sums = [&] {
      V p{}, L{};
      for (int f = 0; f < assembly.fibers(0); ++f) {
        const dem::ChainState<3> s = assembly.state(0, f);
        const double m = dem::sphere_mass(plain), J = dem::sphere_inertia(plain);
        for (std::size_t i = 0; i < s.poses.size(); ++i) {
          p = p + m * s.velocity[i];
          L = L + m * cross(s.poses[i].position, s.velocity[i]) + J * s.spin[i];
        }
      }
      return std::pair{p, L};
    };
    const auto before = sums();
    assembly.march(1500);
    const auto after = sums();
    BOOST_TEST(assembly.take_breaks().size() > 20u);
    BOOST_TEST(norm(after.first - before.first) < 1e-12 * norm(before.first));
    BOOST_TEST(norm(after.second - before.second) < 1e-12 * norm(before.second));
  }
}

/// Fibers that come later touch the pieces that are there, and their bonds have strengths of their own.
BOOST_AUTO_TEST_CASE(fibers_come_among_pieces) {
  dem::AssemblyOptions options = options_of(dem::BondForm::incremental);
  options.step = 5e-6;
  dem::Assembly assembly = brittle_packing(options);
  std::size_t breaks = 0;
  while (breaks < 20) {
    assembly.march(20);
    breaks += assembly.take_breaks().size();
  }
  const auto pairs = [&] {
    std::vector<dem::ContactKey> keys;
    for (const dem::ContactState& contact : assembly.contacts()) keys.push_back(contact.key);
    return keys;
  };
  const auto before = pairs();
  dem::FiberGroup late = scattered(dem::straight_chain<3>(odd_fiber(5, 0.05)), 1, 0.01, 9);
  move(late.fibers[0], {0.012, 0.011, 0.08});
  assembly.insert(brittle({late})[0]);
  BOOST_TEST((pairs() == before));
  BOOST_TEST(assembly.pieces() == 42 + 1 + static_cast<int>(breaks));
  dem::Assembly again = brittle_packing(options);
  again.insert(brittle({late})[0]);
  again.restore(assembly.saved());
  assembly.march(1000), again.march(1000);
  BOOST_TEST(assembly.take_breaks().size() > 10u);
  BOOST_TEST((assembly.saved() == again.saved()));
}

BOOST_AUTO_TEST_SUITE_END()
