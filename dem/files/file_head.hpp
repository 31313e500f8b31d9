#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fiberchain::dem {

/// What the first bytes of a journaled file say of it, as text.
struct FileHead {
  static constexpr std::size_t kBytes = 512;  ///< HDF5 looks for itself at 0, 512, 1024 ...

  std::string id;             ///< of this file and no other, in 16 hexadecimal digits
  std::uint64_t commits = 0;  ///< made so far: another number is another moment
  std::uint64_t bytes = 0;    ///< of the file as of the last commit

  bool operator==(const FileHead&) const = default;
};

/// An identity that no other file has.
std::string new_file_id();

/// The head as it stands in the file, with its own checksum.
std::string text_of(const FileHead& head);

/// Nothing if these bytes do not begin with a whole head.
std::optional<FileHead> parse_head(std::string_view bytes);

}  // namespace fiberchain::dem
