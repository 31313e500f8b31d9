#pragma once

#include <cstdint>
#include <filesystem>

#include "compare/provenance.hpp"
#include "compare/run_status.hpp"

namespace fiberchain::compare {

/// How a run went, as CSV (compare/csv.hpp) that grows by a whole line at a time, each given to the system at
/// once.
class RunLog {
 public:
  /// A new log under its provenance, in place of what stood there.
  /// @throws OutputError
  RunLog(const std::filesystem::path& path, const Provenance& provenance);

  /// Goes on with a log without its lines later than `last_step` and without one that a kill cut off; begins
  /// it if there is none.
  /// @throws OutputError, InputError if what stands there is no log of ours
  static RunLog resume(const std::filesystem::path& path, const Provenance& provenance,
                       std::int64_t last_step);

  RunLog(RunLog&& other) noexcept;
  ~RunLog();

  /// @throws OutputError
  void append(const RunStatus& status);

 private:
  explicit RunLog(std::filesystem::path path);

  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace fiberchain::compare
