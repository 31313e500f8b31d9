#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

// What can go wrong with the files of a run. Every message is one line and names the file.
namespace fiberchain::dem {

/// A file that cannot be written: unwritable directory, full disk.
struct WriteError : std::runtime_error {
  /// Message "cannot write PATH: REASON".
  WriteError(const std::filesystem::path& path, const std::string& reason)
      : std::runtime_error("cannot write " + path.string() + ": " + reason) {}
};

/// A file that cannot be used: absent, cut off, corrupt, or of another kind than asked for.
struct ReadError : std::runtime_error {
  /// Message "PATH: REASON".
  ReadError(const std::filesystem::path& path, const std::string& reason)
      : std::runtime_error(path.string() + ": " + reason) {}
};

}  // namespace fiberchain::dem
