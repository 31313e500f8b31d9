#include <fmt/format.h>
#include <boost/test/unit_test.hpp>
#include <fstream>
#include <numbers>

#include "dem/model/errors.hpp"
#include "dem/scene/build_packing.hpp"
#include "dem/scene/implausible_values.hpp"
#include "dem/scene/scene.hpp"
#include "tests/dem/scene/packing_texts.hpp"
#include "tests/dem/trajectory/files.hpp"

BOOST_AUTO_TEST_SUITE(packing_scene_test)

using namespace packing_texts;

BOOST_AUTO_TEST_CASE(everything_is_read) {
  const dem::PackingScene scene = parse(kScene);
  BOOST_REQUIRE_EQUAL(scene.kinds.size(), 2u);
  const dem::PackingFiberKind &straight = scene.kinds[0], &curved = scene.kinds[1];
  BOOST_TEST(straight.count == 11);
  BOOST_TEST(straight.fiber.rest_angle == 0);
  BOOST_TEST(straight.fiber.material.density == 1200, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(straight.fiber.bond_damping == 0);
  BOOST_TEST((curved.fiber.bond_model == dem::BondModel::corrected));
  BOOST_TEST(curved.fiber.bond_damping == 0.7);
  BOOST_TEST(curved.fiber.material.shear_modulus == 4e6);
  BOOST_TEST(2 * 0.03 * std::sin(curved.fiber.rest_angle / 2) == 1.5e-3, boost::test_tools::tolerance(1e-12));
  const dem::InsertionRules& rules = scene.filling;
  BOOST_TEST((rules.region.low[0] == 0.01 && rules.region.high[0] == 0.06));
  BOOST_TEST((rules.region.low[1] == 0 && rules.region.high[1] == 0.05));  // the period
  BOOST_TEST((rules.region.low[2] == 0.02 && rules.region.high[2] == 0.15));
  BOOST_TEST((rules.orientation.alignment == dem::Alignment::near_axis));
  BOOST_TEST(rules.orientation.direction[2] == 0.8, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(rules.orientation.angle == 0.3);
  BOOST_TEST((rules.velocity[1] == 0.1 && rules.velocity[2] == -0.2));
  BOOST_TEST(rules.gap == 2e-4, boost::test_tools::tolerance(1e-14));
  BOOST_TEST((rules.seed == 77 && rules.attempts == 5000));
  BOOST_TEST((scene.batches.number == 3 && scene.batches.interval == 0.04));
  const dem::Domain& around = scene.domain;
  BOOST_TEST((around.wall_youngs_modulus == 1e9 && around.wall_poisson_ratio == 0.4));
  BOOST_REQUIRE_EQUAL(around.walls.size(), 6u);  // x, z, at both ends; plane; cylinder
  const auto& lid = *around.walls[3].shape.get_if<dem::Plane>();
  BOOST_TEST((lid.point[2] == 0.16 && lid.normal[2] == -1));
  const auto& press = *around.walls[4].shape.get_if<dem::Plane>();
  BOOST_TEST((press.point[2] == 0.17 && press.normal[2] == -1));
  BOOST_TEST((around.walls[4].velocity[2] == -5e-3 && around.walls[4].active_from == 0.1 &&
              around.walls[4].active_until == 0.2));
  BOOST_TEST(around.walls[5].shape.get_if<dem::Cylinder>()->radius == 0.09);
  BOOST_TEST((around.period[0] == 0 && around.period[1] == 0.05 && around.period[2] == 0));
  BOOST_TEST(around.gravity[2] == -9.81);
  BOOST_REQUIRE(around.fluid.has_value());
  BOOST_TEST((around.fluid->viscosity == 0.03 && around.fluid->flow.gradient[0][1] == 2));
  BOOST_TEST((around.contacts.restitution == 0.6 && around.contacts.friction == 0.25));
  BOOST_TEST(around.contacts.rolling_friction == 0.01);
  BOOST_TEST((around.contacts.youngs_modulus == 12e6 && around.contacts.poisson_ratio == 0.43));
  BOOST_TEST((scene.form == dem::BondForm::total && scene.orientations && scene.account_energy));
  BOOST_TEST(scene.step.value() == 2e-6);
  BOOST_TEST((scene.duration == 0.3 && scene.steps == 0));
  BOOST_TEST((scene.output.samples == 17 && scene.output.frames == 6 && scene.output.checkpoints == 4));
  BOOST_TEST(scene.output.vtk);
  BOOST_TEST(
      (scene.scene_box.low[1] == 0 && scene.scene_box.high[1] == 0.05 && scene.scene_box.high[2] == 0.16));
}

BOOST_AUTO_TEST_CASE(what_is_left_out_is_as_documented) {
  const dem::PackingScene scene = parse(
      "scene: packing\n"
      "fibers: [{diameter: 2 mm, aspect_ratio: 7, youngs_modulus: 1 MPa, poisson_ratio: 0, density: 1000, "
      "count: 3}]\n"
      "filling: {region: {x: [-1 cm, 3 cm], y: [0, 2 cm], z: [1 cm, 9 cm]}}\n"
      "fluid: {viscosity: 2}\n"
      "steps: 12\n");
  BOOST_TEST((scene.form == dem::BondForm::incremental && scene.rolling == dem::Rolling::set_valued));
  BOOST_TEST((!scene.orientations && !scene.account_energy && !scene.step && scene.domain.walls.empty()));
  BOOST_TEST((scene.filling.seed == 1 && scene.filling.gap == 0 && scene.batches.number == 1));
  BOOST_TEST((scene.filling.orientation.alignment == dem::Alignment::isotropic));
  BOOST_TEST((scene.domain.contacts.restitution == 1 && scene.domain.contacts.friction == 0));
  BOOST_TEST((!scene.domain.contacts.youngs_modulus && !scene.domain.contacts.poisson_ratio));
  BOOST_TEST(
      (scene.scene_box.low[0] == -0.01 && scene.scene_box.low[2] == 0.01 && scene.scene_box.high[2] == 0.09));
  BOOST_TEST(dem::largest_rate(scene.domain.fluid->flow.gradient) == 0);  // at rest
}

BOOST_AUTO_TEST_CASE(an_open_box_reaches_from_its_floor_to_the_top_of_the_filling) {
  const dem::PackingScene scene = parse(walls("box: {x: 7 cm, lid: open}"));
  BOOST_TEST(scene.domain.walls.size() == 3u);
  BOOST_TEST((scene.scene_box.low[2] == 0 && scene.scene_box.high[2] == 0.15));
}

BOOST_AUTO_TEST_CASE(batches_make_up_the_scene) {
  const dem::PackingScene scene = parse(kScene);
  const dem::PackingStart start = dem::packing_start(scene, 2);
  BOOST_REQUIRE_EQUAL(start.groups.size(), 2u);
  BOOST_TEST(dem::groups_at_start(scene) == 2);
  BOOST_TEST((start.groups[0].fibers.size() == 3u && start.groups[1].fibers.size() == 1u));  // 11/3, 5/3
  BOOST_TEST((start.options.account_energy && start.options.orientations));
  BOOST_TEST(start.options.threads == 1);  // more than one would wait for each other longer than they work
  BOOST_TEST(*start.options.step == 2e-6);
  BOOST_TEST(start.steps == 150000);
  BOOST_TEST(dem::batch_step(scene, 2, 3e-6) == 26667);
  const dem::PlacedSpheres present = dem::spheres_of(start.groups);
  const auto second = dem::packing_batch(scene, 1, 0.04, present),
             third = dem::packing_batch(scene, 2, 0.08, present);
  BOOST_TEST((second[0].fibers.size() == 4u && second[1].fibers.size() == 2u));
  BOOST_TEST((third[0].fibers.size() == 4u && third[1].fibers.size() == 2u));
  BOOST_TEST(second[0].fibers[0].poses[0].position[0] != third[0].fibers[0].poses[0].position[0]);
  BOOST_TEST(dem::fibers_in(scene) == 16);
  BOOST_TEST(dem::spheres_in(scene) == 11 * 8 + 5 * 13);
}

BOOST_AUTO_TEST_CASE(batches_that_would_never_come_are_refused) {
  for (const auto& [interval, steps] : {std::pair("40 ms", "20000"), {"1 us", "100000"}}) {
    const std::string text = less("duration: 0.3 s", std::string("steps: ") + steps,
                                  less("interval: 40 ms", std::string("interval: ") + interval));
    BOOST_CHECK_EXCEPTION(parse(text), dem::SceneError, [](const dem::SceneError& error) {
      return std::string(error.what())
          .starts_with("test.yaml:5: filling.batches.interval: batches.interval = ");
    });
  }
}

BOOST_AUTO_TEST_CASE(what_only_the_whole_scene_shows_has_its_line) {
  const std::pair<std::string, const char*> faults[] = {
      {less("duration: 0.3 s", "duration: 1e12 s"), "test.yaml:12: duration: "},
      {less("step: 2 us", "step: 1 ms", less("motion: {", "motion: {allow_unstable: true, ")),
       "test.yaml:11: motion.step: "},
      {less("aspect_ratio: 7", "aspect_ratio: 999999", less("count: 11", "count: 9999999")),
       "test.yaml:2: fibers: are 99"},
  };
  for (const auto& [text, says] : faults) {
    BOOST_CHECK_EXCEPTION(parse(text), dem::SceneError, [&](const dem::SceneError& error) {
      BOOST_TEST_MESSAGE(error.what());
      return std::string(error.what()).starts_with(says);
    });
  }
  const fiberchain::test::Scratch scratch;
  std::ofstream(scratch.path / "two.csv") << "x,y,z,ux,uy,uz\n# a note\n0.03,0.01,0.05,0,0.6,0.8\n"
                                             "0.02,0.04,-0.001,0,0,1\n";
  const std::string name = (scratch.path / "s.yaml").string();
  BOOST_CHECK_EXCEPTION(
      parse(less("count: 11", "starts: two.csv"), name), dem::SceneError, [](const dem::SceneError& error) {
        const std::string what = error.what();
        return what.find("s.yaml:2: fibers: ") != std::string::npos &&
               what.find("two.csv:4: sphere 0 of fiber 1 is not allowed there: its center is 0.001 m") !=
                   std::string::npos;
      });
}

BOOST_AUTO_TEST_CASE(values_that_nothing_has_are_named_with_their_reading) {
  const auto warnings = [](const std::string& text) { return dem::implausible_values({"s.yaml", text}); };
  BOOST_TEST(warnings(kScene).empty());
  const std::pair<const char*, const char*> slips[][2] = {
      {{"2.6 MPa", "2 mPa"},
       {"s.yaml:3: fibers.youngs_modulus: 2 mPa is 0.002 Pa; millipascal, MPa meant?", ""}},
      {{"diameter: 2 mm", "diameter: 2"}, {"s.yaml:3: fibers.diameter: 2 is 2 m; 2 mm meant?", ""}},
      {{"density: 900", "density: 0.9"},
       {"s.yaml:4: fibers.density: 0.9 is 0.9 kg/m^3; 0.9 g/cm^3 meant?", ""}},
      {{"1 GPa", "1e8 GPa"}, {"s.yaml:6: walls.youngs_modulus: 1e8 GPa is 1e+17 Pa (", ""}},
  };
  for (const auto& slip : slips) {
    const auto found = warnings(less(slip[0].first, slip[0].second));
    BOOST_REQUIRE_EQUAL(found.size(), 1u);
    BOOST_TEST(found[0].starts_with(slip[1].first), found[0]);
  }
}

BOOST_AUTO_TEST_CASE(arcs_are_stress_free_and_of_their_radius) {
  const dem::PackingFiberKind kind = parse(kScene).kinds[1];
  const dem::Chain<3> chain = dem::chain_of(kind);
  BOOST_TEST(dem::elastic_energy(chain, chain.poses) < 1e-25);
  const auto a = chain.poses[0].position, b = chain.poses[12].position;
  BOOST_TEST(norm(b - a) == 2 * 0.03 * std::sin(6 * kind.fiber.rest_angle),
             boost::test_tools::tolerance(1e-12));
  dem::Fiber straight = kind.fiber;
  straight.rest_angle = 0;
  BOOST_TEST(dem::elastic_energy(dem::straight_chain<3>(straight), chain.poses) > 1e-9);
  BOOST_CHECK_THROW(dem::straight_chain<3>(kind.fiber), dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(the_step_is_chosen_for_all_kinds) {
  dem::PackingScene scene = parse(less("step: 2 us, "));
  const dem::PackingStart start = dem::packing_start(scene, 1);
  BOOST_TEST(*start.options.step == start.choice.step);
  BOOST_TEST(static_cast<double>(start.steps) * start.choice.step >= 0.3 * (1 - 1e-9));
  BOOST_TEST(static_cast<double>(start.steps - 1) * start.choice.step < 0.3);
  scene.kinds[0].fiber.material.youngs_modulus *= 1e6;
  scene.kinds[0].fiber.material.shear_modulus *= 1e6;
  const dem::PackingStart stiffer = dem::packing_start(scene, 1);
  BOOST_TEST(stiffer.choice.step < 0.5 * start.choice.step);
  scene.duration = 1e12;
  BOOST_CHECK_THROW(dem::packing_start(scene, 1), dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(starts_come_from_a_file_beside_the_scene) {
  const fiberchain::test::Scratch scratch;
  std::ofstream(scratch.path / "two.csv")
      << "x,y,z,ux,uy,uz\n0.03,0.01,0.05,0,0.6,0.8\n0.03,0.04,0.06,0,0,-1\n";
  const std::string text = less("count: 11", "starts: two.csv"), name = (scratch.path / "s.yaml").string();
  const dem::PackingScene scene = parse(text, name);
  BOOST_REQUIRE_EQUAL(scene.kinds[0].starts.size(), 2u);
  BOOST_TEST(dem::fibers_in(scene) == 7);
  const dem::PackingStart start = dem::packing_start(scene, 1);
  BOOST_REQUIRE_EQUAL(start.groups.size(), 2u);
  const auto& last = start.groups[0].fibers[0].poses[7].position;
  BOOST_TEST(last[2] == 0.05 + 0.8 * 7 * 2e-3, boost::test_tools::tolerance(1e-12));
  const std::string print = dem::scene_fingerprint({name, text}, scene);
  std::ofstream(scratch.path / "two.csv", std::ios::app) << "# moved nothing\n";
  BOOST_TEST(dem::scene_fingerprint({name, text}, parse(text, name)) != print);
  std::ofstream(scratch.path / "two.csv", std::ios::app) << "0.03,0.01,0.05,0,0.6,oops\n";
  BOOST_CHECK_EXCEPTION(parse(text, name), dem::SceneError, [](const dem::SceneError& error) {
    const std::string message = error.what();
    return message.find("s.yaml:3: fibers[0].starts: ") != std::string::npos &&
           message.find("two.csv:5: column 'uz'") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(the_room_of_fibers_from_a_file_stands_on_its_floor) {
  const fiberchain::test::Scratch scratch;
  const auto room = [&](const std::string& walls, const char* starts) {
    std::ofstream(scratch.path / "starts.csv") << "x,y,z,ux,uy,uz\n" << starts;
    return parse(fmt::format(
                     "scene: packing\nfibers: [{{diameter: 2 mm, aspect_ratio: 15, youngs_modulus: 2.6 MPa, "
                     "poisson_ratio: 0.3, density: 1000, starts: starts.csv}}]\nwalls: {{{}}}\nsteps: 10\n",
                     walls),
                 (scratch.path / "s.yaml").string())
        .scene_box;
  };
  const std::string box = "box: {x: 50 mm, y: 50 mm, lid: open}";
  BOOST_TEST(room(box, "0.025,0.025,0.001,0,0,1\n").low[2] == 0);  // upright on the floor
  BOOST_CHECK_CLOSE(room(box, "0.025,0.025,0.001,0,0,1\n").high[2], 0.032, 1e-9);
  BOOST_TEST(room(box, "0.01,0.025,0.02,1,0,0\n").low[2] == 0);  // lying above it
  BOOST_TEST(room(box, "0.01,0.025,0.2,0,0,-1\n").low[2] == 0);  // upside down
  const std::string gate =
      "planes: [{point: [0, 0, -1], normal: [0, 0, 1]}, {point: [0, 0, 0.1], normal: [0, 0, 1], until: 1 s}]";
  BOOST_TEST(room(gate, "0,0,0.2,1,0,0\n").low[2] == -1);
  const std::string plates =
      "planes: [{point: [0, 0, -1], normal: [0, 0, 1]}, {point: [0, 0, 0], normal: [0, 0, 1]}]";
  BOOST_TEST(room(plates, "0,0,0.2,1,0,0\n").low[2] == 0);
  const auto none = room("planes: [{point: [0, 0, 0], normal: [1, 0, 0]}]", "0.01,0,0.2,0,0,1\n");
  BOOST_CHECK_CLOSE(none.low[2], 0.199, 1e-9);  // without a floor from the lowest sphere on
  BOOST_TEST(none.low[0] == 0);
}

BOOST_AUTO_TEST_CASE(scenes_of_the_data_directory_are_right) {
  const std::filesystem::path scenes = std::filesystem::path(FIBERCHAIN_SOURCE_DIR) / "data/scenes";
  const dem::PackingScene layers =
      std::get<dem::PackingScene>(dem::parse_scene(dem::read_scene_text(scenes / "crossed-layers.yaml")));
  const dem::PackingStart start = dem::packing_start(layers, 2);
  BOOST_TEST(start.options.threads == 2);
  BOOST_TEST(start.groups[0].fibers.size() == 2000u);
  BOOST_TEST(start.steps == 20000);
  BOOST_TEST(*start.options.step == 4e-6);
  for (const char* name : {"packing.yaml", "packing-small.yaml", "compression.yaml"}) {
    const dem::PackingScene scene =
        std::get<dem::PackingScene>(dem::parse_scene(dem::read_scene_text(scenes / name)));
    BOOST_CHECK_NO_THROW(dem::packing_start(scene, 1));
  }
}

BOOST_AUTO_TEST_CASE(walls_that_come_after_each_other_are_two) {
  const std::string planes =
      "planes: [{point: [0, 0, 1 cm], normal: [0, 0, 1], until: 1 s}, "
      "{point: [0, 0, 1 cm], normal: [0, 0, 1], from: 1 s}, {point: [0, 0, 1.0001 cm], normal: [0, 0, 1]}, "
      "{point: [0, 0, 3 cm], normal: [0, 0, -1], until: 9 s}, {point: [0, 0, 3 cm], normal: [0, 0, 1], from: "
      "9 s}, "
      "{point: [0, 0, 1 cm], normal: [0, 0, 1], until: 1 s, velocity: [0, 0, 1]}]";
  BOOST_TEST(parse(walls("box: {x: 7 cm, z: 16 cm}, " + planes)).domain.walls.size() == 10u);
}

BOOST_AUTO_TEST_CASE(a_given_step_is_held_to_what_contacts_bear) {
  const std::string undamped = less(", damping: 0.7");  // bonds bear a longer step than contacts
  const double stable = dem::plan_of(parse(less("step: 2 us, ", "", undamped))).choice.contacts;
  const auto at = [&](double step, const std::string& more = "") {
    return dem::plan_of(parse(less("step: 2 us", fmt::format("step: {}{}", step, more), undamped))).step;
  };
  BOOST_TEST(at(0.999 * stable) == 0.999 * stable);
  BOOST_CHECK_EXCEPTION(at(1.001 * stable), dem::SceneError, [](const dem::SceneError& error) {
    return std::string(error.what()).starts_with("test.yaml:11: motion.step: ");
  });
  BOOST_TEST(at(1.001 * stable, ", allow_unstable: true") == 1.001 * stable);
}

BOOST_AUTO_TEST_SUITE_END()
