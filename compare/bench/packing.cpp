#include "compare/bench/packing.hpp"

#include <unistd.h>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "compare/bench/timing.hpp"
#include "compare/study/tabulate.hpp"
#include "dem/chain/sphere_storage.hpp"
#include "dem/parallel/partition.hpp"
#include "dem/run/samples.hpp"
#include "dem/scene/build_packing.hpp"
#include "dem/scene/side_by_side.hpp"
#include "dem/trajectory/h5md.hpp"

namespace fiberchain::compare {
namespace {

using dem::PackingScene;

/// Resident memory of the process [bytes]; 0 where the system does not say.
double resident() {
  std::ifstream file("/proc/self/statm");
  double all = 0, resident = 0;
  return file >> all >> resident ? resident * static_cast<double>(sysconf(_SC_PAGESIZE)) : 0;
}

/// The same when all that was used before has gone back to the system.
double resident_at_rest() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  return resident();
}

/// The first of its fibers.
PackingScene part_of(const PackingScene& scene, std::size_t parts) {
  PackingScene part = scene;
  for (dem::PackingFiberKind& kind : part.kinds)
    kind.starts.resize(std::max<std::size_t>(kind.starts.size() / parts, 1));
  return part;
}

/// Kicking and moving so many spheres without bonds [ns a sphere], as the assembly keeps them: loads in an
/// array that stays in the inner cache, one thread. A loop of its own: an assembly's does it together with
/// the bonds.
double motion_alone(std::int64_t spheres, const BenchOptions& options) {
  constexpr std::int64_t part = dem::cache_sized_part;
  dem::SphereStorage rows(spheres, false);
  std::vector<double> loads(part * dem::load_size, 1e-3);
  double* position_radius = rows.position_radius.data();
  double* velocity_spin = rows.velocity_spin.data();
  const auto step = [&] {
    for (std::int64_t i = 0; i < spheres; ++i) {
      double *x = position_radius + i * dem::position_radius_size,
             *v = velocity_spin + i * dem::velocity_spin_size, *w = v + dem::spin_offset;
      const double *force = &loads[static_cast<std::size_t>(i % part) * dem::load_size],
                   *moment = force + dem::moment_offset;
      for (int c = 0; c < 3; ++c) v[c] += 1e-6 * force[c], w[c] += 1e-5 * moment[c], x[c] += 1e-6 * v[c];
    }
  };
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < (options.quick ? 5 : 50); ++round) least = std::min(least, time_once(step));
  return 1e9 * least / static_cast<double>(spheres);
}

/// Time of writing one frame [s].
double frame_time(const dem::Assembly& assembly, const PackingScene& scene) {
  const auto directory =
      std::filesystem::temp_directory_path() / ("fiberchain-bench-" + std::to_string(getpid()));
  std::filesystem::create_directory(directory);
  dem::TrajectoryWriter writer(directory / "frame.h5", {"bench", "", {}});
  const double time = time_once([&] { writer.append(frame_of(assembly, scene)); });
  std::filesystem::remove_all(directory);
  return time;
}

struct Windows {
  std::int64_t steps;
  int count;
};

std::vector<PackingTime> times_of(const PackingScene& scene, int threads, const Windows& windows,
                                  double motion) {
  const double before = resident_at_rest();
  dem::PackingStart start = dem::packing_start(scene, threads);
  const double frames_a_step = static_cast<double>(scene.output.frames) / static_cast<double>(start.steps);
  start.options.time_parts = true;
  dem::Assembly assembly = dem::make_assembly(std::move(start));
  std::vector<PackingTime> times;
  for (int n = 0; n < windows.count; ++n) {
    const dem::StepTimes last = assembly.times();
    const std::int64_t from = assembly.steps();
    const double seconds = time_once([&] { assembly.march(windows.steps); });
    const dem::StepTimes now = assembly.times();
    const auto spheres = static_cast<double>(assembly.spheres());
    const double unit = 1e9 / (spheres * static_cast<double>(windows.steps));
    const double own_motion = motion / threads, both = unit * (now.bonds_and_motion - last.bonds_and_motion);
    times.push_back({assembly.spheres(), threads, from, assembly.steps(),
                     static_cast<double>(assembly.touching()) / spheres, unit * seconds, both - own_motion,
                     own_motion, unit * (now.contacts - last.contacts), unit * (now.search - last.search),
                     1e9 * frame_time(assembly, scene) * frames_a_step / spheres,
                     (resident() - before) / spheres});
  }
  return times;
}

/// Sizes in turns, so that all have their share of a machine's slow hours: the fastest run of each, with the
/// memory of the first, which has found none used before.
std::vector<PackingTime> fastest_of(const std::vector<PackingScene>& sizes, int rounds, std::int64_t steps,
                                    const BenchOptions& options) {
  std::vector<double> motion_ns;
  for (const PackingScene& size : sizes) motion_ns.push_back(motion_alone(dem::spheres_in(size), options));
  std::vector<PackingTime> fastest;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      const PackingTime time = times_of(sizes[k], 1, {steps, 1}, motion_ns[k]).front();
      if (round == 0) {
        fastest.push_back(time);
      } else if (time.all < fastest[k].all) {
        const double bytes = fastest[k].bytes_a_sphere;
        fastest[k] = time;
        fastest[k].bytes_a_sphere = bytes;
      }
    }
  }
  return fastest;
}

}  // namespace

std::vector<PackingTime> packing_times(const PackingScene& scene, const BenchOptions& options) {
  std::vector<PackingTime> all;
  const auto add = [&](const std::vector<PackingTime>& times) {
    all.insert(all.end(), times.begin(), times.end());
  };
  const Windows windows = options.quick ? Windows{200, 2} : Windows{2000, 10};
  const double motion = motion_alone(dem::spheres_in(scene), options);
  for (const int threads : {1, 2}) add(times_of(scene, threads, windows, motion));
  add(fastest_of({part_of(scene, 10), scene, dem::side_by_side(scene, options.quick ? 2 : 10)},
                 options.quick ? 1 : 3, options.quick ? 100 : 1500, options));
  return all;
}

dem::Table packing_time_table(const std::vector<PackingTime>& times) {
  return tabulate(times, [](const PackingTime& t) -> dem::NamedRow {
    return {{"spheres", t.spheres},
            {"threads", std::int64_t{t.threads}},
            {"first_step", t.from},
            {"steps", t.to - t.from},
            {"coordination", 2 * t.contacts_a_sphere},
            {"sphere_step_ns", t.all},
            {"bonds_ns", t.bonds},
            {"contacts_ns", t.contacts},
            {"search_ns", t.search},
            {"motion_ns", t.motion},
            {"output_ns", t.output},
            {"sphere_bytes", t.bytes_a_sphere}};
  });
}

}  // namespace fiberchain::compare
