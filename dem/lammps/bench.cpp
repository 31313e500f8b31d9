#include "dem/lammps/bench.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "dem/lammps/engine.hpp"
#include "dem/lammps/resources.hpp"
#include "dem/model/invalid_key.hpp"
#include "dem/scene/build_packing.hpp"
#include "dem/scene/side_by_side.hpp"

namespace fiberchain::dem::mpi {
namespace {

/// Who marches how much. No ranks: the engine of one machine.
struct Case {
  int copies, ranks;
  friend auto operator<=>(const Case&, const Case&) = default;
};

std::vector<Case> cases_of(int ranks, int copies) {
  std::vector<Case> cases{{1, 0}, {1, 1}};
  if (copies > 1) cases.insert(cases.end(), {{copies, 0}, {copies, 1}});
  for (int n = 2; n <= ranks; n *= 2) {
    for (const Case more : {Case{n, 1}, Case{1, n}, Case{n, n}}) {
      if (std::ranges::find(cases, more) == cases.end()) cases.push_back(more);
    }
  }
  std::ranges::stable_sort(cases, {}, &Case::copies);  // each size is built once
  return cases;
}

/// All ranks wait for the last of them, without a core for it.
void wait_for_all(MPI_Comm world) {
  MPI_Request request;
  MPI_Ibarrier(world, &request);
  for (int done = 0; done == 0; usleep(2000)) MPI_Test(&request, &done, MPI_STATUS_IGNORE);
}

/// Of one machine's engine, which goes on with it.
Engine::Cost own_cost(Assembly& assembly, std::int64_t steps) {
  const double before = MPI_Wtime(), worked = processor_time();
  assembly.march(steps);
  return {.wall = MPI_Wtime() - before, .processor = processor_time() - worked};
}

/// Collective; the cost is rank 0's.
Engine::Cost cost_of(const Case& which, MPI_Comm world, const PackingScene& scene,
                     std::optional<Assembly>& assembly, std::int64_t steps) {
  int me = 0;
  MPI_Comm_rank(world, &me);
  Engine::Cost cost;
  if (which.ranks == 0) {
    if (me == 0) cost = own_cost(*assembly, steps);
  } else {
    MPI_Comm some = MPI_COMM_NULL;
    MPI_Comm_split(world, me < which.ranks ? 0 : MPI_UNDEFINED, me, &some);
    if (some != MPI_COMM_NULL) {
      Engine engine(some, scene, Sharing::bricks);
      if (me == 0) {
        cost = engine.cost(*assembly, steps);
        engine.dismiss();
      } else {
        engine.serve();
      }
    }
    if (some != MPI_COMM_NULL) MPI_Comm_free(&some);
  }
  wait_for_all(world);
  return cost;
}

void keep_fastest(std::map<Case, Engine::Cost>& fastest, const Case& which, const Engine::Cost& cost) {
  const auto known = fastest.try_emplace(which, cost).first;
  known->second.wall = std::min(known->second.wall, cost.wall);
  known->second.processor = std::min(known->second.processor, cost.processor);
}

std::string row_of(const Case& which, std::int64_t spheres, const Engine::Cost& cost, double steps,
                   double of_one_machine) {
  const double unit = 1e9 / (static_cast<double>(spheres) * steps), ns = unit * cost.processor;
  std::string row =
      fmt::format("| {} | {} | {:.1f} | {:.1f} |", spheres,
                  which.ranks == 0 ? "fiberchain" : fmt::format("{}", which.ranks), unit * cost.wall, ns);
  if (which.ranks == 0) return row + " 1 | | |\n";
  return row + fmt::format(" {:.2f} | {:.1f} | {:.0f} |\n", ns / of_one_machine,
                           100 * cost.ghosts / static_cast<double>(spheres),
                           cost.memory / static_cast<double>(spheres));
}

}  // namespace

std::string scaling_table(MPI_Comm world, const PackingScene& scene, const BenchOptions& options) {
  if (std::ranges::any_of(scene.kinds, [](const auto& kind) { return kind.starts.empty(); }))
    throw InvalidKey("fibers", "fibers without starts are not allowed here: a bench takes them from files");
  int me = 0, ranks = 0;
  MPI_Comm_rank(world, &me), MPI_Comm_size(world, &ranks);
  std::map<Case, Engine::Cost> fastest;
  std::map<int, std::int64_t> spheres;
  const std::vector<Case> cases = cases_of(ranks, options.copies);
  for (std::size_t first = 0, end = 0; first < cases.size(); first = end) {
    const int copies = cases[first].copies;
    while (end < cases.size() && cases[end].copies == copies) ++end;
    const PackingScene wide = side_by_side(scene, copies);
    std::optional<Assembly> assembly;
    if (me == 0) {
      assembly.emplace(make_assembly(packing_start(wide, 1)));
      assembly->march(options.after);
      spheres[copies] = assembly->spheres();
    }
    for (int round = 0; round < options.rounds; ++round) {
      for (std::size_t n = first; n < end; ++n)
        keep_fastest(fastest, cases[n], cost_of(cases[n], world, wide, assembly, options.steps));
    }
  }
  if (me != 0) return "";
  std::string table =
      "| spheres | ranks | wall clock [ns a sphere-step] | processor [ns a sphere-step] | over fiberchain | "
      "ghosts [%] | memory [B a sphere] |\n|---|---|---|---|---|---|---|\n";
  const auto steps = static_cast<double>(options.steps);
  for (const auto& [which, cost] : fastest) {
    // sizes between are held against the smallest
    const auto own = fastest.find({which.copies, 0});
    const auto of = own != fastest.end() ? which.copies : 1;
    const double one = 1e9 * fastest.at({of, 0}).processor / (static_cast<double>(spheres[of]) * steps);
    table += row_of(which, spheres[which.copies], cost, steps, one);
  }
  return table;
}

}  // namespace fiberchain::dem::mpi
