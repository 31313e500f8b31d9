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

/// Smooth fibers touch by what lies between their spheres. Others only alone, of bonds no shorter than thick:
/// planes and the fiber's own other end touch it at its spheres.
void check_spacing(const StrictMapping& top, const PackingScene& scene) {
  for (std::size_t k = 0; k < scene.kinds.size(); ++k) {
    const double spacing = scene.kinds[k].fiber.spacing;
    if (spacing == 1) continue;
    const auto refuse = [&](const std::string& why) {
      top.fail_within(fmt::format("fibers[{}].spacing", k),
                      fmt::format("{:g} is not allowed {}", spacing, why));
    };
    if (scene.domain.fluid) refuse("in a fluid: its drag is that of spheres that touch; allowed: 1");
    if (scene.kinds[k].smooth) continue;
    if (fibers_in(scene) > 1 || scene.batches.number > 1)
      refuse(
          "where fibers may touch: contacts are those of spheres, which leave gaps; allowed: 1, one fiber, "
          "or "
          "surface: smooth");
    if (spacing < 1)
      refuse(
          "here: spheres that overlap others along the fiber would touch them; allowed: 1 or more, or "
          "surface: "
          "smooth");
  }
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
