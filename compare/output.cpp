#include "compare/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

#include "compare/errors.hpp"

namespace fiberchain::compare {
namespace {

/// A file under a temporary name, removed unless it was renamed to its place.
class StagedFile {
 public:
  StagedFile(std::filesystem::path place, const std::string& content)
      : place_(std::move(place)),
        staged_(place_.parent_path() / fmt::format(".{}.{}.part", place_.filename().string(), ::getpid())) {
    ::unlink(staged_.c_str());  // left by a killed run of the same process id
    file_ = ::open(staged_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file_ < 0) fail();
    try {
      fill(content);
    } catch (...) {
      discard();
      throw;
    }
  }
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;
  ~StagedFile() { discard(); }

  void take_place() {
    if (::rename(staged_.c_str(), place_.c_str()) != 0) fail();
    staged_.clear();
  }

 private:
  void fill(const std::string& content) {
    for (std::size_t done = 0; done < content.size();) {
      const ssize_t written = ::write(file_, content.data() + done, content.size() - done);
      if (written < 0 && errno != EINTR) fail();
      if (written > 0) done += static_cast<std::size_t>(written);
    }
    if (::fsync(file_) != 0) fail();
    if (::close(std::exchange(file_, -1)) != 0) fail();
  }

  void discard() noexcept {
    if (file_ >= 0) ::close(std::exchange(file_, -1));
    if (!staged_.empty()) ::unlink(staged_.c_str());
  }

  [[noreturn]] void fail() const { throw OutputError(place_.string(), std::strerror(errno)); }

  std::filesystem::path place_;
  std::filesystem::path staged_;
  int file_ = -1;
};

/// Flushes the renames in a directory to the disk. File systems that cannot do that are let off.
void flush_directory(const std::filesystem::path& path) {
  const int directory = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (directory < 0) return;
  ::fsync(directory);
  ::close(directory);
}

}  // namespace

OutputDirectory::OutputDirectory(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (!error && !std::filesystem::is_directory(path_))
    error = std::make_error_code(std::errc::not_a_directory);
  if (error) throw OutputError(path_.string(), error.message());
  StagedFile probe(path_ / "probe", "");  // the one sure way to know that files can be made here
}

void OutputDirectory::write(const std::vector<OutputFile>& files) const {
  std::vector<std::unique_ptr<StagedFile>> staged;
  for (const OutputFile& file : files) {
    staged.push_back(std::make_unique<StagedFile>(path_ / file.name, file.content));
  }
  for (const auto& file : staged) file->take_place();
  flush_directory(path_);
}

}  // namespace fiberchain::compare
