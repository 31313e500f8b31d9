#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "dem/record/output.hpp"
#include "dem/run/session.hpp"

namespace fiberchain::dem {

/// What becomes of a run whose files are in the directory already.
enum class EarlierRun { refuse, resume, replace };

/// A packing's run where it begins or goes on: its directory made, locked while this lives, and rid of
/// leftovers.
class OpenedRun {
 public:
  /// `job.resume` must agree with `earlier`; `advice` follows "FILE is there already, of a run before" where
  /// that is refused. A scene that cannot begin leaves no files.
  /// @throws InvalidInput, NoRoom; InputError for an earlier run that is refused or a checkpoint that cannot
  /// be used; OutputError
  OpenedRun(const PackingJob& job, EarlierRun earlier, std::string_view advice, const Say& say,
            const InsertionWatch& watch = {});

  RunBegin begin() { return std::move(*begin_); }  ///< to be taken once
  const OutputDirectory& directory() const { return *directory_; }

 private:
  std::optional<RunBegin> begin_;
  std::optional<OutputDirectory> directory_;
  std::optional<DirectoryLock> lock_;
};

/// How a packing is run, and who is told. The defaults are silent and do not stop it.
struct RunOptions {
  std::filesystem::path directory =
      ".";          ///< of NAME.h5, NAME-log.csv, NAME.checkpoint; made if it is not there
  int threads = 1;  ///< results do not depend on it
  EarlierRun earlier = EarlierRun::refuse;
  Say say = [](const std::string&) {};                         ///< messages
  std::function<bool()> asked_to_stop = [] { return false; };  ///< the run then writes a checkpoint and ends
  std::function<void(const Assembly&)> sampled =
      {};  ///< called at every line of the log, the first and last included
};

/// Runs a packing to its end, its files named as the scene's. A run that blows up ends with `failure`.
/// @throws InvalidInput, NoRoom; InputError for an earlier run that is neither to be resumed nor replaced, or
/// a checkpoint that cannot be used; OutputError
PackingEndState run_scene(const SceneText& text, const PackingScene& scene, const RunOptions& options = {});

}  // namespace fiberchain::dem
