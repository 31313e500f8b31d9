#include "dem/files/journaled_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <utility>

#include "dem/files/atomic_file.hpp"
#include "dem/files/file_error.hpp"
#include "dem/files/sha256.hpp"

namespace fiberchain::dem {
namespace {

constexpr std::string_view kJournal = "fiberchain journal 1\n";

std::string number(std::uint64_t value) { return {reinterpret_cast<const char*>(&value), sizeof value}; }

std::uint64_t number_at(std::string_view bytes, std::size_t at) {
  std::uint64_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// What the journal says, without its head and its checksum; "" if there is none or it is no whole journal.
std::string journal_content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string all{std::istreambuf_iterator<char>(file), {}};
  if (all.size() < kJournal.size() + 64 || !all.starts_with(kJournal)) return "";
  std::string content = all.substr(kJournal.size() + 64);
  return sha256(content) == all.substr(kJournal.size(), 64) ? content : "";
}

/// The head of the file that a journal's content is of: its first page is always among those changed.
std::optional<FileHead> head_in(const std::string& journal) {
  constexpr std::size_t first_page = 16;
  if (journal.size() < first_page + FileHead::kBytes || number_at(journal, 8) != 0) return std::nullopt;
  return parse_head(std::string_view(journal).substr(first_page, FileHead::kBytes));
}

/// Waits for a lock of the whole file, but not for long: a program that was stopped with it stops nobody.
void lock(int file, int kind, std::chrono::milliseconds patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (::flock(file, kind | LOCK_NB) != 0 && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// Writes all bytes at their place; 0 or errno.
int write_all(int file, std::uint64_t at, const char* bytes, std::uint64_t count) {
  while (count > 0) {
    const ssize_t written = ::pwrite(file, bytes, count, static_cast<off_t>(at));
    if (written < 0 && errno != EINTR) return errno;
    if (written <= 0) continue;
    at += static_cast<std::uint64_t>(written);
    bytes += written;
    count -= static_cast<std::uint64_t>(written);
  }
  return 0;
}

}  // namespace

std::filesystem::path journal_of(const std::filesystem::path& path) {
  return path.parent_path() / ("." + path.filename().string() + ".journal");
}

JournaledFile::JournaledFile(std::filesystem::path path, Mode mode) : path_(std::move(path)), mode_(mode) {
  head_.id = new_file_id();
  if (mode_ == Mode::create) return;
  open();
  try {
    if (mode_ == Mode::read) lock(file_, LOCK_SH, std::chrono::seconds(2));
    load();
  } catch (...) {
    ::close(file_);
    throw;
  }
}

JournaledFile::~JournaledFile() {
  if (file_ >= 0) ::close(file_);
}

void JournaledFile::open() {
  file_ = ::open(path_.c_str(), (mode_ == Mode::read ? O_RDONLY : O_RDWR) | O_CLOEXEC);
  struct stat facts {};
  if (file_ < 0 || ::fstat(file_, &facts) != 0) {
    const int reason = errno;
    if (file_ >= 0) ::close(std::exchange(file_, -1));
    throw ReadError(path_, std::string("cannot open this file: ") + std::strerror(reason));
  }
  if (!S_ISREG(facts.st_mode)) {
    ::close(std::exchange(file_, -1));
    throw ReadError(path_, "is no regular file");
  }
  old_size_ = size_ = static_cast<std::uint64_t>(facts.st_size);
}

std::optional<FileHead> JournaledFile::head_on_disk() const {
  std::string bytes(FileHead::kBytes, '\0');
  if (::pread(file_, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    return std::nullopt;
  return parse_head(bytes);
}

// Without the lock, which is not waited for long, a commit may be seen in its middle: then it is looked
// again.
void JournaledFile::load() {
  std::string fault = try_to_load();
  for (int tries = 0; mode_ == Mode::read && !fault.empty() && tries < 3; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    fault = try_to_load();
  }
  if (!fault.empty()) throw ReadError(path_, fault);
  // what a killed run wrote beyond the end belongs to nobody
  if (mode_ == Mode::change && old_size_ > size_ && ::ftruncate(file_, static_cast<off_t>(size_)) == 0)
    old_size_ = size_;
}

std::string JournaledFile::try_to_load() {
  const auto head = head_on_disk();
  const std::string journal = journal_content(journal_of(path_));
  const auto in_journal = head_in(journal);
  if (in_journal && (!head || head->id == in_journal->id)) {
    head_ = *in_journal;
    take_journal(journal);
  } else if (head) {
    head_ = *head;
    size_ = head->bytes;
    changed_.clear();
  } else {
    return "is no trajectory of fibers of this program, or damaged: its head is not whole";
  }
  struct stat facts {};
  if (::fstat(file_, &facts) != 0) return std::strerror(errno);
  old_size_ = static_cast<std::uint64_t>(facts.st_size);
  return old_size_ >= size_
             ? ""
             : "is cut off: " + std::to_string(old_size_) + " of " + std::to_string(size_) + " bytes";
}

void JournaledFile::take_journal(const std::string& journal) {
  size_ = number_at(journal, 0);
  changed_.clear();
  for (std::size_t at = 8; at + 8 + kPage <= journal.size(); at += 8 + kPage) {
    std::memcpy(changed_[number_at(journal, at)].data(), journal.data() + at + 8, kPage);
  }
}

// A commit puts its journal in place before it changes a page, changes the first page, which holds the head,
// last, and removes the journal then.
bool JournaledFile::changed() const {
  const auto in_journal = head_in(journal_content(journal_of(path_)));
  if (in_journal && in_journal->id == head_.id) return *in_journal != head_;
  return head_on_disk() != head_;
}

void JournaledFile::set_head() {
  ++head_.commits;
  head_.bytes = size_;
  const std::string text = text_of(head_);
  write(0, text.data(), text.size());
}

void JournaledFile::fill(std::uint64_t page, Page& content) const {
  content.fill(0);
  if (file_ < 0) return;
  for (std::uint64_t done = 0; done < kPage;) {
    const ssize_t got =
        ::pread(file_, content.data() + done, kPage - done, static_cast<off_t>(page * kPage + done));
    if (got < 0 && errno != EINTR) throw ReadError(path_, std::strerror(errno));
    if (got == 0) return;
    if (got > 0) done += static_cast<std::uint64_t>(got);
  }
}

void JournaledFile::read(std::uint64_t at, void* bytes, std::size_t count) const {
  auto* to = static_cast<char*>(bytes);
  Page unchanged;
  while (count > 0) {
    const std::uint64_t page = at / kPage, offset = at % kPage;
    const std::size_t part = std::min<std::size_t>(count, kPage - offset);
    const auto found = changed_.find(page);
    if (found == changed_.end()) fill(page, unchanged);
    std::memcpy(to, (found == changed_.end() ? unchanged : found->second).data() + offset, part);
    at += part;
    to += part;
    count -= part;
  }
}

void JournaledFile::write(std::uint64_t at, const void* bytes, std::size_t count) {
  const auto* from = static_cast<const char*>(bytes);
  size_ = std::max(size_, at + count);
  while (count > 0) {
    const std::uint64_t page = at / kPage, offset = at % kPage;
    const std::size_t part = std::min<std::size_t>(count, kPage - offset);
    const auto [found, made] = changed_.try_emplace(page);
    if (made && part < kPage) fill(page, found->second);
    std::memcpy(found->second.data() + offset, from, part);
    at += part;
    from += part;
    count -= part;
  }
}

void JournaledFile::resize(std::uint64_t size) {
  size_ = size;
  changed_.erase(changed_.lower_bound((size + kPage - 1) / kPage), changed_.end());
}

std::uint64_t JournaledFile::bytes_of(std::uint64_t page) const {
  return std::min(kPage, size_ - page * kPage);
}

void JournaledFile::commit() {
  set_head();
  if (file_ < 0) {
    create_whole();
  } else {
    write_beyond();
    try {
      write_journal();
    } catch (...) {
      // room for the next try, and no bytes the file does not count
      if (size_ > old_size_ && ::ftruncate(file_, static_cast<off_t>(old_size_)) != 0) throw;
      throw;
    }
    write_within();
  }
  old_size_ = size_;
  changed_.clear();
}

void JournaledFile::create_whole() {
  std::string content(size_, '\0');
  for (const auto& [page, bytes] : changed_)
    std::memcpy(content.data() + page * kPage, bytes.data(), bytes_of(page));
  replace_file(path_, content);
  ::unlink(journal_of(path_).c_str());  // of another file that stood here
  mode_ = Mode::change;
  open();
}

void JournaledFile::put(std::uint64_t page, const Page& content) const {
  const int failed = write_all(file_, page * kPage, content.data(), bytes_of(page));
  if (failed) throw WriteError(path_, std::strerror(failed));
}

/// Pages that follow each other are written together.
void JournaledFile::put(Pages::const_iterator from, Pages::const_iterator to) const {
  constexpr std::size_t most = 64 * kPage;
  std::string together;
  together.reserve(most);
  while (from != to) {
    const std::uint64_t begin = from->first * kPage;
    together.clear();
    do {
      together.append(from->second.data(), bytes_of(from->first));
      ++from;
    } while (from != to && from->first * kPage == begin + together.size() && together.size() < most);
    const int failed = write_all(file_, begin, together.data(), together.size());
    if (failed) throw WriteError(path_, std::strerror(failed));
  }
}

void JournaledFile::write_beyond() {
  try {
    put(changed_.lower_bound((old_size_ + kPage - 1) / kPage), changed_.end());
    if (size_ > old_size_ && ::ftruncate(file_, static_cast<off_t>(size_)) != 0)
      throw WriteError(path_, std::strerror(errno));
    if (::fdatasync(file_) != 0) throw WriteError(path_, std::strerror(errno));
  } catch (const WriteError&) {
    if (::ftruncate(file_, static_cast<off_t>(old_size_)) != 0) throw;
    throw;
  }
}

void JournaledFile::write_journal() const {
  std::string content = number(size_);
  for (const auto& [page, bytes] : changed_) {  // the first page first, which holds the head
    if (page * kPage >= old_size_) break;
    content += number(page);
    content.append(bytes.data(), kPage);
  }
  replace_file(journal_of(path_), std::string(kJournal) + sha256(content) + content);
}

void JournaledFile::write_within() {
  lock(file_, LOCK_EX, std::chrono::seconds(1));
  for (auto at = std::next(changed_.begin()); at != changed_.end() && at->first * kPage < old_size_; ++at)
    put(at->first, at->second);
  put(0, changed_.at(0));
  if (size_ < old_size_ && ::ftruncate(file_, static_cast<off_t>(size_)) != 0)
    throw WriteError(path_, std::strerror(errno));
  if (::fdatasync(file_) != 0) throw WriteError(path_, std::strerror(errno));
  ::unlink(journal_of(path_).c_str());
  ::flock(file_, LOCK_UN);
}

}  // namespace fiberchain::dem
