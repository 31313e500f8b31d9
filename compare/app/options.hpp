#pragma once

#include <filesystem>
#include <optional>

#include "compare/damping_table.hpp"
#include "compare/static_table.hpp"

/// What the command line asks for, as plain values.
namespace fiberchain::app {

/// Options every command with results has.
struct OutputOptions {
  bool json = false;                         ///< rows as one JSON object on standard output
  std::optional<std::filesystem::path> out;  ///< results directory; without it "results", or none with --json
  std::optional<std::filesystem::path> data;  ///< data directory, in place of the program's own
  int jobs = 1;                               ///< threads
};

struct ColumnsOptions {
  bool json = false;
};

struct RunOptions {
  std::filesystem::path scene;
  OutputOptions output;
};

struct TablesStaticOptions {
  compare::StaticSweep sweep;
  OutputOptions output;
};

struct TablesDampingOptions {
  compare::DampingSweep sweep;
  bool chosen = false;  ///< a sweep was asked for; without one the figures' cases are run
  OutputOptions output;
};

struct ValidateOptions {
  OutputOptions output;
};

}  // namespace fiberchain::app
