#include "dem/record/run_log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include "dem/files/atomic_file.hpp"
#include "dem/files/numbers.hpp"
#include "dem/record/csv.hpp"
#include "dem/record/errors.hpp"
#include "dem/record/table.hpp"

namespace fiberchain::dem {
namespace {

/// The line of the header.
std::string header_line(const Table& empty) {
  const std::string text = to_csv(empty, {});
  return text.substr(text.rfind('\n', text.size() - 2) + 1);
}

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path)) throw InputError(path.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The text as far as it belongs to steps up to `last_step`, without a line that a kill cut off.
std::string kept(const std::filesystem::path& path, const std::string& text, const std::string& header,
                 std::int64_t last_step) {
  const std::size_t at = text.starts_with(header) ? 0 : text.find("\n" + header) + 1;
  if (at == 0 && !text.starts_with(header)) throw InputError(path.string() + ": is no log of this run");
  std::size_t end = at + header.size();
  while (true) {
    const std::size_t line_end = text.find('\n', end);
    if (line_end == std::string::npos) return text.substr(0, end);
    const auto step = parse_integer(std::string_view(text).substr(end, text.find(',', end) - end));
    if (!step) {
      throw InputError(fmt::format("{}:{}: begins with no step", path.string(),
                                   1 + std::ranges::count(text.substr(0, end), '\n')));
    }
    if (*step > last_step) return text.substr(0, end);
    end = line_end + 1;
  }
}

/// Reads every number, and gives the last step.
std::optional<std::int64_t> last_step_in(const std::filesystem::path& path, const std::string& text,
                                         std::size_t rows) {
  std::istringstream stream(text);
  const CsvDocument document = read_csv(stream, path.string());
  std::optional<std::int64_t> last;
  for (std::size_t n = 0; n < document.table.rows().size(); ++n) {
    const auto* step = std::get_if<std::int64_t>(&document.table.rows()[n].front());
    const bool same = rows != RunLog::any_rows && n % rows != 0;
    if (rows == RunLog::any_rows && last == (step ? std::optional(*step) : std::nullopt)) continue;
    if (!step || (last && (same ? *step != *last : *step <= *last)))
      throw InputError(fmt::format("{}:{}: its step does not rise", path.string(), document.lines[n]));
    last = *step;
  }
  if (rows != RunLog::any_rows && document.table.rows().size() % rows != 0)
    throw InputError(fmt::format("{}: its last step has fewer than {} rows", path.string(), rows));
  return last;
}

}  // namespace

RunLog::RunLog(std::filesystem::path path, std::vector<std::string> columns)
    : path_(std::move(path)), columns_(std::move(columns)) {
  file_ = ::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (file_ < 0) throw OutputError(path_, std::strerror(errno));
}

RunLog::RunLog(const std::filesystem::path& path, const Table& empty, const Provenance& provenance)
    : RunLog((replace_file(path, to_csv(empty, provenance)), path), empty.columns()) {}

RunLog RunLog::resume(const std::filesystem::path& path, const Table& empty, const Provenance& provenance,
                      std::int64_t last_step, std::size_t rows) {
  if (!std::filesystem::exists(path)) return RunLog(path, empty, provenance);
  const std::string text = kept(path, content_of(path), header_line(empty), last_step);
  last_step_in(path, text, rows);
  replace_file(path, text);
  return RunLog(path, empty.columns());
}

std::optional<std::int64_t> RunLog::last_step(const std::filesystem::path& path, const Table& empty,
                                              std::int64_t done, std::size_t rows) {
  return last_step_in(path, kept(path, content_of(path), header_line(empty), done), rows);
}

RunLog::RunLog(RunLog&& other) noexcept
    : path_(std::move(other.path_)),
      columns_(std::move(other.columns_)),
      file_(std::exchange(other.file_, -1)) {}

RunLog::~RunLog() {
  if (file_ >= 0) ::close(file_);
}

void RunLog::append(const Table& rows) {
  const Table same = rows.select(columns_);
  const std::string line = to_csv(same, {}).substr(to_csv(Table(columns_), {}).size());
  errno = 0;
  const ssize_t written = ::write(file_, line.data(), line.size());
  if (written == static_cast<ssize_t>(line.size())) return;
  const int reason = written >= 0 ? ENOSPC : errno;
  if (const off_t end = ::lseek(file_, 0, SEEK_END); written > 0 && end >= written) {
    if (::ftruncate(file_, end - written) != 0)
      throw OutputError(path_, std::strerror(errno));  // no half line
  }
  throw OutputError(path_, std::strerror(reason));
}

void RunLog::flush() const {
  if (::fdatasync(file_) != 0) throw OutputError(path_, std::strerror(errno));
}

}  // namespace fiberchain::dem
