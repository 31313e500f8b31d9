// Keys of named contacts and of spheres that are held and loaded: what is read, what is refused.
#include <boost/test/unit_test.hpp>
#include <string>

#include "dem/contact/contact_body.hpp"
#include "dem/scene/build_packing.hpp"
#include "dem/scene/scene.hpp"
#include "dem/scene/scene_error.hpp"

BOOST_AUTO_TEST_SUITE(surface_scene_test)

namespace dem = fiberchain::dem;

namespace {

std::string kind(const std::string& more) {
  return "  - {diameter: 2 mm, aspect_ratio: 6, youngs_modulus: 2.6 MPa, poisson_ratio: 0.17, density: "
         "1130, " +
         more + "}\n";
}

const std::string kKinds = kind("count: 7, name: cotton") + kind("count: 4, name: steel") + kind("count: 3");

std::string scene_text(const std::string& more, const std::string& kinds = kKinds) {
  return "scene: packing\nfibers:\n" + kinds +
         "filling: {region: {x: [0, 60 mm], y: [0, 60 mm], z: [0, 60 mm]}, batches: {number: 2, interval: 1 "
         "ms}}\n"
         "walls:\n  box: {x: 60 mm, y: 60 mm, lid: open, name: box, contacts: {friction: 0.3}, "
         "youngs_modulus: "
         "7 MPa}\n"
         "  planes: [{point: [0, 0, 61 mm], normal: [0, 0, -1], name: lid, contacts: {restitution: 0.4}}]\n"
         "duration: 3 ms\n" +
         more;
}

dem::PackingScene scene_with(const std::string& more, const std::string& kinds = kKinds) {
  return std::get<dem::PackingScene>(dem::parse_scene({"s.yaml", scene_text(more, kinds)}));
}

void refuses(const std::string& more, const std::string& words, const std::string& kinds = kKinds) {
  try {
    scene_with(more, kinds);
    BOOST_ERROR(more << " is taken");
  } catch (const dem::SceneError& error) {
    BOOST_TEST(std::string(error.what()).find(words) != std::string::npos, more << " says: " << error.what());
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(contacts_by_name_are_read) {
  const dem::PackingScene scene = scene_with(
      "contacts: {restitution: 0.7, friction: 0.2, pairs: [{between: [cotton, steel], friction: "
      "0.5}, {between: [box, steel], rolling_friction: 0.1, youngs_modulus: 1 MPa}, {between: "
      "[cotton, cotton], restitution: 0.9}]}\n");
  const dem::Domain& domain = scene.domain;
  BOOST_TEST_REQUIRE(domain.walls.size() == 6u);  // five of the box
  const auto body = [&](int k) { return sphere_body(chain_of(scene.kinds[k]), domain); };
  const auto pair = [&](int a, int b) { return contact_pair(domain, body(a), body(b)); };
  const auto at_wall = [&](int a, int w) {
    return contact_pair(domain, body(a), wall_body(domain, domain.walls[w]));
  };
  BOOST_TEST((pair(0, 1).properties.friction == 0.5 && pair(1, 0).properties.friction == 0.5));
  BOOST_TEST((pair(0, 0).properties.restitution == 0.9 && pair(0, 0).properties.friction == 0.2));
  BOOST_TEST((pair(1, 1).properties.restitution == 0.7 && pair(2, 0).properties.restitution == 0.7));
  for (const int wall : {0, 4}) {
    BOOST_TEST((at_wall(0, wall).properties.friction == 0.3 && at_wall(1, wall).properties.friction == 0.3));
    BOOST_TEST(at_wall(1, wall).properties.rolling_friction == 0.1);
    BOOST_TEST(
        (at_wall(1, wall).first.youngs_modulus == 1e6 && at_wall(0, wall).first.youngs_modulus == 2.6e6));
    BOOST_TEST(at_wall(1, wall).second.youngs_modulus == 7e6);
  }
  BOOST_TEST((at_wall(1, 5).properties.restitution == 0.4 && at_wall(1, 5).properties.friction == 0.2));
  BOOST_TEST(at_wall(2, 0).properties.rolling_friction == 0);
  BOOST_TEST(scene_with("").kinds[0].surface == 0);  // nothing to tell kinds apart by
}

BOOST_AUTO_TEST_CASE(contacts_by_name_that_make_no_sense_are_refused) {
  const auto pairs = [](const std::string& entries) { return "contacts: {pairs: [" + entries + "]}\n"; };
  refuses(
      pairs("{between: [cotton, stele], friction: 1}"),
      "contacts.pairs[0].between: 'stele' is the name of no fibers and of no wall; did you mean 'steel'?");
  refuses(pairs("{between: [box, lid], friction: 1}"), "both walls");
  refuses(pairs("{between: [cotton, box], friction: 1}, {between: [box, cotton], friction: 1}"),
          "given twice");
  refuses(pairs("{between: [cotton, box]}"), "needs restitution");
  refuses(pairs("{between: [cotton], friction: 1}"), "must be a list of 2 words");
  refuses(pairs("{between: cotton, friction: 1}"), "must be a list of 2 words");
  refuses(pairs("{friction: 1}"), "between");
  refuses(pairs("{between: [cotton, box], friction: -1}"), "contacts.pairs[0].friction");
  refuses(pairs("{between: [cotton, box], restitution: 2}"), "contacts.pairs[0].restitution");
  refuses(pairs("{between: [cotton, box], stickiness: 2}"), "stickiness");
  refuses("", "that of other fibers", kind("count: 2, name: a") + kind("count: 2, name: a"));
  refuses("", "which fibers have", kind("count: 2, name: box"));
  refuses("contacts: {pairs: [{between: [a, b], friction: 1}]}\n", "no wall; ", kind("count: 2"));
}

BOOST_AUTO_TEST_CASE(held_and_loaded_spheres_are_read) {
  const dem::PackingScene scene = scene_with(
      "held:\n  - {fibers: steel, fiber: 1, spheres: last, turn: none, velocity: [0, 0, 1 mm/s], until: 1 "
      "ms, "
      "name: puller}\n  - {fibers: cotton, spheres: ends, place: xz, turn: y}\n"
      "loads:\n  - {fibers: cotton, fiber: 0, spheres: 2..4, force: [0, 0, -1 mN], ramp: 1 ms, from: 1 ms}\n"
      "  - {fibers: steel, spheres: 3, moment: [0, 1e-6, 0]}\n");
  const auto grips = dem::grips_of(scene);
  BOOST_TEST_REQUIRE(grips.size() == 4u);
  BOOST_TEST((grips[0].spheres == std::vector<dem::SphereAddress>{{1, 1, 6}}));
  BOOST_TEST(
      (grips[0].place == std::array{true, true, true} && grips[0].turn == std::array{false, false, false}));
  BOOST_TEST((grips[0].body.velocity[2] == 1e-3 && grips[0].body.active_until == 1e-3));
  BOOST_TEST(grips[0].body.name == "puller");
  BOOST_TEST(grips[1].spheres.size() == 2u * 3);  // of the first batch
  BOOST_TEST(
      (grips[1].place == std::array{true, false, true} && grips[1].turn == std::array{false, true, false}));
  BOOST_TEST((grips[2].spheres == std::vector<dem::SphereAddress>{{0, 0, 2}, {0, 0, 3}, {0, 0, 4}}));
  BOOST_TEST((!grips[2].holds() && grips[2].force[2] == -1e-3));
  BOOST_TEST((grips[2].load_at(0.9e-3) == 0 && grips[2].load_at(1.5e-3) == 0.5 && grips[2].load_at(1) == 1));
  BOOST_TEST((grips[3].moment[1] == 1e-6 && grips[3].spheres.size() == 2u));
}

BOOST_AUTO_TEST_CASE(held_and_loaded_spheres_that_make_no_sense_are_refused) {
  const auto held = [](const std::string& keys) { return "held: [{" + keys + "}]\n"; };
  const auto loads = [](const std::string& keys) { return "loads: [{" + keys + "}]\n"; };
  refuses(held("fibers: steel, fiber: 2, spheres: first"), "held[0].fiber: 2 is not allowed: 2 fibers");
  refuses(held("fibers: steel, fiber: -1, spheres: first"), "held[0].fiber");
  refuses(held("spheres: first"), "key 'fibers' is missing");
  refuses(held("fibers: wool, spheres: first"),
          "held[0].fibers: 'wool' is the name of no fibers; allowed: cotton");
  for (const char* spheres : {"7", "0..7", "4..2", "middle", "-1", "1..", "..2"})
    refuses(held("fibers: steel, spheres: " + std::string(spheres)), "held[0].spheres");
  refuses(held("fibers: steel"), "key 'spheres' is missing");
  refuses(held("fibers: steel, spheres: all, place: none, turn: none"), "held[0].place");
  refuses(held("fibers: steel, spheres: all, place: zx"), "held[0].place: 'zx' is not allowed; allowed: xyz");
  refuses(held("fibers: steel, spheres: all, from: 2 ms, until: 1 ms"), "held[0].until");
  refuses(held("fibers: steel, spheres: all, drive: {force: 1}"), "drive");
  refuses(loads("fibers: steel, spheres: all"), "needs force or moment");
  refuses(loads("fibers: steel, fiber: 9, spheres: all, force: [0, 0, 1]"), "loads[0].fiber");
  refuses(loads("fibers: steel, spheres: all, force: [0, 1]"), "loads[0].force");
  refuses(loads("fibers: steel, spheres: all, force: [0, 0, 1], ramp: -1 s"), "loads[0].ramp");
  refuses(held("fibers: steel, spheres: all") + "fluid: {viscosity: 1 mPa s}\n", "fluid");
  refuses(held("spheres: all"), "motion.rolling: explicit_sign",
          kind("count: 4, bond: {rolling_friction: 0.1}"));
}

BOOST_AUTO_TEST_CASE(smooth_fibers_are_read_and_refused_where_they_are_not_built) {
  const dem::PackingScene scene = scene_with("", kind("count: 3, surface: smooth") + kind("count: 2"));
  BOOST_TEST(chain_of(scene.kinds[0]).smooth);
  BOOST_TEST(!chain_of(scene.kinds[1]).smooth);
  BOOST_TEST(!chain_of(scene_with("", kind("count: 3, surface: spheres")).kinds[0]).smooth);
  refuses("", "spheres, smooth", kind("count: 3, surface: rough"));
  refuses("contacts: {law: jkr, work_of_adhesion: 0.01}\n", "surface: smooth",
          kind("count: 3, surface: smooth"));
  refuses("", "spacing: 1 or more",
          kind("count: 3, surface: smooth, spacing: 0.5, bond: {strength: {tension: 1 MPa}}"));
}

BOOST_AUTO_TEST_SUITE_END()
