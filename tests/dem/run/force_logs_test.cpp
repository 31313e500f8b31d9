// Rows of NAME-walls.csv and NAME-held.csv: a fiber at rest on one of two plates, held by its end.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/insertion/placement.hpp"
#include "dem/run/held_log.hpp"
#include "dem/run/wall_log.hpp"

BOOST_AUTO_TEST_SUITE(force_logs_test)

namespace dem = fiberchain::dem;

namespace {

struct Resting {
  dem::Fiber fiber{dem::isotropic_material(2.6e6, 0.17, 1130), 1.66e-3, 3};
  double gravity = 9.3, weight = 4 * dem::sphere_mass(fiber) * gravity;

  dem::Assembly assembly() const {
    const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
    const double R = dem::sphere_radius(fiber),
                 stiffness = 4.0 / 3 * 2.6e6 / (1 - 0.17 * 0.17) * std::sqrt(R),
                 overlap = std::pow(weight / 4 / stiffness, 2.0 / 3);
    dem::Domain around;
    around.gravity = {0, 0, -gravity};
    around.contacts = {.restitution = 0.4, .friction = 0.6};
    dem::Wall floor{dem::Plane{{0, 0, 1e-3}, {0, 0, 1}}}, ball{dem::Sphere{{0, 0, 1}, 0.3, -1}};
    floor.name = "floor";
    ball.velocity = {0, 0.25, 0};
    around.walls = {ball, floor};
    dem::Grip end;
    end.body.name = "end", end.place = {false, true, false}, end.spheres = {{0, 0, 3}};
    dem::Grip push;
    push.force = {0, 2e-5, 0}, push.spheres = {{0, 0, 3}};
    return {{{chain, {dem::placed(chain, {{0, 0, 1e-3 + R - overlap}, {1, 0, 0}})}}},
            around,
            {.step = 4e-6, .grips = {end, push}}};
  }
};

const dem::Cell& at(const dem::Table& table, std::size_t row, const char* column) {
  return table.at(row, column);
}

}  // namespace

BOOST_AUTO_TEST_CASE(walls_have_a_row_each_with_their_forces) {
  const Resting resting;
  dem::Assembly assembly = resting.assembly();
  assembly.march(250);
  const dem::Table rows = dem::wall_log_rows(assembly);
  BOOST_TEST_REQUIRE(rows.rows().size() == 2u);
  BOOST_TEST(rows.columns() == dem::wall_log_table().columns());
  BOOST_TEST(dem::wall_log_table().rows().empty());
  BOOST_TEST(std::get<std::int64_t>(at(rows, 0, "wall")) == 1);
  BOOST_TEST(std::get<std::int64_t>(at(rows, 1, "wall")) == 2);
  BOOST_TEST(std::get<std::string>(at(rows, 0, "wall_shape")) == "sphere");
  BOOST_TEST(std::get<std::string>(at(rows, 1, "wall_shape")) == "plane");
  BOOST_TEST(std::get<std::string>(at(rows, 1, "wall_name")) == "floor");
  BOOST_TEST(std::get<std::int64_t>(at(rows, 1, "step")) == 250);
  BOOST_TEST(rows.number(1, "simulated_time") == assembly.time());
  BOOST_TEST(rows.number(1, "wall_force_z") == -resting.weight, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(rows.number(1, "wall_force_peak") == resting.weight, boost::test_tools::tolerance(1e-9));
  // about the plane's point, under the first sphere: moment x of none, y of the row of spheres
  const double arm = 1.5 * resting.fiber.diameter;
  BOOST_TEST(rows.number(1, "wall_moment_y") == arm * resting.weight, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(rows.number(1, "wall_moment_peak") == arm * resting.weight, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(std::abs(rows.number(1, "wall_work")) < 1e-20);
  BOOST_TEST(rows.number(0, "wall_force_peak") == 0);
  BOOST_TEST(rows.number(0, "wall_center_y") == 0.25 * assembly.time(), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(rows.number(1, "wall_center_z") == 1e-3);
}

BOOST_AUTO_TEST_CASE(grips_have_a_row_each_with_their_forces) {
  const Resting resting;
  dem::Assembly assembly = resting.assembly();
  assembly.march(250);
  const dem::Table rows = dem::held_log_rows(assembly);
  BOOST_TEST_REQUIRE(rows.rows().size() == 2u);
  BOOST_TEST(rows.columns() == dem::held_log_table().columns());
  BOOST_TEST(std::get<std::string>(at(rows, 0, "held_name")) == "end");
  BOOST_TEST(std::get<std::string>(at(rows, 0, "held_kind")) == "held");
  BOOST_TEST(std::get<std::string>(at(rows, 1, "held_kind")) == "load");
  BOOST_TEST(std::get<std::int64_t>(at(rows, 0, "held_spheres")) == 1);
  // what pushes is carried by what holds
  BOOST_TEST(rows.number(0, "held_force_y") == 2e-5, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(rows.number(1, "held_force_y") == -2e-5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(rows.number(0, "held_force_x") == 0);
  BOOST_TEST(rows.number(0, "held_force_peak") == 2e-5, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(rows.number(0, "held_work") == 0);
  BOOST_TEST(rows.number(0, "held_center_x") == 3 * resting.fiber.diameter,
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
