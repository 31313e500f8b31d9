// Forces of single contacts, as files have them: those that move spheres and walls, to round-off.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "dem/assembly/assembly.hpp"
#include "dem/insertion/placement.hpp"
#include "tests/dem/walls_in_motion.hpp"

BOOST_AUTO_TEST_SUITE(contact_forces_test)

namespace dem = fiberchain::dem;
using V = dem::Vec<double, 3>;
using namespace walls_in_motion;

namespace {

constexpr double kStep = 4e-6;  ///< [s]

/// Fibers of two kinds fall in a drum that turns, with a paddle and a lid that is driven.
struct Tumbler {
  dem::Domain around;
  std::vector<dem::FiberGroup> groups;

  Tumbler() {
    around.gravity = {0.2, 0.3, -g};
    around.contacts = {.restitution = 0.6, .friction = 0.35};
    around.wall_youngs_modulus = 5e6;
    const V y{0, 1, 0};
    dem::Wall drum{dem::Cylinder{{}, y, 0.014}}, left{dem::Plane{{0, -5.3e-3, 0}, y}},
        lid{dem::Plane{{0, 0.012, 0}, -y}},
        paddle{dem::BoxObstacle{{0, 0, -12e-3}, {1e-3, 6e-3, 2e-3}, {1, 0, 0}, y}};
    drum.motion.about = dem::WallAxis{{}, y};
    drum.motion.angular_velocity = 31;
    lid.motion.drive = dem::WallDrive{.axis = -y, .mass = 2e-4, .force = 3e-3, .damping = 0.01};
    around.walls = {drum, left, lid, paddle};
    add(5, 9, 0.011, 0.2);
    add(4, 7, 0.0072, 0.5);
  }

  void add(int aspect_ratio, int fibers, double ring, double from) {
    dem::Fiber fiber = fiber_with(aspect_ratio);
    fiber.bond_damping = 0;  // dashpots act at velocities half a step before: their force now is another
    if (aspect_ratio == 4) fiber.diameter *= 1.2;
    dem::FiberGroup group{dem::straight_chain<3>(fiber), {}};
    for (int n = 0; n < fibers; ++n) {
      const double angle = from + 2 * pi * n / fibers;
      group.fibers.push_back(
          dem::placed(group.chain, {{ring * std::cos(angle), -4e-3, ring * std::sin(angle)},
                                    {0, 1, 0},
                                    {0.1 * std::sin(5 * angle), -0.05, -0.2}}));
    }
    groups.push_back(std::move(group));
  }

  dem::Assembly assembly() const { return {groups, around, {.step = kStep, .form = dem::BondForm::total}}; }
};

std::vector<V> places(const dem::Assembly& assembly) { return assembly.placed().position; }

/// All forces on each sphere: contacts, bonds, weight.
std::vector<V> forces_on(const dem::Assembly& assembly, const std::vector<dem::ContactState>& contacts,
                         const V& gravity) {
  std::vector<V> all;
  for (int group = 0; group < assembly.groups(); ++group) {
    const double m = dem::sphere_mass(assembly.chain(group).fiber);
    for (int f = 0; f < assembly.fibers(group); ++f) {
      const std::size_t first = all.size();
      all.resize(first + static_cast<std::size_t>(assembly.chain(group).fiber.aspect_ratio) + 1, m * gravity);
      const auto bonds = assembly.bonds(group, f);
      for (std::size_t i = 0; i < bonds.size(); ++i) {
        all[first + i] = all[first + i] + bonds[i].force;
        all[first + i + 1] = all[first + i + 1] - bonds[i].force;
      }
    }
  }
  for (const dem::ContactState& contact : contacts) {
    V& on = all[static_cast<std::size_t>(contact.key.first.number)];
    on = on + contact.force;
    if (!dem::is_sphere(contact.key.second)) continue;
    V& other = all[static_cast<std::size_t>(contact.key.second.number)];
    other = other - contact.force;
  }
  return all;
}

std::vector<double> masses(const dem::Assembly& assembly) {
  std::vector<double> all;
  for (int group = 0; group < assembly.groups(); ++group) {
    const dem::Fiber& fiber = assembly.chain(group).fiber;
    all.insert(all.end(), static_cast<std::size_t>(assembly.fibers(group)) * (fiber.aspect_ratio + 1),
               dem::sphere_mass(fiber));
  }
  return all;
}

/// Largest difference of mass times acceleration from the sum of the forces, over the weight.
double unbalanced(const std::vector<V> (&x)[3], const std::vector<V>& forces,
                  const std::vector<double>& mass) {
  double largest = 0;
  for (std::size_t i = 0; i < mass.size(); ++i) {
    const V acceleration = (1 / (kStep * kStep)) * (x[2][i] - 2.0 * x[1][i] + x[0][i]);
    largest = std::max(largest, norm(mass[i] * acceleration - forces[i]) / (mass[i] * g));
  }
  return largest;
}

}  // namespace

