#include "dem/record/run_log.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
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

/// The text as far as it belongs to steps up to `last_step`.
std::string kept(const std::filesystem::path& path, const std::string& text, const std::string& header,
                 std::int64_t last_step) {
  const std::size_t at = text.find(header);
  if (at == std::string::npos) throw InputError(path.string() + ": is no log of a run");
  std::size_t end = at + header.size();
  while (true) {
    const std::size_t line_end = text.find('\n', end);
    if (line_end == std::string::npos) return text.substr(0, end);
    const auto step = parse_integer(std::string_view(text).substr(end, text.find(',', end) - end));
    if (!step || *step > last_step) return text.substr(0, end);
    end = line_end + 1;
  }
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
                      std::int64_t last_step) {
  std::ifstream before(path, std::ios::binary);
  if (!before) return RunLog(path, empty, provenance);
  const std::string text{std::istreambuf_iterator<char>(before), {}};
  replace_file(path, kept(path, text, header_line(empty), last_step));
  return RunLog(path, empty.columns());
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
