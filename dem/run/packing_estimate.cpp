#include "dem/run/packing_estimate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "dem/bond/branch_steps.hpp"
#include "dem/insertion/placement.hpp"
#include "dem/run/samples.hpp"
#include "dem/simd/storage_layout.hpp"

namespace fiberchain::dem {
namespace {

constexpr double kDouble = sizeof(double), kIndex = sizeof(std::int32_t), kVector = sizeof(Vec<double, 3>);

/// Bytes of a sphere in the storage.
double storage_of(const PackingScene& scene) {
  const bool oriented = scene.orientations || scene.form == BondForm::total;
  return kDouble * (position_radius_size + velocity_spin_size + (oriented ? quaternion_size : 0));
}

/// Bytes of a bond: its strains, and force, moment and power of the last step where energy is accounted.
double bond_of(const PackingScene& scene) {
  constexpr double accounted = 8 * kDouble;
  double bonds = 0, numbers = 0;
  for (const PackingFiberKind& kind : scene.kinds) {
    const Fiber& fiber = kind.fiber;
    const auto own = static_cast<double>(kind.count + std::ssize(kind.starts)) * fiber.aspect_ratio;
    bonds += own;
    numbers += own * static_cast<double>(bond_memory<3>(fiber, scene.form));
  }
  return kDouble * numbers / std::max(bonds, 1.0) + (scene.account_energy ? accounted : 0);
}

/// Bytes of a sphere in a checkpoint: storage, load, reference position, and what its bond and contacts keep.
double checkpointed_of(const PackingScene& scene) {
  constexpr double numbers_of_contact = 16;
  return storage_of(scene) + kDouble * load_size + kVector + bond_of(scene) +
         assumed_contacts * numbers_of_contact * kDouble;
}

/// Rows and columns of parallel fibers whose spheres overlap by 1e-4 of the diameter with those above and
/// beside them.
std::vector<ChainState<3>> stack_of(const Chain<3>& chain, std::int64_t fibers) {
  const double pitch = chain.fiber.diameter * (1 - 1e-4);
  const auto rows = static_cast<std::int64_t>(std::ceil(std::sqrt(static_cast<double>(fibers))));
  std::vector<ChainState<3>> stack;
  for (std::int64_t n = 0; n < fibers; ++n) {
    const Vec<double, 3> first{0, static_cast<double>(n % rows) * pitch,
                               static_cast<double>(n / rows) * pitch};
    stack.push_back(placed(chain, FiberStart{first, {1, 0, 0}}));
  }
  return stack;
}

}  // namespace

PackingMemory memory_of(const PackingScene& scene) {
  const auto spheres = static_cast<double>(spheres_in(scene)),
             bonds = spheres - static_cast<double>(fibers_in(scene));
  // reference position, first and present position in the cells, radius three times, fiber three times, cell,
  // slot, number, class of size, flags
  constexpr double listed = 3 * kVector + 3 * kDouble + 6 * kIndex + 5;
  // of a pair, in the list in use and that in the making: two spheres, number of the contact; in the inner
  // list, four and a flag
  constexpr double pair = 2 * 3 * kIndex + 4 * kIndex + 1;
  const double history = kDouble * (contact_history_size + (scene.account_energy ? contact_account_size : 0));
  // with the cells that filling looks up, eight a sphere, and its own positions and radii
  constexpr double state = sizeof(Pose<double, 3>) + 2 * kVector + 9 * kIndex + kVector + kDouble;
  const double touching = scene.output.contacts ? assumed_contacts * sizeof(FrameContact) : 0;
  const double frame = 2 * kVector + kDouble + kIndex + sizeof(FrameBond) + touching;
  return {.spheres = spheres * storage_of(scene),
          .bonds = bonds * bond_of(scene),
          .neighbor_list = spheres * (listed + assumed_pairs * pair),
          .contacts = spheres * assumed_contacts * history,
          .start = spheres * state,
          .output = spheres * std::max(frame, 2 * checkpointed_of(scene))};
}

double peak(const PackingMemory& memory) {
  return memory.spheres + memory.bonds + memory.neighbor_list + memory.contacts +
         std::max(memory.start, memory.output);
}

PackingFileSizes file_sizes_of(const PackingScene& scene, std::int64_t steps) {
  const auto spheres = static_cast<double>(spheres_in(scene)),
             bonds = spheres - static_cast<double>(fibers_in(scene));
  const auto intervals = [&](int asked) { return static_cast<double>(std::min<std::int64_t>(asked, steps)); };
  const double frames = intervals(scene.output.frames) + 1;
  constexpr double number = 18, single = sizeof(float);  // digits of a double in a CSV file
  const double head = kDouble + 2 * kIndex,
               bond_head = 2 * kDouble;  // radius, fiber, sphere; numbers of the spheres
  const double sphere_frame = kVector + 3 * single,
               bond_frame = 4 * single;  // position, velocity; force, angle
  // pair, kind; point, normal, force
  const double contact_frame = scene.output.contacts ? 2 * kDouble + kIndex + kVector + 6 * single : 0;
  // points and lines in base64: position twice, velocity, force, angle, radius, numbers
  constexpr double vtk_sphere = (2 * kVector + 8 * single + 6 * kIndex) * 4 / 3;
  return {.trajectory =
              spheres * head + bonds * bond_head +
              frames * (spheres * (sphere_frame + assumed_contacts * contact_frame) + bonds * bond_frame),
          .checkpoints = 2 * spheres * checkpointed_of(scene),
          .log = (intervals(scene.output.samples) + 1) * number *
                 static_cast<double>(run_log_table(scene).columns().size()),
          .vtk = scene.output.vtk ? frames * spheres * vtk_sphere : 0};
}

StepCost measure_step_cost(const PackingScene& scene, double step, int threads, double seconds) {
  constexpr std::int64_t most_spheres = 40000;  // beyond the inner caches, as large scenes are
  const Chain<3> chain = chain_of(scene.kinds.front());
  const std::int64_t length = chain.fiber.aspect_ratio + 1;
  const std::int64_t fibers = std::max<std::int64_t>(1, std::min(spheres_in(scene), most_spheres) / length);
  Domain domain = scene.domain;
  domain.walls.clear();
  domain.period = {};
  std::vector<FiberGroup> groups;
  groups.push_back({chain, stack_of(chain, fibers)});
  const int used = useful_threads(scene, threads);
  Assembly assembly(std::move(groups), std::move(domain),
                    {.step = step,
                     .integrator = plan_of(scene).integrator,
                     .form = scene.form,
                     .rolling = scene.rolling,
                     .threads = used,
                     .account_energy = scene.account_energy,
                     .orientations = scene.orientations});
  using Clock = std::chrono::steady_clock;
  constexpr std::int64_t stride = 4;
  constexpr int fewest = 5;
  assembly.march(stride);  // memory and caches are cold, and the first step of all is another one
  double least = std::numeric_limits<double>::infinity(), spent = 0;
  for (int n = 0; n < fewest || spent < seconds; ++n) {
    const auto from = Clock::now();
    assembly.march(stride);
    const double lap = std::chrono::duration<double>(Clock::now() - from).count();
    least = std::min(least, lap);
    spent += lap;
  }
  return {least / static_cast<double>(stride * assembly.spheres()), assembly.spheres(), used};
}

double sphere_steps_of(const PackingScene& scene, const PackingPlan& plan) {
  double sum = 0;
  for (const PackingFiberKind& kind : scene.kinds) {
    sum += static_cast<double>(kind.starts.size()) * (kind.fiber.aspect_ratio + 1) *
           static_cast<double>(plan.steps);
  }
  for (int n = 0; n < scene.batches.number; ++n) {
    const auto present = static_cast<double>(plan.steps - batch_step(scene, n, plan.step));
    for (const auto& [chain, count] : batch_counts(scene, n)) {
      sum += static_cast<double>(count) * (chain.fiber.aspect_ratio + 1) * present;
    }
  }
  return sum;
}

}  // namespace fiberchain::dem
