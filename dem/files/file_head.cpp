#include "dem/files/file_head.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <random>

#include "dem/files/numbers.hpp"
#include "dem/files/sha256.hpp"

namespace fiberchain::dem {
namespace {

constexpr std::string_view kMagic = "fiberchain file 1\n";

std::string body_of(const FileHead& head) {
  return fmt::format("{}id {}\ncommits {}\nbytes {}\n", kMagic, head.id, head.commits, head.bytes);
}

/// The rest of the line that begins with this word.
std::string_view line_of(std::string_view text, std::string_view word) {
  const std::size_t at = text.find(word);
  if (at == std::string_view::npos) return "";
  const std::size_t from = at + word.size(), end = text.find('\n', from);
  return end == std::string_view::npos ? "" : text.substr(from, end - from);
}

}  // namespace

std::string new_file_id() {
  std::random_device source;
  const auto now = static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
  const std::uint64_t random = (std::uint64_t{source()} << 32) ^ source();
  return fmt::format("{:016x}", random ^ now ^ (static_cast<std::uint64_t>(::getpid()) << 40));
}

std::string text_of(const FileHead& head) {
  const std::string body = body_of(head);
  std::string text = fmt::format("{}sha256 {}\n", body, sha256(body));
  text.resize(FileHead::kBytes, '\0');
  return text;
}

std::optional<FileHead> parse_head(std::string_view bytes) {
  const std::string_view text = bytes.substr(0, FileHead::kBytes);
  if (!text.starts_with(kMagic)) return std::nullopt;
  const auto commits = parse_integer(line_of(text, "\ncommits ")),
             size = parse_integer(line_of(text, "\nbytes "));
  if (!commits || !size || *commits < 0 || *size < 0) return std::nullopt;
  const FileHead head{std::string(line_of(text, "\nid ")), static_cast<std::uint64_t>(*commits),
                      static_cast<std::uint64_t>(*size)};
  if (text_of(head) != text) return std::nullopt;
  return head;
}

}  // namespace fiberchain::dem
