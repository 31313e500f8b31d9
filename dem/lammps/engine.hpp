#pragma once

#include <mpi.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "dem/assembly/assembly.hpp"
#include "dem/scene/packing_scene.hpp"

// A packing marched by LAMMPS over ranks. Rank 0 has the assembly that files are written of; what it holds
// goes out to the ranks that own the spheres, and comes back where files want it.
namespace fiberchain::dem::mpi {

/// How spheres are shared out among ranks.
enum class Sharing {
  bricks,  ///< equal boxes
  tiles    ///< boxes of as many spheres, cut by recursive bisection whenever spheres are sent out
};

class Engine {
 public:
  /// Collective, as all of it. The scene is that of every rank.
  /// @throws InvalidKey naming what of the scene is not built here
  Engine(MPI_Comm world, const PackingScene& scene, Sharing sharing);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Rank 0 only, while the others serve(): so many steps of the assembly, which is then another one.
  /// @throws Diverged where positions are not finite or bodies may have passed through each other
  void march(Assembly& assembly, std::int64_t steps);
  /// Sends the assembly's spheres out, and does commands of LAMMPS with them there.
  void send_out(const Assembly& assembly);
  /// What a march cost.
  struct Cost {
    double wall = 0;       ///< of the slowest rank [s]
    double processor = 0;  ///< of all ranks together [s]
    double ghosts = 0;     ///< of all ranks, at its end
    double memory = 0;     ///< of all ranks, grown since the engine was made [bytes]
  };
  /// Rank 0: sends the assembly's spheres out and marches them, after a step that sets up; they do not come
  /// back.
  Cost cost(const Assembly& assembly, std::int64_t steps);
  /// Rank 0: the others come back from serve().
  void dismiss();

  /// Ranks but 0: does what rank 0 says until it dismisses.
  void serve();

  /// All ranks: reads a script of LAMMPS with the spheres there that were sent out last, if any were.
  void run_script(const std::string& path);

  /// Rank 0: of all ranks' spheres, those on the busiest one, and ghosts of all, at the last march.
  struct Spread {
    std::int64_t most = 0, ghosts = 0;
  };
  Spread spread() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fiberchain::dem::mpi
