#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "dem/assembly/assembly.hpp"
#include "dem/insertion/placement.hpp"
#include "dem/insertion/random_insertion.hpp"
#include "dem/material/material_damping.hpp"
#include "dem/scene/scene_text.hpp"

namespace fiberchain::dem {

/// Fibers of one kind, put in at random or where a file says.
struct PackingFiberKind {
  Fiber fiber;
  std::int64_t count = 0;               ///< at random, in all batches together
  std::vector<FiberStart> starts = {};  ///< of the file
  std::optional<SceneText> file = {};   ///< which holds the starts
  DampingSummary damping = {};          ///< of its material
  std::optional<SceneText> material_file = {};
  std::string name = {};
  int surface = 0;      ///< in Domain::pairs
  bool smooth = false;  ///< Chain::smooth
};

/// What is done where a later batch finds no room.
enum class NoRoomChoice {
  end,   ///< the run ends there with its files
  wait,  ///< the batch is tried again, ten times an interval, until it goes in
  fewer  ///< as many fibers as find a place come, the others never
};

/// Insertion of the random fibers in equal parts, one every interval, the first at the start.
struct Batches {
  int number = 1;
  int done = 0;         ///< of them that were over where the scene goes on: the others have all fibers
  double interval = 0;  ///< [s]
  NoRoomChoice no_room = NoRoomChoice::end;
};

/// What a run writes, in equal intervals of its steps.
struct PackingOutput {
  int samples = 200;      ///< intervals of the log
  int frames = 50;        ///< intervals of the trajectory
  int checkpoints = 20;   ///< intervals of the checkpoints
  bool vtk = false;       ///< frames as VTK files too
  bool contacts = false;  ///< frames with their contacts
};

/// What the clock of a scene that goes on from a file shows at its start.
enum class StartClock {
  as_in_file,  ///< the time of the file: walls, batches, flow and duration count from where its run began
  zero         ///< 0
};

/// A file that a scene goes on from.
struct StartFile {
  std::filesystem::path path;
  std::optional<std::int64_t> frame = {};  ///< of a trajectory, from 0; left out: the last
  StartClock clock = StartClock::as_in_file;

  /// A trajectory; else a checkpoint.
  bool is_trajectory() const { return path.extension() == ".h5"; }
};

/// Fibers of a group that a scene has from a file.
struct CarriedFibers {
  int kind;  ///< among those of the scene
  std::int64_t fibers;
};

/// Spheres that are held or loaded, as a scene names them.
struct SceneGrip {
  Grip grip;                               ///< its spheres are those of grips_of()
  std::size_t kind = 0;                    ///< of their fibers
  std::optional<std::int64_t> fiber = {};  ///< number among those of the kind; left out: all at the start
  std::vector<int> spheres = {};           ///< of each
  bool is_load = false;
};

/// Many fibers that meet each other and walls.
struct PackingScene {
  std::vector<PackingFiberKind> kinds;
  std::optional<StartFile> start_from = {};
  /// Groups that are there already, from `start_from`: before all others, and beside the kinds' own counts.
  /// Empty until the file has been read (carry_over.hpp).
  std::vector<CarriedFibers> carried = {};
  double carried_speed = 0;  ///< of the fastest of their spheres [m/s]
  InsertionRules filling =
      {};  ///< region, orientation, velocity, gap, seed and attempts of the fibers at random
  Batches batches = {};
  Domain domain = {};
  std::vector<SceneGrip> held = {};
  Box scene_box = {};  ///< shown in pictures and files; its cross section is that of densities [m]
  Integrator integrator = Integrator::leapfrog;  ///< leapfrog, leapfrog_stiff or automatic
  BondForm form = BondForm::incremental;
  Rolling rolling = Rolling::set_valued;
  std::optional<double> step = {};                     ///< [s]; left out: chosen
  double duration = 0;                                 ///< [s]; 0 where steps are given
  std::int64_t steps = 0;                              ///< 0 where the duration is given
  double restitution_error = usual_restitution_error;  ///< that a chosen step may make
  bool account_energy = false;                         ///< sum what each mechanism takes
  bool allow_unstable = false;                         ///< march even beyond the stable step of the contacts
  bool orientations = false;                           ///< follow orientations of spheres that nothing needs
  PackingOutput output = {};
};

}  // namespace fiberchain::dem
