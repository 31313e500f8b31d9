#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "dem/model/errors.hpp"
#include "tests/dem/scene/packing_texts.hpp"

BOOST_AUTO_TEST_SUITE(packing_scene_faults_test)

using namespace packing_texts;

namespace {

struct Fault {
  std::string scene;
  const char* says;
};
std::ostream& operator<<(std::ostream& out, const Fault& fault) { return out << fault.says; }

const Fault kFaults[] = {
    {kScene + "colour: red\n",
     "test.yaml:14: unknown key 'colour'; allowed: scene, start_from, fibers, periodic"},
    {with("fibers:", "fibres:"), "test.yaml:2: unknown key 'fibres'; did you mean 'fibers'?"},
    {less("count: 11"), "test.yaml:3: fibers[0]: must have exactly one of count, starts"},
    {less("count: 11", "count: 0"),
     "test.yaml:3: fibers[0].count: '0' is not allowed; allowed: a whole number at "
     "least 1"},
    {less("count: 11", "count: 1.5"), "test.yaml:3: fibers[0].count: '1.5' is not allowed"},
    {less("count: 11", "starts: none.csv"), "test.yaml:3: fibers[0].starts: none.csv: cannot read"},
    {less("count: 11", "amount: 3"), "test.yaml:3: unknown key 'fibers[0].amount'; "},
    {less("2 mm", "2 kg"), "test.yaml:3: fibers[0].diameter: '2 kg' has a unit of another dimension"},
    {less("diameter: 2 mm, "), "test.yaml:3: fibers[0]: key 'diameter' is missing"},
    {less("radius: 3 cm", "radius: 1 mm"), "test.yaml:4: fibers[1].curvature.radius: '1 mm' is out of range"},
    {less("radius: 3 cm", "angle: 1"),
     "test.yaml:4: fibers[1].curvature: an arc of 1 rad a bond is not allowed: at "
     "most 0.483322"},
    {less("radius: 3 cm", "radius: 3 cm, angle: 0.1"),
     "test.yaml:4: fibers[1].curvature: must have exactly one of"},
    {less("damping: 0.7", "damping: -1"), "test.yaml:4: fibers[1].bond.damping: '-1' is out of range"},
    {less("damping: 0.7", "rolling_friction: 1"),
     "test.yaml:11: motion: rolling friction of the bonds is built for"},
    {less("damping: 0.7", "form: total"), "test.yaml:4: unknown key 'fibers[1].bond.form'"},
    {with("fibers:", "fibers: []\nx:"), "test.yaml:3: unknown key 'x'"},
    {less("box: {x: 7 cm, z: 16 cm}, ", "", filling("seed: 1")),
     "test.yaml:5: filling: key 'region.x' is missing"},
    {less("box: {x: 7 cm, z: 16 cm}, ", "", filling("region: {x: [0, 1]}")),
     "test.yaml:5: filling.region: key 'z' is missing: neither box nor periodic has this side"},
    {filling("region: {z: [3 cm, 2 cm]}"), "test.yaml:5: filling.region.z: must rise"},
    {filling("region: {z: [3 cm]}"),
     "test.yaml:5: filling.region.z: must be a list of 2 finite numbers in m"},
    {filling("region: {z: [3 cm, 2 s]}"),
     "test.yaml:5: filling.region.z: '2 s' has a unit of another dimension"},
    {filling("region: {w: [1, 2]}"), "test.yaml:5: unknown key 'filling.region.w'"},
    {filling("orientation: along"),
     "test.yaml:5: filling.orientation: 'along' is not allowed; allowed: isotropic, "
     "near_axis, near_plane"},
    {filling("orientation: near_plane, angle: 0.1"), "test.yaml:5: filling: key 'direction' is missing"},
    {filling("orientation: near_plane, direction: [1, 0, 0], angle: 2"),
     "test.yaml:5: filling.angle: '2' is out of"},
    {filling("angle: 0.1"), "test.yaml:5: filling.angle: is of use only with orientation"},
    {filling("velocity: 3"), "test.yaml:5: filling.velocity: must be a list of 3 finite numbers in m/s"},
    {filling("velocity: [0, 0, .nan]"),
     "test.yaml:5: filling.velocity: must be a list of 3 finite numbers in m/s"},
    {filling("gap: -1 mm"), "test.yaml:5: filling.gap: '-1 mm' is out of range"},
    {filling("seed: -1"), "test.yaml:5: filling.seed: '-1' is not allowed"},
    {filling("attempts: 0"), "test.yaml:5: filling.attempts: '0' is not allowed"},
    {filling("batches: {number: 2}"), "test.yaml:5: filling.batches: key 'interval' is missing"},
    {filling("seed: 3000000000"),
     "test.yaml:5: filling.seed: '3000000000' is not allowed; allowed: a whole number at least 0 and at most "
     "2147483647"},
    {filling("batches: {number: 12, interval: 1 ms}"),
     "test.yaml:5: filling.batches.number: leaves no fiber for the first batch; allowed: at most 11"},
    {filling("batches: {number: 9, interval: 40 ms}"),
     "test.yaml:12: duration: ends before the last batch of fibers "
     "comes"},
    {walls("box: {x: 7 cm, y: 5 cm, z: 16 cm}"),
     "test.yaml:6: walls.box.y: has no walls: this side is periodic"},
    {walls("box: {x: 7 cm}"), "test.yaml:6: walls.box: key 'z' is missing"},
    {walls("box: {x: 7 cm, z: 1, lid: ajar}"),
     "test.yaml:6: walls.box.lid: 'ajar' is not allowed; allowed: closed, "
     "open"},
    {walls("poisson_ratio: 0.3"), "test.yaml:6: walls.poisson_ratio: is of use only with youngs_modulus"},
    {walls("youngs_modulus: 0"), "test.yaml:6: walls.youngs_modulus: '0' is out of range"},
    {walls("planes: {point: [0, 0, 0], normal: [0, 0, 1]}"),
     "test.yaml:6: walls.planes: must be a list of mappings"},
    {walls("planes: [{point: [0, 0, 0]}]"), "test.yaml:6: walls.planes[0]: key 'normal' is missing"},
    {walls("planes: [{point: [0, 0, 0], normal: [0, 0, 0]}]"),
     "test.yaml:6: walls.planes[0].normal: must not be zero"},
    {walls("planes: [{point: [0, 0, 0], normal: [0, 0, 1], from: 2 s, until: 1 s}]"),
     "test.yaml:6: walls.planes[0].until: must be later than from"},
    {walls("planes: [{point: [0, 0, 0], normal: [0, 0.1, 1]}]"),
     "test.yaml:6: walls.planes[0].normal: must leave the wall the same all along y, which is periodic"},
    {walls("cylinders: [{point: [0, 0, 0], axis: [0, 0, 1], radius: 1 m}]"),
     "test.yaml:6: walls.cylinders[0].axis: must leave the wall the same all along y, which is periodic"},
    {walls("cylinders: [3]"), "test.yaml:6: walls.cylinders[0]: must be a list of mappings"},
    {walls("cylinders: [{point: [0, 0, 0], axis: [0, 0, 1], radius: -1 m}]"),
     "test.yaml:6: walls.cylinders[0].radius: '-1 m' is out of range"},
    {walls("box: {x: 7 cm, z: 16 cm}, cylinders: [{point: [35 mm, 0, 0], axis: [0, 1, 0], radius: 0.9 mm}]"),
     "test.yaml:6: walls.cylinders[0].radius: 0.0009 m is not allowed: it is narrower than the fibers, 0.002 "
     "m in "
     "diameter; allowed: at least 0.001 m"},
    {walls("box: {x: 1.9 mm, z: 16 cm}"),
     "test.yaml:6: walls.box.x: 0.0019 m is not allowed: it is narrower"},
    {walls("box: {x: 7 cm, z: 16 cm}, planes: [{point: [0, 0, 0], normal: [0, 0, 3]}]"),
     "test.yaml:6: walls: has the same plane twice (walls 3 and 5"},
    {walls("box: {x: 7 cm, z: 16 cm}, planes: [{point: [1 mm, 1 m, 16 cm], normal: [0, 0, -1], from: 1 s}]"),
     "test.yaml:6: walls: has the same plane twice (walls 4 and 5"},
    {walls("planes: [{point: [0, 0, 17 cm], normal: [0, 0, -1], velocity: [0, 0, -1]}, "
           "{point: [5, 0, 17 cm], normal: [0, 0, -1], velocity: [0, 0, -1], until: 2 s}]"),
     "test.yaml:6: walls: has the same plane twice (walls 1 and 2"},
    {walls("cylinders: [{point: [35 mm, 0, 0], axis: [0, 1, 0], radius: 90 mm}, "
           "{point: [35 mm, 2, 0], axis: [0, -3, 0], radius: 9 cm}]"),
     "test.yaml:6: walls: has the same cylinder twice (walls 1 and 2"},
    {walls(
         "planes: [{point: [0, 0, 2 cm], normal: [0, 0, 1]}, {point: [0, 0, 2.19 cm], normal: [0, 0, -1]}]"),
     "test.yaml:6: walls: leave 0.0019 m between walls 1 and 2"},
    {with("periodic:", "periodic: {y: 0 m}"), "test.yaml:7: periodic.y: '0 m' is out of range"},
    {with("gravity:", "gravity: [0, 0, 9.81 m]"),
     "test.yaml:8: gravity: '9.81 m' has a unit of another dimension"},
    {with("gravity:", "gravity: 9.81"), "test.yaml:8: gravity: must be a list of 3 finite numbers in m/s^2"},
    {less("rate: 2 1/s", "rate: 0"), "test.yaml:9: fluid.rate: must not be zero"},
    {less("flow: shear, rate", "rate"), "test.yaml:9: fluid.rate: is of use only with flow"},
    {less("rate: 2 1/s", "rate: 2 1/s, hydrodynamics: interactions"),
     "test.yaml:9: fluid.hydrodynamics: 'interactions' is not allowed; allowed: free_draining"},
    {with("contacts:", "contacts: {restitution: 0}"),
     "test.yaml:10: contacts.restitution: '0' is out of range"},
    {with("contacts:", "contacts: {restitution: 1.1}"),
     "test.yaml:10: contacts.restitution: '1.1' is out of range"},
    {with("contacts:", "contacts: {friction: -0.1}"),
     "test.yaml:10: contacts.friction: '-0.1' is out of range"},
    {with("contacts:", "contacts: {youngs_modulus: 0}"),
     "test.yaml:10: contacts.youngs_modulus: '0' is out of range"},
    {with("contacts:", "contacts: {youngs_modulus: 3 mm}"),
     "test.yaml:10: contacts.youngs_modulus: '3 mm' has a unit of another dimension"},
    {with("contacts:", "contacts: {poisson_ratio: 0.6}"),
     "test.yaml:10: contacts.poisson_ratio: '0.6' is out of range"},
    {with("contacts:", "contacts: {stiction: 1}"), "test.yaml:10: unknown key 'contacts.stiction'"},
    {with("motion:", "motion: {step: 0 s}"), "test.yaml:11: motion.step: '0 s' is out of range"},
    {with("motion:", "motion: {orientations: maybe}"),
     "test.yaml:11: motion.orientations: 'maybe' is not allowed; "
     "allowed: false, true"},
    {with("motion:", "motion: {rolling: off}"), "test.yaml:11: motion.rolling: 'off' is not allowed"},
    {with("duration:", "duration: 0.3 s\nsteps: 3"), "must have exactly one of duration, steps"},
    {walls("box: {x: 7 cm, z: 16 cm}, planes: [{point: [0, 1, 0], normal: [0, 0, 3]}]"),
     "walls: has the same plane twice (walls 3 and 5"},
    {walls("box: {x: 7 cm, z: 16 cm}, cylinders: [{point: [35 mm, 0, 0], axis: [0, 1, 0], radius: 9 cm}, "
           "{point: [35 mm, 1, 0], axis: [0, -2, 0], radius: 90 mm}]"),
     "walls: has the same cylinder twice (walls 5 and 6"},
    {with("motion:", "motion: {allow_unstable: true}"), "motion.allow_unstable"},
    {with("duration:", "steps: 0"), "test.yaml:12: steps: '0' is not allowed"},
    {with("output:", "output: {frames: -1}"), "test.yaml:13: output.frames: '-1' is not allowed"},
    {with("output:", "output: {vtk: 3}"), "test.yaml:13: output.vtk: '3' is not allowed"},
    {with("output:", "output: {film: true}"), "test.yaml:13: unknown key 'output.film'"},
};

}  // namespace

BOOST_DATA_TEST_CASE(bad_input_is_refused_with_its_place, kFaults, fault) {
  BOOST_CHECK_EXCEPTION(parse(fault.scene), dem::SceneError, [&](const dem::SceneError& error) {
    const std::string message = error.what();
    BOOST_TEST(message.find(fault.says) != std::string::npos,
               "\"" << message << "\" lacks \"" << fault.says << "\"");
    return message.find('\n') == std::string::npos;
  });
}

BOOST_AUTO_TEST_SUITE_END()
