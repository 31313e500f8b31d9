// Every key that packings have is carried over ranks or refused by name: a new one wants a decision here.
#include "dem/lammps/carried_keys.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "dem/model/invalid_key.hpp"
#include "dem/scene/build_packing.hpp"
#include "dem/scene/key_reference.hpp"
#include "dem/scene/scene.hpp"

BOOST_AUTO_TEST_SUITE(carried_keys_test)

using namespace fiberchain::dem;
using fiberchain::dem::mpi::refuse_what_is_not_carried;

namespace {

/// Keys with all that is below them.
const std::vector<std::string> carried{"scene",
                                       "start_from",
                                       "fibers.diameter",
                                       "fibers.aspect_ratio",
                                       "fibers.material",
                                       "fibers.youngs_modulus",
                                       "fibers.poisson_ratio",
                                       "fibers.shear_modulus",
                                       "fibers.transverse_modulus",
                                       "fibers.density",
                                       "fibers.mass",
                                       "fibers.bond.model",
                                       "fibers.bond.damping",
                                       "fibers.curvature",
                                       "fibers.name",
                                       "fibers.count",
                                       "fibers.starts",
                                       "periodic",
                                       "walls.youngs_modulus",
                                       "walls.poisson_ratio",
                                       "walls.box",
                                       "walls.planes",
                                       "walls.cylinders",
                                       "walls.spheres",
                                       "walls.obstacles",
                                       "walls.cones",
                                       "gravity",
                                       "contacts.law",
                                       "contacts.work_of_adhesion",
                                       "contacts.restitution",
                                       "contacts.friction",
                                       "contacts.rolling_friction",
                                       "contacts.youngs_modulus",
                                       "contacts.poisson_ratio",
                                       "contacts.pairs",
                                       "filling",
                                       "motion.step",
                                       "motion.restitution_error",
                                       "motion.form",
                                       "motion.orientations",
                                       "motion.allow_unstable",
                                       "duration",
                                       "steps",
                                       "output.samples",
                                       "output.frames",
                                       "output.checkpoints",
                                       "output.vtk"};
/// motion.rolling is of use with bond.rolling_friction alone; of motion.integrator leapfrog is carried.
const std::vector<std::string> refused{"fibers.material_damping",
                                       "fibers.surface",
                                       "fibers.spacing",
                                       "fibers.bond.rolling_friction",
                                       "fibers.bond.strength",
                                       "fibers.bond.yield",
                                       "walls.meshes",
                                       "fluid",
                                       "held",
                                       "loads",
                                       "motion.integrator",
                                       "motion.rolling",
                                       "output.contacts",
                                       "output.energy"};
const std::vector<std::string> only_mappings{"fibers",   "fibers.bond", "walls",
                                             "contacts", "motion",      "output"};

std::vector<std::string> packing_keys() {
  std::vector<std::string> keys;
  std::istringstream text(key_reference());
  bool of_packings = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("### ")) of_packings = line.find("packing") != std::string::npos;
    if (!of_packings || !line.starts_with("| `")) continue;
    std::string key = line.substr(3, line.find('`', 3) - 3);
    for (std::size_t at = key.find("[]"); at != std::string::npos; at = key.find("[]")) key.erase(at, 2);
    keys.push_back(key);
  }
  return keys;
}

bool is_below(const std::string& key, const std::string& top) {
  return key == top || key.starts_with(top + ".");
}

/// The key that a scene is refused by; "" where it is carried.
std::string refusal_of(const std::filesystem::path& path) {
  const Scene scene = read_scene(path);
  try {
    refuse_what_is_not_carried(std::get<PackingScene>(scene));
  } catch (const InvalidKey& error) {
    BOOST_TEST(std::string(error.what()).find(error.key) != std::string::npos, error.what());
    return error.key;
  }
  return "";
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_declared_key_is_decided) {
  const std::vector<std::string> keys = packing_keys();
  BOOST_TEST(keys.size() > 300u);
  for (const std::string& key : keys) {
    const auto in = [&](const std::vector<std::string>& list) {
      return std::ranges::count_if(list, [&](const std::string& top) { return is_below(key, top); });
    };
    const auto decided = in(carried) + in(refused) + std::ranges::count(only_mappings, key);
    BOOST_TEST(decided == 1, key << " is in " << decided << " lists");
  }
  for (const auto* list : {&carried, &refused, &only_mappings}) {
    for (const std::string& top : *list)
      BOOST_TEST((std::ranges::find(keys, top) != keys.end()), top << " is no key");
  }
}

BOOST_AUTO_TEST_CASE(scenes_of_the_project) {
  const std::map<std::string, std::string> expected{{"compression", "output.energy"},
                                                    {"crossed-layers", ""},
                                                    {"drum", ""},
                                                    {"hopper", "walls.meshes"},
                                                    {"packing", "output.energy"},
                                                    {"packing-small", "output.energy"},
                                                    {"pull-out", "held"},
                                                    {"shaker", "output.energy"},
                                                    {"spaghetti", "fibers[0].bond.strength"},
                                                    {"steel-wool", "motion.integrator"},
                                                    {"three-point-bending", "motion.integrator"},
                                                    {"three-point-bending-bundle", "output.energy"},
                                                    {"uniaxial-press", "output.energy"}};
  for (const auto& [name, key] : expected)
    BOOST_TEST(refusal_of(std::string(FIBERCHAIN_SOURCE_DIR) + "/data/scenes/" + name + ".yaml") == key,
               name);
}

BOOST_AUTO_TEST_CASE(more_spheres_than_one_rank_holds) {
  auto scene =
      std::get<PackingScene>(read_scene(std::string(FIBERCHAIN_SOURCE_DIR) + "/data/scenes/drum.yaml"));
  const std::int64_t of_one = scene.kinds[0].fiber.aspect_ratio + 1,
                     others = spheres_in(scene) - of_one * scene.kinds[0].count;
  scene.kinds[0].count = (mpi::most_spheres - others) / of_one;
  BOOST_CHECK_NO_THROW(refuse_what_is_not_carried(scene));
  ++scene.kinds[0].count;
  BOOST_CHECK_EXCEPTION(refuse_what_is_not_carried(scene), InvalidKey,
                        [](const InvalidKey& error) { return error.key == "fibers"; });
}

BOOST_AUTO_TEST_SUITE_END()
