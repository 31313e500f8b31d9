// Contacts of their own modulus: collisions against Hertz's closed forms, the step that they allow, and how
// deep they are.
#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "dem/contact/contact_law.hpp"
#include "dem/contact/impact.hpp"
#include "dem/model/errors.hpp"
#include "tests/dem/transverse_fibers.hpp"

BOOST_AUTO_TEST_SUITE(soft_contact_test)

using namespace transverse;

namespace {

const dem::Fiber steel = fiber_of(180e9, 0.29, 7700, 21e-6), glass = fiber_of(71e9, 0.22, 2450, 21e-6);

/// The fiber's sphere with the surface of these contacts.
ref::ElasticBody surface_of(const dem::Fiber& fiber, const dem::ContactProperties& contacts) {
  ref::ElasticBody body = body_of(fiber);
  if (contacts.youngs_modulus) body.youngs_modulus = *contacts.youngs_modulus;
  if (contacts.poisson_ratio) body.poisson_ratio = *contacts.poisson_ratio;
  return body;
}

dem::Domain elastic_walls(const dem::ContactProperties& contacts) {
  dem::Domain around;
  around.wall_youngs_modulus = 3.3e9;
  around.wall_poisson_ratio = 0.37;
  around.contacts = contacts;
  return around;
}

struct Outcome {
  double time, overlap;
};

/// A sphere of `first` hits one of `second`, or the wall where there is none, both of the fiber behind it
/// moving alike; the step is a part of the time that is expected.
Outcome collide(const dem::Fiber& first, const dem::Fiber* second, dem::Domain around, double speed,
                double expected_time) {
  constexpr int steps = 2000;
  const double dt = expected_time / steps, gap = 0.37 * dt * speed, R = dem::sphere_radius(first);
  std::vector<dem::FiberGroup> groups;
  if (second) {
    groups = {group_of(first, 0, 0, {{0.3 * speed, 0}, 0}),
              group_of(*second, R + dem::sphere_radius(*second) + gap, 0, {{-0.7 * speed, 0}, 0})};
  } else {
    groups = {group_of(first, -R - gap, 0, {{speed, 0}, 0})};
    around.walls = {{dem::Plane{{}, tilted(-1, 0, 0)}}};
  }
  dem::Assembly assembly(groups, around, {.step = dt});
  Outcome found{};
  while (assembly.steps() < 3 * steps) {
    assembly.march(1);
    if (assembly.touching() > 0) found.time += dt;
  }
  found.overlap = assembly.deepest_overlap();
  return found;
}

const dem::ContactProperties soft{.youngs_modulus = 0.4e9, .poisson_ratio = 0.41};

}  // namespace

