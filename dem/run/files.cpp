#include "dem/run/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "dem/files/atomic_file.hpp"
#include "dem/files/journaled_file.hpp"
#include "dem/record/errors.hpp"
#include "dem/trajectory/vtk.hpp"

namespace fiberchain::dem {
namespace {

namespace fs = std::filesystem;

/// All files that a run may write.
std::vector<fs::path> all_files(const RunFiles& files) {
  const fs::path trajectory = files.trajectory(), checkpoint = files.checkpoint();
  return {checkpoint,
          previous_checkpoint(checkpoint),
          files.at(".checkpoint.bad"),
          trajectory,
          journal_of(trajectory),
          files.at(".h5md"),
          files.at(".xmf"),
          files.log(),
          files.walls(),
          files.held(),
          files.breaks(),
          files.at(".pvd"),
          files.at("-lines.pvd"),
          files.at("-contacts.pvd"),
          files.at("-walls.pvd"),
          files.at(".csv"),
          files.at(".md"),
          files.at("-bending.svg"),
          files.at("-bending.png"),
          files.at("-energy.svg"),
          files.at("-energy.png")};
}

/// A checkpoint of this scene and one of these programs.
/// @throws ReadError where it cannot be read, InputError
Checkpoint our_checkpoint(const fs::path& path, const SceneKeys& keys,
                          const std::vector<std::string>& programs) {
  Checkpoint checkpoint = read_checkpoint(path);
  if (const std::string other = other_physics(checkpoint, keys); !other.empty()) {
    throw InputError(fmt::format("{}: belongs to another scene: {}; start_from goes on with other physics",
                                 path.string(), other));
  }
  if (std::ranges::find(programs, checkpoint.program) != programs.end()) return checkpoint;
  throw InputError(
      fmt::format("{}: was written by another program ({}; this is {}), which need not end in the same bits",
                  path.string(), checkpoint.program, programs.front()));
}

}  // namespace

fs::path broken_name(const fs::path& path, int n) {
  return path.string() + (n == 1 ? ".bad" : fmt::format(".bad.{}", n));
}

std::vector<fs::path> files_there(const RunFiles& files) {
  std::vector<fs::path> there;
  for (const fs::path& path : all_files(files)) {
    if (fs::exists(path)) there.push_back(path);
  }
  for (const fs::path& path :
       {files.trajectory(), files.log(), files.walls(), files.held(), files.breaks(), files.at(".pvd")}) {
    for (int n = 1; fs::exists(broken_name(path, n)); ++n) there.push_back(broken_name(path, n));
  }
  const std::vector<fs::path> parts = vtk_parts(files.at(""));
  there.insert(there.end(), parts.begin(), parts.end());
  return there;
}

void remove_files(const RunFiles& files) {
  for (const fs::path& path : files_there(files)) {
    std::error_code error;
    fs::remove(path, error);
    if (error) throw OutputError(path, error.message());
  }
  std::error_code others_in_it;  // keep the folder
  fs::remove(files.at(""), others_in_it);
}

void remove_leftovers(const RunFiles& files) {
  remove_staged(files.directory, files.name);
  remove_staged(files.at(""), "");
}

std::string other_physics(const Checkpoint& checkpoint, const SceneKeys& keys) {
  constexpr std::size_t most = 5;
  const std::vector<KeyChange> changes = physical(changes_between(scene_keys_in(checkpoint.keys), keys));
  std::string words;
  for (std::size_t n = 0; n < std::min(most, changes.size()); ++n)
    words += (n == 0 ? "" : "; ") + in_words(changes[n]);
  return changes.size() > most ? words + fmt::format("; and {} more keys", changes.size() - most) : words;
}

std::optional<Checkpoint> find_checkpoint(const RunFiles& files, const SceneKeys& keys,
                                          const std::vector<std::string>& programs, const Say& say) {
  const fs::path last = files.checkpoint(), previous = previous_checkpoint(last);
  if (!fs::exists(last) && !fs::exists(previous)) return std::nullopt;
  std::string reason;
  try {
    return our_checkpoint(last, keys, programs);
  } catch (const ReadError& error) {
    reason = error.what();
  }
  try {
    Checkpoint before = our_checkpoint(previous, keys, programs);
    say(fmt::format("{}; going on from the one before, of step {}", reason, before.step));
    std::error_code ignored;  // absent: nothing to put aside
    fs::rename(last, files.at(".checkpoint.bad"), ignored);
    return before;
  } catch (const ReadError& error) {
    throw InputError(fmt::format("no checkpoint to go on from: {}; {}", reason, error.what()));
  }
}

DirectoryLock::DirectoryLock(const fs::path& directory)
    : directory_(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (directory_ >= 0 && ::flock(directory_, LOCK_EX | LOCK_NB) == 0) return;
  const int reason = errno;
  if (directory_ >= 0) ::close(directory_);
  throw OutputError(
      directory, reason == EWOULDBLOCK ? "another run is at work in this directory" : std::strerror(reason));
}

DirectoryLock::~DirectoryLock() { ::close(directory_); }

}  // namespace fiberchain::dem
