#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "dem/files/file_head.hpp"

namespace fiberchain::dem {

/// A file that changes in one step. What is written stays in memory until `commit`; a program that is killed,
/// a disk that is full, a machine that loses its power leave the file as it was before the commit or as it
/// was to be.
///
/// A commit first writes what lies beyond the file's old end, where nobody looks yet. The pages it has to
/// change within the file go to a journal beside it, which is flushed and renamed to its place, then into the
/// file. Opening a file with a journal sees the journal's pages, and the next commit finishes what the last
/// one began.
///
/// The first FileHead::kBytes bytes are the file's own: who uses it leaves them alone. They count the
/// commits, so that a reader of a file in use knows whether all it read was of one moment: `changed`. Readers
/// share a lock while they have the file open, for which a commit waits, but not long: a reader that is
/// stopped stops nobody.
class JournaledFile {
 public:
  enum class Mode {
    create,  ///< new; whatever stands at the place is replaced by the first commit
    change,
    read
  };

  /// @throws ReadError if it cannot be opened, has no head of its own or is cut off
  JournaledFile(std::filesystem::path path, Mode mode);
  JournaledFile(const JournaledFile&) = delete;
  JournaledFile& operator=(const JournaledFile&) = delete;
  ~JournaledFile();

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t size() const { return size_; }

  /// Bytes beyond the end are 0.
  /// @throws ReadError
  void read(std::uint64_t at, void* bytes, std::size_t count) const;

  /// Grows the file if need be.
  /// @throws ReadError if the rest of a page cannot be read
  void write(std::uint64_t at, const void* bytes, std::size_t count);

  void resize(std::uint64_t size);

  /// Whether somebody has committed, or begun to, since this was opened: what was read may be of two moments.
  bool changed() const;

  /// Brings all of it to the disk. The file must be open for changes.
  /// @throws WriteError; the file is then as it was after the last commit
  void commit();

 private:
  static constexpr std::uint64_t kPage = 4096;
  using Page = std::array<char, kPage>;

  void open();
  void load();
  std::string try_to_load();  ///< "", or what is wrong
  std::optional<FileHead> head_on_disk() const;
  void take_journal(const std::string& journal);
  void set_head();
  void fill(std::uint64_t page, Page& content) const;
  std::uint64_t bytes_of(std::uint64_t page) const;
  void create_whole();
  void write_beyond();
  void write_journal() const;
  void write_within();
  void put(std::uint64_t page, const Page& content) const;
  using Pages = std::map<std::uint64_t, Page>;
  void put(Pages::const_iterator from, Pages::const_iterator to) const;

  std::filesystem::path path_;
  Mode mode_;
  int file_ = -1;
  FileHead head_;               ///< as of opening, or of the last commit
  std::uint64_t old_size_ = 0;  ///< on the disk
  std::uint64_t size_ = 0;
  Pages changed_;  ///< by number
};

/// The journal beside a file.
std::filesystem::path journal_of(const std::filesystem::path& path);

}  // namespace fiberchain::dem