BOOST_AUTO_TEST_CASE(softened_collisions_are_hertz_with_the_modulus_of_the_contacts) {
  dem::ContactProperties modulus_alone = soft;
  modulus_alone.poisson_ratio.reset();
  for (const dem::ContactProperties& contacts : {soft, modulus_alone}) {
    for (const dem::Fiber* second : {&steel, &glass, static_cast<const dem::Fiber*>(nullptr)}) {
      for (const double speed : {0.013, 0.27}) {
        const dem::Domain around = elastic_walls(contacts);
        const ref::HertzPair pair = ref::hertz_pair(surface_of(steel, contacts),
                                                    second ? surface_of(*second, contacts) : wall_of(around));
        const auto hertz = ref::hertz_collision(pair, speed);
        const Outcome found = collide(steel, second, around, speed, hertz.time);
        const double smaller = dem::sphere_radius(steel);
        BOOST_TEST(found.time == hertz.time, boost::test_tools::tolerance(1e-3));
        BOOST_TEST(found.overlap == hertz.overlap / smaller, boost::test_tools::tolerance(1e-4));
        // v t_c / 2.94 whatever the modulus
        BOOST_TEST(found.overlap * smaller == speed * found.time / 2.943,
                   boost::test_tools::tolerance(1.5e-3));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_predicted_impact_is_hertz) {
  for (const dem::ContactProperties& contacts : {dem::ContactProperties{}, soft}) {
    const dem::Domain around = elastic_walls(contacts);
    const dem::ContactBody first = dem::sphere_body(steel, contacts);
    for (const bool at_wall : {false, true}) {
      const dem::ContactBody second = at_wall ? dem::wall_body(around) : dem::sphere_body(glass, contacts);
      const ref::HertzPair pair = ref::hertz_pair(surface_of(steel, contacts),
                                                  at_wall ? wall_of(around) : surface_of(glass, contacts));
      for (const double speed : {1e-6, 0.27, 40.0}) {
        const dem::Impact impact = dem::elastic_impact(first, second, contacts, speed);
        const auto hertz = ref::hertz_collision(pair, speed);
        BOOST_TEST(impact.overlap == hertz.overlap, boost::test_tools::tolerance(1e-12));
        BOOST_TEST(impact.time == hertz.time, boost::test_tools::tolerance(1e-4));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_step_of_contacts_follows_their_modulus_and_that_of_bonds_does_not) {
  const std::vector<dem::FiberGroup> groups{{dem::straight_chain<3>(steel), {}}};
  dem::Domain around;
  around.contacts = {.restitution = 0.6, .friction = 0.3};
  const dem::StepChoice own = dem::stable_time_step(groups, around);
  around.contacts.youngs_modulus = steel.material.youngs_modulus / 625;
  const dem::StepChoice softer = dem::stable_time_step(groups, around);
  // stiffness as the modulus, dashpots as its root: what a step uses up depends on dt sqrt(E) alone
  BOOST_TEST(softer.contacts / own.contacts == 25, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(softer.bonds == own.bonds);
  BOOST_TEST(softer.step > own.step);
  around.contacts.youngs_modulus = steel.material.youngs_modulus;
  BOOST_TEST(dem::stable_time_step(groups, around).step == own.step);
}

BOOST_AUTO_TEST_CASE(the_mean_overlap_is_that_of_the_contacts_each_over_its_smaller_radius) {
  // a thick fiber on a wall, a thin one pressed into it
  const dem::Fiber wide = fiber_of(71e9, 0.22, 2450, 34e-6);
  const double thick = dem::sphere_radius(wide), thin = dem::sphere_radius(steel);
  dem::Domain around = elastic_walls(soft);
  around.walls = {{dem::Plane{{}, tilted(-1, 0, 0)}}};
  const double at_wall = 0.031 * thick, between = 0.017 * thin, place = -thick + at_wall;
  dem::Assembly assembly(
      {group_of(wide, place, 0, {}), group_of(steel, place - thick - thin + between, 0, {})}, around, {});
  const dem::AssemblySample sample = assembly.sample();
  BOOST_TEST(sample.overlapping == 3);  // both spheres on the wall, the first ones on each other
  BOOST_TEST(sample.overlap_mean() == (2 * 0.031 + 0.017) / 3, boost::test_tools::tolerance(1e-9));
  const dem::Assembly apart({group_of(wide, -3 * thick, 0, {})}, around, {});
  BOOST_TEST(apart.sample().overlap_mean() == 0);
}

BOOST_AUTO_TEST_CASE(contacts_of_no_material_are_refused) {
  for (const double E : {0.0, -1e6, infinite}) {
    BOOST_CHECK_THROW(check(dem::ContactProperties{.youngs_modulus = E}), dem::InvalidInput);
  }
  for (const double nu : {-1.0, 0.51}) {
    BOOST_CHECK_THROW(check(dem::ContactProperties{.poisson_ratio = nu}), dem::InvalidInput);
  }
  BOOST_CHECK_NO_THROW(check(dem::ContactProperties{.youngs_modulus = 1e3, .poisson_ratio = 0.5}));
}

BOOST_AUTO_TEST_SUITE_END()
