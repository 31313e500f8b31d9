#include "dem/files/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "dem/files/file_error.hpp"

namespace fiberchain::dem {
namespace {

std::filesystem::path staged_name(const std::filesystem::path& place) {
  return place.parent_path() / ("." + place.filename().string() + "." + std::to_string(::getpid()) + ".part");
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path place) : place_(std::move(place)), staged_(staged_name(place_)) {
  ::unlink(staged_.c_str());  // left by a killed run of the same process id
  file_ = ::open(staged_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file_ < 0) fail();
}

AtomicFile::AtomicFile(std::filesystem::path place, std::string_view content) : AtomicFile(std::move(place)) {
  fill(content);
  close();
}

AtomicFile::~AtomicFile() { discard(); }

void AtomicFile::take_place() {
  if (::rename(staged_.c_str(), place_.c_str()) != 0) fail();
  staged_.clear();
}

void AtomicFile::fill(std::string_view content) {
  for (std::size_t done = 0; done < content.size();) {
    const ssize_t written = ::write(file_, content.data() + done, content.size() - done);
    if (written < 0 && errno != EINTR) fail();
    if (written > 0) done += static_cast<std::size_t>(written);
  }
}

void AtomicFile::close() {
  if (::fsync(file_) != 0) fail();
  if (::close(std::exchange(file_, -1)) != 0) fail();
}

void AtomicFile::discard() noexcept {
  if (file_ >= 0) ::close(std::exchange(file_, -1));
  if (!staged_.empty()) ::unlink(staged_.c_str());
}

void AtomicFile::fail() const { throw WriteError(place_, std::strerror(errno)); }

void remove_staged(const std::filesystem::path& directory, const std::string& name) {
  std::error_code ignored;  // a directory that is not there holds none
  for (const auto& entry : std::filesystem::directory_iterator(directory, ignored)) {
    const std::string file = entry.path().filename().string();
    const bool own = file.starts_with("." + name) ||
                     file.starts_with(".." + name);  // the journal's begins with a dot itself
    if (own && file.ends_with(".part")) ::unlink(entry.path().c_str());
  }
}

void flush_directory(const std::filesystem::path& path) {
  const int directory = ::open(path.empty() ? "." : path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (directory < 0) return;
  ::fsync(directory);
  ::close(directory);
}

void replace_file(const std::filesystem::path& place, std::string_view content) {
  AtomicFile file(place, content);
  file.take_place();
  flush_directory(place.parent_path());
}

}  // namespace fiberchain::dem
