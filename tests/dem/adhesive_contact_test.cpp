// Laws that adhere, in assemblies: every instruction set and size alike, momentum, at walls, what is refused.
#include <boost/test/unit_test.hpp>

#include "dem/contact/contact_law.hpp"
#include "dem/model/errors.hpp"
#include "reference/adhesion.hpp"
#include "tests/dem/transverse_fibers.hpp"

BOOST_AUTO_TEST_SUITE(adhesive_contact_test)

using namespace transverse;

namespace {

constexpr double kAdhesion = 0.061;
const dem::Fiber soft = fiber_of(2.6e6, 0.31, 1130, 1.66e-3), hard = fiber_of(7.1e6, 0.22, 2410, 1.66e-3);

dem::Domain sticky(const char* law) {
  dem::Domain around;
  around.contacts = {.restitution = 0.8, .friction = 0.3, .rolling_friction = 0.02};
  around.contacts.law = &dem::contact_law(law);
  around.contacts.work_of_adhesion = kAdhesion;
  return around;
}

/// The largest pull over `pull` of a sphere that hits a wall and comes off, or one of other stuff.
double largest_pull(const char* law, const dem::Fiber* second, double speed, dem::InstructionSet set) {
  dem::Domain around = sticky(law);
  around.contacts.restitution = 1;
  const double R = dem::sphere_radius(soft), gap = 3e-6;
  std::vector<dem::FiberGroup> groups{group_of(soft, -R - gap, 0, {{speed, 0}, 0})};
  if (second) {
    groups.push_back(group_of(*second, dem::sphere_radius(*second), 0, {}));
  } else {
    around.walls = {{dem::Plane{{}, tilted(-1, 0, 0)}, {}}};
  }
  dem::Assembly assembly(groups, around, {.step = 4e-7, .account_energy = true, .instruction_set = set});
  const ref::HertzPair pair = ref::hertz_pair(body_of(soft), second ? body_of(*second) : wall_of(around));
  double pull = 0;
  const double before = total(assembly.energy());
  bool held = false;
  for (int n = 0; n < 20000 && !(held && assembly.touching() == 0); ++n) {
    assembly.march(1);
    for (const auto& contact : assembly.contacts()) {
      held = held || contact.overlap != 0;
      pull = std::max(pull, untilted(contact.force)[0]);
    }
  }
  BOOST_TEST(held);
  BOOST_TEST(assembly.touching() == 0, law << " does not let go");
  BOOST_TEST(std::abs(total(assembly.energy()) / before - 1) < 0.01,
             law << ": account off by " << total(assembly.energy()) / before - 1);
  return pull / (law[0] == 'j' ? ref::jkr_pull_off(pair, kAdhesion) : ref::dmt_pull_off(pair, kAdhesion));
}

}  // namespace

BOOST_AUTO_TEST_CASE(walls_and_unlike_spheres_come_off_at_the_force_of_their_law) {
  for (const char* law : {"jkr", "dmt"}) {
    for (const dem::Fiber* second : {&hard, static_cast<const dem::Fiber*>(nullptr)}) {
      const double scalar = largest_pull(law, second, 0.05, dem::InstructionSet::scalar),
                   wide = largest_pull(law, second, 0.05, dem::best_instruction_set());
      BOOST_TEST(scalar == 1, boost::test_tools::tolerance(0.01));
      BOOST_TEST(wide == scalar, boost::test_tools::tolerance(1e-9));
    }
  }
}

/// Oblique, spinning, with dashpots and friction: momentum and angular momentum stay, energy closes.
BOOST_AUTO_TEST_CASE(adhesion_keeps_momentum_and_its_account) {
  for (const char* law : {"jkr", "dmt"}) {
    const double R = dem::sphere_radius(soft), reach = R + dem::sphere_radius(hard);
    const std::vector<dem::FiberGroup> groups{group_of(soft, 0, 0, {{0.03, 0.02}, 31}),
                                              group_of(hard, reach + 2e-6, 0.1 * R, {{-0.02, -0.01}, -17})};
    dem::Assembly assembly(groups, sticky(law), {.step = 4e-7, .account_energy = true});
    const double m1 = dem::sphere_mass(soft), m2 = dem::sphere_mass(hard);
    const auto momentum = [&](int k) {
      return m1 * motion_of(assembly, 0).velocity[k] + m2 * motion_of(assembly, 1).velocity[k];
    };
    const auto angular = [&] {
      double sum = 0;
      for (int g = 0; g < 2; ++g) {
        const dem::Fiber& fiber = g == 0 ? soft : hard;
        const V x = place_of(assembly, g);
        const ref::PlanarMotion m = motion_of(assembly, g);
        sum += dem::sphere_mass(fiber) * (x[0] * m.velocity[1] - x[1] * m.velocity[0]) +
               dem::sphere_inertia(fiber) * m.spin;
      }
      return sum;
    };
    const double px = momentum(0), py = momentum(1), L = angular(), energy = total(assembly.energy());
    const double scale = m2 * 0.03;
    assembly.march(4000);
    BOOST_TEST(std::abs(momentum(0) - px) < 1e-12 * scale);
    BOOST_TEST(std::abs(momentum(1) - py) < 1e-12 * scale);
    BOOST_TEST(std::abs(angular() - L) < 1e-11 * scale * R);
    BOOST_TEST(std::abs(total(assembly.energy()) / energy - 1) < 0.02, law);
    BOOST_TEST(assembly.energy().contact_normal > 0);
  }
}

BOOST_AUTO_TEST_CASE(work_of_adhesion_belongs_to_laws_that_adhere) {
  dem::ContactProperties properties{};
  properties.law = &dem::contact_law("jkr");
  BOOST_CHECK_THROW(dem::check(properties), dem::InvalidInput);
  properties.work_of_adhesion = 0.1;
  BOOST_CHECK_NO_THROW(dem::check(properties));
  properties.law = nullptr;
  BOOST_CHECK_THROW(dem::check(properties), dem::InvalidInput);
}

BOOST_AUTO_TEST_SUITE_END()
