// What has come too deep or too far in a step for contacts to hold it is noticed.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "dem/assembly/assembly.hpp"
#include "dem/insertion/placement.hpp"
#include "dem/model/errors.hpp"

BOOST_AUTO_TEST_SUITE(passage_test)

namespace dem = fiberchain::dem;

namespace {

/// Odd numbers; two spheres of a fiber that lies level.
dem::Fiber soft_fiber() {
  return {.material = dem::isotropic_material(0.7e6, 0.17, 1130), .diameter = 2.6e-3, .aspect_ratio = 1};
}

/// The fiber at height `gap` over a rigid floor, with a speed downward.
dem::Assembly falling(double gap, double speed, const dem::AssemblyOptions& options = {}) {
  const dem::Fiber fiber = soft_fiber();
  dem::FiberGroup group{dem::straight_chain<3>(fiber), {}};
  const double height = dem::sphere_radius(fiber) + gap;
  group.fibers.push_back(placed(group.chain, {{0, 0, height}, {1, 0, 0}, {0, 0, -speed}}));
  dem::Domain domain;
  dem::Plane floor{};
  floor.normal = {0, 0, 1};
  domain.walls.push_back({floor});
  domain.contacts.restitution = 1;
  return dem::Assembly({group}, domain, options);
}

/// Largest overlap of a sphere that hits a rigid wall, over its radius: m v^2 / 2 = 2/5 k d^(5/2), Hertz.
double hertz_depth(double speed) {
  const dem::Fiber f = soft_fiber();
  const double R = dem::sphere_radius(f), E = f.material.youngs_modulus / (1 - 0.17 * 0.17);
  const double k = 4.0 / 3 * E * std::sqrt(R);
  return std::pow(1.25 * dem::sphere_mass(f) * speed * speed / k, 0.4) / R;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_deepest_overlap_is_that_of_hertz) {
  for (const double speed : {0.03, 0.9, 4.0}) {
    const double radius = dem::sphere_radius(soft_fiber());
    const double step = 0.02 * dem::bond_time_step(soft_fiber());
    dem::Assembly assembly = falling(0.1 * radius, speed, {.step = step});
    BOOST_TEST(assembly.deepest_overlap() == 0.0);
    while (assembly.state(0, 0).velocity[0][2] < 0) assembly.march(10);
    BOOST_TEST(assembly.deepest_overlap() == hertz_depth(speed), boost::test_tools::tolerance(2e-3));
    BOOST_TEST(assembly.longest_path() == speed * step / radius, boost::test_tools::tolerance(1e-3));
  }
}

BOOST_AUTO_TEST_CASE(a_fiber_pressed_in_by_its_radius_ends_the_run) {
  const double radius = dem::sphere_radius(soft_fiber());
  const double step = 0.02 * dem::bond_time_step(soft_fiber());
  const double speed = std::pow(1.3 / hertz_depth(1), 1.25);  // overlap 1.3 R
  dem::Assembly assembly = falling(0.1 * radius, speed, {.step = step});
  BOOST_CHECK_EXCEPTION(assembly.march(2000), dem::Diverged, [](const dem::Diverged& error) {
    return std::string(error.what()).find("may have passed through") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(a_path_of_more_than_half_a_radius_in_a_step_ends_the_run) {
  const double radius = dem::sphere_radius(soft_fiber()), step = 0.02 * dem::bond_time_step(soft_fiber());
  dem::Assembly slow = falling(90 * radius, 0.49 * radius / step, {.step = step});
  BOOST_CHECK_NO_THROW(slow.march(20));
  dem::Assembly fast = falling(90 * radius, 0.51 * radius / step, {.step = step});
  BOOST_CHECK_THROW(fast.march(20), dem::Diverged);
}

BOOST_AUTO_TEST_SUITE_END()
