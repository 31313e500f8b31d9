#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dem/run/session.hpp"

// Runs that go on: to the bit where nothing but output and duration is another, else with the fibers as they
// are and all that can be kept of their memory.
namespace fiberchain::dem {

/// A checkpoint that a run goes on from.
struct Continued {
  std::filesystem::path path;
  const Checkpoint& checkpoint;
};

/// The programs of these instruction sets, to the bit.
std::vector<std::string> programs_of(const Provenance& provenance, const std::vector<InstructionSet>& sets);

/// Goes on to the bit, with the step of the checkpoint.
/// @throws InputError for a state that does not fit, InvalidKey for a scene that ends before it
RunBegin continued(const PackingJob& job, const Continued& from, const std::vector<InstructionSet>& sets,
                   const Say& say);

/// Begins where the file of the scene's start_from left off; what is kept and what is lost is said.
/// @throws InputError for a file that cannot be used, InvalidKey naming what does not go with it, as
/// make_assembly()
RunBegin started_from(const PackingJob& job, const std::vector<InstructionSet>& sets, const Say& say,
                      const InsertionWatch& watch);

/// The scene with the fibers that its start_from has, which is read for that; the scene itself where it has
/// none. A checkpoint of the same physics, with which a run would go on to the bit, is no exception.
/// @throws InvalidKey as started_from(), before anything is built
PackingScene with_start_file(const SceneText& text, const PackingScene& scene);

}  // namespace fiberchain::dem
