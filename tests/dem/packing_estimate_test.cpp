#include <malloc.h>

#include <boost/test/unit_test.hpp>
#include <variant>

#include "dem/run/packing_estimate.hpp"
#include "dem/scene/scene.hpp"

BOOST_AUTO_TEST_SUITE(packing_estimate_test)

namespace dem = fiberchain::dem;

namespace {

dem::PackingScene scene_of(const std::string& name) {
  const std::string path = std::string(FIBERCHAIN_SOURCE_DIR) + "/data/scenes/" + name;
  return std::get<dem::PackingScene>(dem::parse_scene(dem::read_scene_text(path)));
}

/// Heap in use, large blocks included [bytes].
double heap() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_stays_is_what_an_assembly_takes) {
  const dem::PackingScene scene = scene_of("crossed-layers.yaml");
  const dem::PackingMemory expected = dem::memory_of(scene);
  const double before = heap();
  dem::Assembly assembly = dem::make_assembly(dem::packing_start(scene, 1));
  assembly.march(2);
  const double measured = heap() - before;
  const double stays = expected.spheres + expected.bonds + expected.neighbor_list + expected.contacts;
  BOOST_TEST(measured > 0.5 * stays, measured << " B of " << stays << " B");
  BOOST_TEST(measured < 2.0 * stays, measured << " B of " << stays << " B");
}

BOOST_AUTO_TEST_CASE(memory_and_files_grow_with_the_spheres) {
  dem::PackingScene scene = scene_of("packing-small.yaml");
  const double once = dem::peak(dem::memory_of(scene));
  const dem::PackingFileSizes files = dem::file_sizes_of(scene, 10000);
  scene.kinds[0].count *= 3;
  BOOST_TEST(dem::peak(dem::memory_of(scene)) == 3 * once, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(dem::file_sizes_of(scene, 10000).checkpoints == 3 * files.checkpoints,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(dem::file_sizes_of(scene, 10000).log == files.log);
}

BOOST_AUTO_TEST_CASE(fibers_of_later_batches_take_fewer_steps) {
  dem::PackingScene scene = scene_of("packing-small.yaml");
  scene.batches = {.number = 2, .interval = scene.duration / 2};
  const dem::PackingPlan plan = dem::plan_of(scene);
  const double spheres = static_cast<double>(dem::spheres_in(scene)), steps = static_cast<double>(plan.steps);
  BOOST_TEST(dem::sphere_steps_of(scene, plan) == 0.75 * spheres * steps, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(the_cost_of_a_step_is_measured_on_the_scenes_own_fibers) {
  const dem::PackingScene scene = scene_of("packing-small.yaml");
  const dem::StepCost cost = dem::measure_step_cost(scene, dem::plan_of(scene).step, 1, 0.005);
  BOOST_TEST(cost.spheres == 4200);
  BOOST_TEST(cost.threads == 1);
  BOOST_TEST(cost.per_sphere > 0);
}

BOOST_AUTO_TEST_SUITE_END()
