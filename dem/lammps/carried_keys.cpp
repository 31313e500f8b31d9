#include "dem/lammps/carried_keys.hpp"

#include <fmt/format.h>

#include "dem/mesh/mesh_shape.hpp"
#include "dem/model/invalid_key.hpp"
#include "dem/scene/build_packing.hpp"

namespace fiberchain::dem::mpi {
namespace {

[[noreturn]] void refuse(const std::string& key, const std::string& what) {
  throw InvalidKey(
      key,
      fmt::format("{} is not allowed here: fiberchain-mpi does not have {}; fiberchain does", key, what));
}

}  // namespace

void refuse_what_is_not_carried(const PackingScene& scene) {
  for (std::size_t k = 0; k < scene.kinds.size(); ++k) {
    const Fiber& fiber = scene.kinds[k].fiber;
    const std::string kind = fmt::format("fibers[{}]", k);
    if (fiber.rolling_friction > 0) refuse(kind + ".bond.rolling_friction", "rolling friction of the bonds");
    if (!fiber.branches.empty()) refuse(kind + ".material_damping", "Maxwell branches");
    if (scene.kinds[k].smooth) refuse(kind + ".surface", "smooth fibers");
    if (fiber.spacing != 1) refuse(kind + ".spacing", "spheres that do not touch along the fiber");
    if (fiber.strength) refuse(kind + ".bond.strength", "bonds that break");
    if (fiber.yield) refuse(kind + ".bond.yield", "bonds that yield");
  }
  if (const std::int64_t spheres = spheres_in(scene); spheres > most_spheres)
    throw InvalidKey("fibers",
                     fmt::format("{} spheres are not allowed here: one rank holds all of them while "
                                 "files are written, at 4 kB each, {} at most",
                                 spheres, most_spheres));
  if (scene.integrator == Integrator::leapfrog_stiff)
    refuse("motion.integrator", "bonds that are solved for, which want a fiber whole on one rank");
  if (scene.domain.fluid) refuse("fluid", "a fluid");
  if (!scene.held.empty()) refuse(scene.held.front().is_load ? "loads" : "held", "held and loaded spheres");
  for (const Wall& wall : scene.domain.walls) {
    if (mesh_in(wall) != nullptr) refuse("walls.meshes", "walls of triangles");
  }
  if (scene.account_energy) refuse("output.energy", "the account of energies");
  if (scene.output.contacts) refuse("output.contacts", "the forces of contacts in frames");
}

void refuse_chain(const Chain<3>& chain) {
  if (!chain.natural.empty()) refuse("fibers", "fibers with corners at rest");
}

}  // namespace fiberchain::dem::mpi