/// Places of three steps give the acceleration to 1e-6 m/s^2, where contacts accelerate by 10 to 1000.
BOOST_AUTO_TEST_CASE(contacts_bonds_and_weight_are_mass_times_acceleration) {
  const Tumbler tumbler;
  dem::Assembly assembly = tumbler.assembly();
  const std::vector<double> mass = masses(assembly);
  std::size_t between = 0, at_walls = 0;
  double exact = 0, first_order = 0;
  for (int n = 0; n < 40; ++n) {
    assembly.march(300);
    std::vector<V> x[3] = {places(assembly), {}, {}};
    assembly.march(1, dem::ContactForces::kept);
    x[1] = places(assembly);
    const auto contacts = assembly.contact_forces();
    const auto forces = forces_on(assembly, contacts, tumbler.around.gravity),
               others = forces_on(assembly, assembly.contacts(), tumbler.around.gravity);
    for (const auto& contact : contacts) (dem::is_sphere(contact.key.second) ? between : at_walls) += 1;
    assembly.march(1);
    x[2] = places(assembly);
    exact = std::max(exact, unbalanced(x, forces, mass));
    first_order = std::max(first_order, unbalanced(x, others, mass));
  }
  BOOST_TEST_MESSAGE("forces off by " << exact << " of the weight, without the step before " << first_order);
  BOOST_TEST(exact < 1e-6);
  BOOST_TEST(first_order > 1e-4);  // what is kept is needed
  BOOST_TEST(between > 50u);
  BOOST_TEST(at_walls > 50u);
}

/// Newton's third law: contacts and walls have the same, and the moments too.
BOOST_AUTO_TEST_CASE(contacts_sum_to_the_loads_of_walls) {
  const Tumbler tumbler;
  dem::Assembly assembly = tumbler.assembly();
  std::vector<double> largest(tumbler.around.walls.size(), 0);
  for (int n = 0; n < 60; ++n) {
    assembly.march(211, dem::ContactForces::kept);
    assembly.begin_wall_interval();
    const auto samples = assembly.wall_samples();
    std::vector<V> force(samples.size()), moment(samples.size());
    for (const dem::ContactState& contact : assembly.contact_forces()) {
      BOOST_TEST(std::abs(norm(contact.normal) - 1) < 1e-14);
      if (!dem::is_facet(contact.key.second)) continue;
      const auto w = static_cast<std::size_t>(contact.key.second.number);
      force[w] = force[w] - contact.force;
      moment[w] = moment[w] - cross(contact.point - samples[w].center, contact.force);
    }
    for (std::size_t w = 0; w < samples.size(); ++w) {
      const double size = samples[w].force_peak;
      BOOST_TEST(norm(samples[w].mean.force - force[w]) <= 1e-11 * size);
      BOOST_TEST(norm(samples[w].mean.moment - moment[w]) <= 1e-11 * 0.02 * size);
      largest[w] = std::max(largest[w], size);
    }
  }
  for (const double size : largest) BOOST_TEST(size > 0.0);
}

/// Fibers that come at the end of a march do not change what its last step had.
BOOST_AUTO_TEST_CASE(forces_stay_as_fibers_are_inserted) {
  Tumbler tumbler;
  dem::Assembly assembly = tumbler.assembly();
  assembly.march(12000, dem::ContactForces::kept);
  const auto before = assembly.contact_forces();
  tumbler.groups.clear();
  tumbler.add(5, 1, 0, 0);
  assembly.insert(tumbler.groups[0]);
  const auto after = assembly.contact_forces();
  BOOST_TEST(before.size() > 3u);
  BOOST_TEST_REQUIRE(after.size() == before.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    BOOST_TEST((after[i].key == before[i].key));
    for (int c = 0; c < 3; ++c) BOOST_TEST(after[i].force[c] == before[i].force[c]);
  }
}

BOOST_AUTO_TEST_SUITE_END()
