#include "dem/scene/check_packing.hpp"

#include <fmt/format.h>

#include <cmath>

#include "dem/model/invalid_key.hpp"
#include "dem/scene/build_packing.hpp"
#include "dem/scene/check_starts.hpp"

namespace fiberchain::dem {

void check_number(const StrictMapping& top, const PackingScene& scene) {
  constexpr std::int64_t most = 2'000'000'000;  // of 32 bits, some for walls
  if (spheres_in(scene) <= most) return;
  top.fail("fibers", fmt::format("are {} spheres; allowed: at most {}, as spheres have numbers of 32 bits",
                                 spheres_in(scene), most));
}

void check_starts(const StrictMapping& top, const PackingScene& scene) {
  try {
    check_starts(scene);
  } catch (const InvalidInput& error) {
    top.fail("fibers", error.what());
  }
}

void check_plan(const StrictMapping& top, const PackingScene& scene) {
  try {
    const PackingPlan plan = plan_of(scene);
    const double bonds = largest_bond_step(plan.choice);
    if (scene.step && *scene.step > bonds) {
      throw InvalidKey("motion.step",
                       fmt::format("{:g} s is not allowed: at most {:g} s, beyond which bonds are "
                                   "unstable",
                                   *scene.step, bonds));
    }
    if (std::isnormal(plan.step)) return;
    throw InvalidKey("fibers",
                     fmt::format("have a time step of {:g} s; allowed: diameter, youngs_modulus, density "
                                 "and damping that give one above 0",
                                 plan.step));
  } catch (const InvalidKey& error) {
    top.fail_within(error.key, error.what());
  } catch (const InvalidInput& error) {
    top.fail("fibers", error.what());
  }
}

}  // namespace fiberchain::dem
