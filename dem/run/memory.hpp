#pragma once

#include <optional>
#include <string>

#include "dem/scene/packing_scene.hpp"

// Whether a run goes into the memory there is: the system kills one that does not, without a word.
namespace fiberchain::dem {

struct AvailableMemory {
  double bytes;
  std::string set_by;  ///< which limit binds: memory free on this machine, the control group's, the process's
};

/// The least of what the system has free without swapping, and with, of what the control groups (v1, v2)
/// leave and of RLIMIT_AS and RLIMIT_DATA; nothing where the system does not say.
std::optional<AvailableMemory> available_memory();

/// @throws InvalidInput if the packing needs more, with the bytes needed and available
void require_memory(const PackingScene& scene);

/// ": 1.2 GB are available (limit of the control group)"; "" where the system does not say.
std::string memory_in_words();

/// "1.5 TB", as people read bytes.
std::string bytes_in_words(double bytes);

}  // namespace fiberchain::dem
