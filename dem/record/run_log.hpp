#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dem/record/provenance.hpp"
#include "dem/record/table.hpp"

namespace fiberchain::dem {

/// How a run went, as CSV (dem/record/csv.hpp) that grows by a whole line at a time, each given to the system
/// at once. Its first column is "step"; of each step there are so many `rows`.
class RunLog {
 public:
  static constexpr std::size_t any_rows = 0;  ///< of each step as many as come, or none

  /// A new log of an empty table under its provenance, in place of what stood there.
  /// @throws OutputError
  RunLog(const std::filesystem::path& path, const Table& empty, const Provenance& provenance);

  /// Goes on with a log of such a table without its lines later than `last_step` and without one that a kill
  /// cut off; begins it if there is none.
  /// @throws OutputError, InputError if what stands there is no log of ours or damaged
  static RunLog resume(const std::filesystem::path& path, const Table& empty, const Provenance& provenance,
                       std::int64_t last_step, std::size_t rows = 1);

  /// The last step up to `done` in a log of such a table; nothing if there is none.
  /// @throws InputError naming file and line of what cannot be read
  static std::optional<std::int64_t> last_step(const std::filesystem::path& path, const Table& empty,
                                               std::int64_t done, std::size_t rows = 1);

  RunLog(RunLog&& other) noexcept;
  ~RunLog();

  /// Adds the rows of a table with the same columns.
  /// @throws OutputError, TableError for other columns
  void append(const Table& rows);

  /// Has everything on the disk.
  /// @throws OutputError
  void flush() const;

 private:
  RunLog(std::filesystem::path path, std::vector<std::string> columns);

  std::filesystem::path path_;
  std::vector<std::string> columns_;
  int file_ = -1;
};

}  // namespace fiberchain::dem
