// Fibers that touch each other and walls: nothing is missed, momenta are kept, and neither threads nor a
// pause matter.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "dem/assembly/assembly.hpp"
#include "dem/model/errors.hpp"
#include "tests/dem/assembly/assembly_scenes.hpp"

BOOST_AUTO_TEST_SUITE(assembly_test)

namespace dem = fiberchain::dem;

namespace {

using Vec3 = dem::Vec<double, 3>;

dem::Fiber odd_fiber(int aspect_ratio) {
  return {dem::isotropic_material(3.7e5, 0.17, 431.0), 0.0262, aspect_ratio, dem::BondModel::paper, 0.3};
}

/// Fibers along random directions around a common center, toward which they fly and turn.
dem::FiberGroup colliding_fibers(const dem::Fiber& fiber, int count, unsigned seed) {
  dem::FiberGroup group{dem::straight_chain<3>(fiber), {}};
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const double spread = 3 * std::cbrt(count) * fiber.diameter * std::sqrt(fiber.aspect_ratio);
  for (int f = 0; f < count; ++f) {
    // on a cubic grid of cells too large to overlap
    const int side = static_cast<int>(std::ceil(std::cbrt(count)));
    const double cell = (fiber.aspect_ratio + 1.2) * fiber.diameter;
    const Vec3 center{(f % side - 0.5 * side) * cell, (f / side % side - 0.5 * side) * cell,
                      (f / side / side - 0.5 * side) * cell};
    const dem::Quaternion<double> turn = dem::normalized(
        dem::Quaternion<double>{normal(random), {normal(random), normal(random), normal(random)}});
    const Vec3 spin{20 * normal(random), 20 * normal(random), 20 * normal(random)};
    dem::ChainState<3> state = dem::at_rest<3>(group.chain.poses);
    const Vec3 middle = 0.5 * state.poses.back().position;
    for (std::size_t i = 0; i < state.poses.size(); ++i) {
      const Vec3 arm = dem::rotate(turn, state.poses[i].position - middle);
      state.poses[i] = {center + arm, turn};
      state.velocity[i] = (-8.0 / (1 + spread)) * center + dem::cross(spin, arm);
      state.spin[i] = spin;
    }
    group.fibers.push_back(state);
  }
  return group;
}

dem::Domain open_space() {
  dem::Domain around;
  around.contacts = {0.6, 0.35, 0.1};
  return around;
}

dem::Domain box_with_gravity(double size) {
  dem::Domain around = open_space();
  around.gravity = {0.3, -0.2, -9.81};
  around.wall_youngs_modulus = 3.7e5;
  for (int c = 0; c < 3; ++c) {
    for (const double sign : {1.0, -1.0}) {
      Vec3 point{}, normal{};
      normal[c] = sign;
      point[c] = -sign * size / 2;
      around.walls.push_back({dem::Plane{point, normal}});
    }
  }
  return around;
}

std::vector<double> numbers(const dem::Assembly& assembly) {
  std::vector<double> all;
  for (int g = 0; g < assembly.groups(); ++g) {
    for (int f = 0; f < assembly.fibers(g); ++f) {
      const dem::ChainState<3> s = assembly.state(g, f);
      for (std::size_t i = 0; i < s.poses.size(); ++i) {
        for (int c = 0; c < 3; ++c)
          all.insert(all.end(), {s.poses[i].position[c], s.velocity[i][c], s.spin[i][c]});
      }
    }
  }
  return all;
}

}  // namespace

/// Fibers ten thousand times as stiff, their surface as before: steps far beyond the bonds' own.
dem::Fiber stiff_fiber(int aspect_ratio) {
  dem::Fiber fiber = odd_fiber(aspect_ratio);
  fiber.material = dem::isotropic_material(3.7e9, 0.17, 431.0);
  return fiber;
}

dem::AssemblyOptions stiff_options(dem::BondForm form) {
  return {.step = 17 * dem::bond_time_step(stiff_fiber(5)),
          .integrator = dem::Integrator::leapfrog_stiff,
          .form = form};
}

dem::Domain with_soft_surface(dem::Domain around) {
  around.contacts.youngs_modulus = 3.7e5;
  return around;
}

