#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fiberchain::dem {

/// A file to be: name within the output directory and content.
struct OutputFile {
  std::string name;
  std::string content;
};

/// A directory results go to. Files appear in it whole or not at all: each is written under a temporary
/// name beside its place, flushed to the disk, and renamed; a failure leaves what was there before.
class OutputDirectory {
 public:
  /// Makes the directory if it is not there.
  /// @throws OutputError naming the path and the reason if it cannot be made or written to
  explicit OutputDirectory(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  bool made() const { return made_; }  ///< it was not there before

  /// Writes all the files: none is renamed to its place before every one is safely on the disk.
  /// @throws OutputError naming the file and the reason
  void write(const std::vector<OutputFile>& files) const;

 private:
  std::filesystem::path path_;
  bool made_ = false;
};

}  // namespace fiberchain::dem
