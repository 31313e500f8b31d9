#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace fiberchain::dem {

/// A file under a temporary name beside its place, removed unless it was renamed there: what stands at the
/// place is whole at any moment, whatever ends the program.
class AtomicFile {
 public:
  /// Writes the content and flushes it to the disk.
  /// @throws WriteError naming the place and the reason
  AtomicFile(std::filesystem::path place, std::string_view content);
  /// Empty and open: who fills it by its temporary name or its descriptor calls `close` then.
  /// @throws WriteError
  explicit AtomicFile(std::filesystem::path place);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  const std::filesystem::path& staged() const { return staged_; }
  int descriptor() const { return file_; }
  /// Flushes it to the disk.
  /// @throws WriteError
  void close();
  /// @throws WriteError
  void take_place();

 private:
  void fill(std::string_view content);
  void discard() noexcept;
  [[noreturn]] void fail() const;

  std::filesystem::path place_;
  std::filesystem::path staged_;
  int file_ = -1;
};

/// Removes what killed programs have left under temporary names for files whose names begin so. Nobody may be
/// writing such files now.
void remove_staged(const std::filesystem::path& directory, const std::string& name);

/// Flushes the renames in a directory to the disk. File systems that cannot do that are let off.
void flush_directory(const std::filesystem::path& path);

/// A file of this content at this place, in one step.
/// @throws WriteError; what stood there before then still does
void replace_file(const std::filesystem::path& place, std::string_view content);

}  // namespace fiberchain::dem