/// 50 fibers of two kinds that collide in open space, with friction, rolling friction and dashpots.
void keeps_momenta(const dem::Fiber& fiber, const dem::Domain& around, const dem::AssemblyOptions& options) {
  dem::FiberGroup all = colliding_fibers(fiber, 50, 3);
  dem::Fiber stiffer = fiber;
  stiffer.material = dem::isotropic_material(2 * fiber.material.youngs_modulus, 0.31, 700.0);
  dem::FiberGroup others{dem::straight_chain<3>(stiffer), {}};
  others.fibers.assign(all.fibers.begin() + 20, all.fibers.end());
  all.fibers.resize(20);
  dem::Assembly assembly({all, others}, around, options);
  const scenes::Momenta before = scenes::momenta(assembly);
  std::int64_t most = 0;
  for (int n = 0; n < 40; ++n) {
    assembly.march(100);
    most = std::max(most, assembly.touching());
  }
  const scenes::Momenta after = scenes::momenta(assembly);
  BOOST_TEST(most > 30);
  const double over = assembly.step() / dem::bond_time_step(fiber);
  BOOST_TEST_MESSAGE("dt / t_b " << over << ": momentum off by "
                                 << dem::norm(after.linear - before.linear) / before.linear_size
                                 << ", angular "
                                 << dem::norm(after.angular - before.angular) / before.angular_size);
  BOOST_TEST(dem::norm(after.linear - before.linear) < 1e-13 * before.linear_size);
  BOOST_TEST(dem::norm(after.angular - before.angular) < 1e-12 * before.angular_size);
}

BOOST_AUTO_TEST_CASE(momenta_of_colliding_fibers_are_kept) {
  keeps_momenta(odd_fiber(5), open_space(), {.threads = 2});
}

BOOST_AUTO_TEST_CASE(momenta_are_kept_where_bonds_are_solved_for) {
  for (const auto form : {dem::BondForm::incremental, dem::BondForm::total}) {
    keeps_momenta(stiff_fiber(5), with_soft_surface(open_space()), stiff_options(form));
  }
}

