#pragma once

#include <filesystem>
#include <istream>
#include <string>

#include "compare/identify/damped_sines.hpp"

namespace fiberchain::compare {

/// Which columns of a CSV file are a ring-down.
struct RecordColumns {
  std::string time = {};          ///< by name; empty: the first
  std::string displacement = {};  ///< empty: the second, or the first that is not the time
  double time_unit = 1;           ///< what 1 of the column of times is [s]
};

/// A ring-down of a CSV file: a header, then numbers. Lines that begin with # are passed over. Throws
/// InputError naming file, line and column.
RingDownRecord read_record(std::istream& input, const std::string& name, const RecordColumns& columns = {});
RingDownRecord read_record(const std::filesystem::path& path, const RecordColumns& columns = {});

}  // namespace fiberchain::compare
