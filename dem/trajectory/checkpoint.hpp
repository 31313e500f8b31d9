#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "dem/assembly/saved_state.hpp"

namespace fiberchain::dem {

/// The last steps that stand in the files beside a checkpoint; -1: none.
struct WrittenSteps {
  std::int64_t log = -1, trajectory = -1, vtk = -1;

  bool operator==(const WrittenSteps&) const = default;
};

/// State of a run, sufficient to continue it to the bit.
struct Checkpoint {
  std::string program;       ///< which binary wrote it: version, commit, compiler, flags
  int threads = 1;           ///< it ran with
  std::string scene_sha256;  ///< of everything the scene is made of
  std::string scene;         ///< text of the scene file
  std::string keys = {};     ///< what the scene says, a line a key (scene/scene_keys.hpp)
  std::int64_t step = 0;
  double time = 0;                          ///< [s]
  std::vector<std::int64_t> inserted = {};  ///< fibers of each group that came after the start
  std::vector<std::int64_t> kinds = {};     ///< kind of the fibers of each group that is there
  std::vector<std::int64_t> carried = {};   ///< kind and fibers of each group that came from a file before
  std::int64_t batches_done = 0;            ///< batches of fibers that were over then
  WrittenSteps written = {};
  SavedState state;  ///< of the assembly, kept to the bit

  bool operator==(const Checkpoint&) const = default;
};

/// Writes a checkpoint: 512 bytes of text (format, SHA-256 and size of the rest), then HDF5, which h5dump and
/// h5py open as it stands: /scene, /keys, /threads, /step, /time, /inserted, /kinds, /carried, /batches_done,
/// /written, and in /state a dataset for every field of the state, whose attribute "version" is that of the
/// field. The one that stood there before becomes
/// PATH.previous. At any moment there is a whole checkpoint at the place.
/// @throws WriteError; what stood there before then still does
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// The same with a state whose fields come one after the other, in place of `checkpoint.state`: it need not
/// be in memory twice. `fields` calls what it is given with each field's name and values.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint,
                      const EachField& fields);

/// Reads a checkpoint. Not a byte of it is believed before its checksum is right.
/// @throws ReadError naming the file and the reason: absent, no checkpoint, of another format, cut off,
/// corrupt; or the field of the state that cannot be read
Checkpoint read_checkpoint(const std::filesystem::path& path);

/// Where the checkpoint before the last is kept.
std::filesystem::path previous_checkpoint(const std::filesystem::path& path);

/// Why a run resumed by this program with so many threads might not end in the same bits; "" if it will.
std::string resumed_differently(const Checkpoint& checkpoint, const std::string& program, int threads);

}  // namespace fiberchain::dem