void goes_on_to_the_bit(const dem::Fiber& fiber, const dem::Domain& around, dem::AssemblyOptions options,
                        int steps) {
  const dem::FiberGroup fibers = colliding_fibers(fiber, 33, 5);
  options.threads = 1;
  dem::Assembly one({fibers}, around, options);
  options.threads = 2;
  dem::Assembly two({fibers}, around, options);
  one.march(steps);
  two.march(700);
  const dem::SavedState pause = two.saved();
  two.march(steps - 700);
  dem::Assembly third({fibers}, around, options);
  third.march(10);
  third.restore(pause);
  BOOST_TEST(third.steps() == 700);
  third.march(steps - 700);
  BOOST_TEST(one.touching() > 10);
  BOOST_TEST((numbers(one) == numbers(two)));
  BOOST_TEST((numbers(two) == numbers(third)));
  BOOST_CHECK_THROW(third.restore({{"steps", {1, std::vector<double>{2.0}}}}), dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(threads_and_a_pause_change_no_bit) {
  goes_on_to_the_bit(odd_fiber(6), box_with_gravity(1.1), {}, 2500);
}

/// Under a sanitizer one form: threads share the same in both.
BOOST_AUTO_TEST_CASE(threads_and_a_pause_change_no_bit_where_bonds_are_solved_for) {
#ifdef FIBERCHAIN_SANITIZED
  const std::vector<dem::BondForm> forms = {dem::BondForm::incremental};
#else
  const std::vector<dem::BondForm> forms = {dem::BondForm::incremental, dem::BondForm::total};
#endif
  for (const auto form : forms) {
    goes_on_to_the_bit(stiff_fiber(6), with_soft_surface(box_with_gravity(1.1)), stiff_options(form), 6000);
  }
}

/// Instruction sets differ by round-off, which collisions let grow: compared while few have happened.
void instruction_sets_agree(const dem::Fiber& fiber, const dem::Domain& around, dem::AssemblyOptions options,
                            int steps) {
  const dem::FiberGroup fibers = colliding_fibers(fiber, 33, 5);
  std::vector<double> first;
  for (const auto set : {dem::InstructionSet::scalar, dem::best_instruction_set()}) {
    options.instruction_set = set;
    dem::Assembly assembly({fibers}, around, options);
    assembly.march(steps);
    const std::vector<double> now = numbers(assembly);
    if (first.empty()) {
      first = now;
      continue;
    }
    BOOST_TEST(assembly.touching() > 0);
    for (std::size_t i = 0; i < now.size(); ++i)
      BOOST_TEST(std::abs(now[i] - first[i]) < 1e-9 * (1 + std::abs(first[i])));
  }
}

BOOST_AUTO_TEST_CASE(instruction_sets_agree_to_round_off) {
  instruction_sets_agree(odd_fiber(6), box_with_gravity(1.1), {}, 400);
  instruction_sets_agree(stiff_fiber(6), with_soft_surface(box_with_gravity(1.1)),
                         stiff_options(dem::BondForm::incremental), 1000);
}

/// Every sphere rests on the floor: the walls carry the weight.
BOOST_AUTO_TEST_CASE(floor_carries_the_weight) {
  dem::Fiber fiber = odd_fiber(4);
  fiber.bond_damping = 1;
  dem::FiberGroup group{dem::straight_chain<3>(fiber), {}};
  dem::ChainState<3> state = dem::at_rest<3>(group.chain.poses);
  for (auto& pose : state.poses) pose.position[2] = 0.0131;
  group.fibers = {state, state, state};
  for (int f = 0; f < 3; ++f) {
    for (auto& pose : group.fibers[f].poses) pose.position[1] = 0.1 * f;
  }
  dem::Domain around = open_space();
  around.contacts = {0.05, 0.5, 0};
  around.gravity = {0, 0, -9.81};
  around.walls = {{dem::Plane{{0, 0, 0}, {0, 0, 1}}}};
  dem::Assembly assembly({group}, around, {});
  assembly.march(40000);
  double carried = 0;
  const auto contacts = assembly.contacts();
  BOOST_TEST(contacts.size() == 15u);
  for (const dem::ContactState& contact : contacts) {
    BOOST_TEST((contact.key.second == dem::facet_primitive(0)));
    carried += contact.force[2];
  }
  BOOST_TEST(carried == 15 * dem::sphere_mass(fiber) * 9.81, boost::test_tools::tolerance(1e-6));
  // Hertz against a rigid wall: d = (3 F (1 - nu^2) / (4 E sqrt(R)))^(2/3)
  const double F = dem::sphere_mass(fiber) * 9.81;
  const double overlap = std::pow(0.75 * F * (1 - 0.17 * 0.17) / (3.7e5 * std::sqrt(0.0131)), 2.0 / 3);
  BOOST_TEST(0.0131 - assembly.state(0, 1).poses[2].position[2] == overlap,
             boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  const dem::FiberGroup fibers = colliding_fibers(odd_fiber(3), 2, 5);
  BOOST_CHECK_THROW(dem::Assembly({}, open_space(), {}), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::Assembly({fibers}, open_space(), {.step = 0.0}), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::Assembly({fibers}, open_space(), {.threads = 0}), dem::InvalidInput);
  for (const double restitution : {0.0, 1.2}) {
    dem::Domain around = open_space();
    around.contacts.restitution = restitution;
    BOOST_CHECK_THROW(dem::Assembly({fibers}, around, {}), dem::InvalidInput);
  }
  dem::Domain narrow = open_space();
  narrow.period = {0.05, 0, 0};
  BOOST_CHECK_THROW(dem::Assembly({fibers}, narrow, {}), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::Assembly({fibers}, open_space(), {.step = 1.0}), dem::InvalidInput);
  dem::Domain behind = open_space();
  behind.walls = {{dem::Plane{{0, 0, 3}, {0, 0, 1}}}};
  BOOST_CHECK_THROW(dem::Assembly({fibers}, behind, {}), dem::InvalidInput);
  dem::FiberGroup torn = fibers;
  torn.fibers[1].velocity[2] = {1e4, 0, 0};
  dem::Assembly wild({torn}, open_space(), {});
  BOOST_CHECK_THROW(wild.march(2000), dem::Diverged);
}

BOOST_AUTO_TEST_SUITE_END()
