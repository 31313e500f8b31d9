#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dem/scene/scene_keys.hpp"
#include "dem/trajectory/checkpoint.hpp"

// Names of the files of a packing run, and the lock of its directory.
namespace fiberchain::dem {

/// Takes a message for people.
using Say = std::function<void(const std::string&)>;

struct RunFiles {
  std::filesystem::path directory;
  std::string name;  ///< of the scene: NAME.yaml

  std::filesystem::path at(const std::string& end) const { return directory / (name + end); }
  std::filesystem::path trajectory() const { return at(".h5"); }
  std::filesystem::path log() const { return at("-log.csv"); }
  std::filesystem::path walls() const { return at("-walls.csv"); }
  std::filesystem::path held() const { return at("-held.csv"); }
  std::filesystem::path breaks() const { return at("-breaks.csv"); }
  std::filesystem::path checkpoint() const { return at(".checkpoint"); }
};

/// Under which name a broken file is kept; n = 1 unless that is taken.
std::filesystem::path broken_name(const std::filesystem::path& path, int n);

/// Existing files of a run, which a new run would overwrite.
std::vector<std::filesystem::path> files_there(const RunFiles& files);

/// Removes them.
/// @throws OutputError
void remove_files(const RunFiles& files);

/// Removes half-written files of a killed run.
void remove_leftovers(const RunFiles& files);

/// The last checkpoint, or the one before if the last cannot be used, which is said and the bad one put aside
/// as NAME.checkpoint.bad; nothing if there is none at all.
/// @param keys of the scene that goes on
/// @param programs whose checkpoints may be used: this one, with each instruction set that this processor has
/// @throws InputError if no checkpoint can be used, it is of another program, or of a scene with other
/// physics, whose keys are named
std::optional<Checkpoint> find_checkpoint(const RunFiles& files, const SceneKeys& keys,
                                          const std::vector<std::string>& programs, const Say& say);

/// What differs in physics from the scene that a checkpoint is of, "contacts.friction: 0.3, was 0.2; ..."; ""
/// if nothing does.
std::string other_physics(const Checkpoint& checkpoint, const SceneKeys& keys);

/// Exclusive lock of a directory by one run; the system releases it at the end of the process, a kill
/// included.
class DirectoryLock {
 public:
  /// @throws OutputError if another run has it, or it cannot be had
  explicit DirectoryLock(const std::filesystem::path& directory);
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;
  ~DirectoryLock();

 private:
  int directory_ = -1;
};

}  // namespace fiberchain::dem
