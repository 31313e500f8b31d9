#pragma once

#include <cstdint>
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
  double interval = 0;  ///< [s]
  NoRoomChoice no_room = NoRoomChoice::end;
};

/// What a run writes, in equal intervals of its steps.
struct PackingOutput {
  int samples = 200;     ///< intervals of the log
  int frames = 50;       ///< intervals of the trajectory
  int checkpoints = 20;  ///< intervals of the checkpoints
  bool vtk = false;      ///< frames as VTK files too
};

/// Many fibers that meet each other and walls.
struct PackingScene {
  std::vector<PackingFiberKind> kinds;
  InsertionRules filling =
      {};  ///< region, orientation, velocity, gap, seed and attempts of the fibers at random
  Batches batches = {};
  Domain domain = {};
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
