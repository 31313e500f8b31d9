#include "dem/trajectory/checkpoint.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "dem/files/atomic_file.hpp"
#include "dem/files/file_error.hpp"
#include "dem/files/numbers.hpp"
#include "dem/files/sha256.hpp"
#include "dem/trajectory/hdf5.hpp"

namespace fiberchain::dem {
namespace {

using hdf5::Handle;

constexpr std::string_view kMagic = "fiberchain checkpoint ";
/// 1: the state as one array without names; 2: a dataset for every field of the state; 3: the scene's keys
/// and what its groups are, beside it.
constexpr int kFormat = 3;
constexpr const char *kState = "state", *kVersion = "version";
constexpr std::size_t kHead = 512;  ///< HDF5 looks for itself at 0, 512, 1024 ...

std::string head_of(const std::string& sum, std::uint64_t bytes) {
  std::string head = fmt::format("{}{}\nsha256 {}\nbytes {}\n", kMagic, kFormat, sum, bytes);
  head.resize(kHead, '\0');
  return head;
}

/// Access to a file that nobody else has: locks, which not all file systems have, are not needed.
Handle plain_access() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose, "make a property list");
#if H5_VERSION_GE(1, 10, 7)
  hdf5::check(H5Pset_file_locking(access, false, true), "do without locks");
#endif
  return access;
}

/// Behind a head.
Handle create_behind_head(const std::filesystem::path& path) {
  const Handle properties(H5Pcreate(H5P_FILE_CREATE), &H5Pclose, "make a property list");
  hdf5::check(H5Pset_userblock(properties, kHead), "leave room for the head");
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, properties, plain_access()), &H5Fclose, "make a file"};
}

void set_number(hid_t file, const char* name, hid_t memory, hid_t stored, const void* value) {
  hdf5::write_array(file, name, {memory, stored}, {1}, value, false);
}

hdf5::Stored type_of(const std::vector<double>&) { return {H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE}; }
hdf5::Stored type_of(const std::vector<std::int64_t>&) { return {H5T_NATIVE_INT64, H5T_STD_I64LE}; }

/// A dataset of reals or integers, with its version.
void write_field(hid_t group, std::string_view name, const StateField& field) {
  const Handle dataset = std::visit(
      [&](const auto& numbers) {
        return hdf5::write_array(group, std::string(name).c_str(), type_of(numbers), {numbers.size()},
                                 numbers.data(), false);
      },
      field.values);
  hdf5::set_attribute(dataset, kVersion, std::vector<std::int32_t>{field.version});
}

void write_content(const std::filesystem::path& path, const Checkpoint& head, const EachField& fields) {
  const Handle file = create_behind_head(path);
  hdf5::set_attribute(file, "program", head.program);
  hdf5::set_attribute(file, "scene_sha256", head.scene_sha256);
  const auto write_text = [&](const char* name, const std::string& text) {
    hdf5::write_array(file, name, {H5T_NATIVE_UCHAR, H5T_STD_U8LE}, {text.size()}, text.data(), false);
  };
  const auto write_numbers = [&](const char* name, const std::vector<std::int64_t>& all) {
    hdf5::write_array(file, name, type_of(all), {all.size()}, all.data(), false);
  };
  write_text("scene", head.scene);
  write_text("keys", head.keys);
  const std::int64_t threads = head.threads;
  set_number(file, "threads", H5T_NATIVE_INT64, H5T_STD_I64LE, &threads);
  set_number(file, "step", H5T_NATIVE_INT64, H5T_STD_I64LE, &head.step);
  set_number(file, "time", H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE, &head.time);
  write_numbers("inserted", head.inserted);
  write_numbers("kinds", head.kinds);
  write_numbers("carried", head.carried);
  set_number(file, "batches_done", H5T_NATIVE_INT64, H5T_STD_I64LE, &head.batches_done);
  write_numbers("written", {head.written.log, head.written.trajectory, head.written.vtk});
  const Handle group = hdf5::make_group(file, kState);
  fields([&](std::string_view name, const StateField& field) { write_field(group, name, field); });
  hdf5::flush(file);
}

/// use(bytes) with what stands behind the head, piece by piece; how much that was.
/// @throws ReadError
template <class Use>
std::uint64_t each_piece(int file, const std::filesystem::path& path, const Use& use) {
  std::vector<char> piece(256 * 1024);
  std::uint64_t bytes = 0;
  while (true) {
    const ssize_t count = ::pread(file, piece.data(), piece.size(), static_cast<off_t>(kHead + bytes));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw ReadError(path, std::strerror(errno));
    if (count == 0) return bytes;
    use(std::string_view(piece.data(), static_cast<std::size_t>(count)));
    bytes += static_cast<std::uint64_t>(count);
  }
}

/// The head that goes with what stands behind it.
std::string head_for(int file, const std::filesystem::path& path) {
  Sha256 sum;
  const std::uint64_t bytes = each_piece(file, path, [&](std::string_view piece) { sum.add(piece); });
  return head_of(sum.hex(), bytes);
}

template <class Number>
std::vector<Number> array(hid_t file, const char* name, hid_t type) {
  const Handle found = hdf5::open_array(file, name);
  const std::vector<hsize_t> size = hdf5::size_of(found);
  std::vector<Number> all(size.size() == 1 ? size[0] : 0);
  if (!all.empty()) hdf5::check(H5Dread(found, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()), name);
  return all;
}

template <class Number>
Number number(hid_t file, const char* name, hid_t type) {
  const auto all = array<Number>(file, name, type);
  if (all.size() != 1) throw hdf5::Failure(fmt::format("{} is no single number", name));
  return all.front();
}

std::string text_in(hid_t file, const char* name) {
  const auto bytes = array<char>(file, name, H5T_NATIVE_UCHAR);
  return {bytes.begin(), bytes.end()};
}

StateField field_in(hid_t group, const char* name) {
  const Handle dataset = hdf5::open_array(group, name);
  const auto version = hdf5::integer_attribute(dataset, kVersion);
  if (!version) throw hdf5::Failure(fmt::format("field '{}' of the state has no version", name));
  const Handle type(H5Dget_type(dataset), &H5Tclose, "find a dataset's type");
  switch (H5Tget_class(type)) {
    case H5T_FLOAT:
      return {*version, array<double>(group, name, H5T_NATIVE_DOUBLE)};
    case H5T_INTEGER:
      return {*version, array<std::int64_t>(group, name, H5T_NATIVE_INT64)};
    default:
      throw hdf5::Failure(fmt::format("field '{}' of the state holds no numbers", name));
  }
}

SavedState state_in(hid_t file) {
  if (!hdf5::is_group(file, kState)) throw hdf5::Failure("its state is not stored by named fields");
  const Handle group = hdf5::open_group(file, kState);
  SavedState state;
  for (const std::string& name : hdf5::names_in(group)) state.emplace(name, field_in(group, name.c_str()));
  return state;
}

Checkpoint checkpoint_in(const std::filesystem::path& path) {
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, plain_access()), &H5Fclose, "open the file");
  Checkpoint checkpoint;
  checkpoint.program = hdf5::text_attribute(file, "program").value_or("");
  checkpoint.scene_sha256 = hdf5::text_attribute(file, "scene_sha256").value_or("");
  checkpoint.scene = text_in(file, "scene");
  checkpoint.keys = text_in(file, "keys");
  checkpoint.threads = static_cast<int>(number<std::int64_t>(file, "threads", H5T_NATIVE_INT64));
  checkpoint.step = number<std::int64_t>(file, "step", H5T_NATIVE_INT64);
  checkpoint.time = number<double>(file, "time", H5T_NATIVE_DOUBLE);
  checkpoint.state = state_in(file);
  const auto numbers = [&](const char* name) { return array<std::int64_t>(file, name, H5T_NATIVE_INT64); };
  checkpoint.inserted = numbers("inserted");
  checkpoint.kinds = numbers("kinds");
  checkpoint.carried = numbers("carried");
  checkpoint.batches_done = number<std::int64_t>(file, "batches_done", H5T_NATIVE_INT64);
  const std::vector<std::int64_t> written = numbers("written");
  if (written.size() != 3) throw hdf5::Failure("written is not three numbers");
  checkpoint.written = {written[0], written[1], written[2]};
  return checkpoint;
}

/// The rest of the line that begins with this word in the head; "" if there is none.
std::string_view line_of(std::string_view head, std::string_view word) {
  const std::size_t at = head.find(word);
  if (at == std::string_view::npos) return "";
  const std::size_t from = at + word.size(), end = head.find('\n', from);
  return end == std::string_view::npos ? "" : head.substr(from, end - from);
}

/// A file open for reading.
class ReadFile {
 public:
  explicit ReadFile(const std::filesystem::path& path) : file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (file_ < 0)
      throw ReadError(path, fmt::format("cannot open this checkpoint: {}", std::strerror(errno)));
  }
  ReadFile(const ReadFile&) = delete;
  ReadFile& operator=(const ReadFile&) = delete;
  ~ReadFile() { ::close(file_); }
  operator int() const { return file_; }

 private:
  int file_;
};

/// Refuses what is not whole.
void check_content(const std::filesystem::path& path) {
  const ReadFile file(path);
  if (std::filesystem::is_directory(path)) throw ReadError(path, "is a directory, not a checkpoint");
  std::string head(kHead, '\0');
  const ssize_t there = ::pread(file, head.data(), kHead, 0);
  if (there < 0) throw ReadError(path, std::strerror(errno));
  head.resize(static_cast<std::size_t>(there));
  if (!head.starts_with(kMagic)) throw ReadError(path, "is no checkpoint");
  const auto format = parse_integer(line_of(head, kMagic));
  if (!format) throw ReadError(path, "is corrupt: no format");
  if (*format < kFormat)
    throw ReadError(
        path,
        fmt::format("is a checkpoint of the old format {}, which does not say what its scene means; this "
                    "program reads format {}",
                    *format, kFormat));
  if (*format != kFormat)
    throw ReadError(
        path, fmt::format("is a checkpoint of format {}; this program reads format {}", *format, kFormat));
  const auto size = parse_integer(line_of(head, "\nbytes "));
  if (!size)
    throw ReadError(path, head.size() < kHead ? "is cut off within its head" : "is corrupt: no size");
  Sha256 sum;
  const auto bytes =
      static_cast<std::int64_t>(each_piece(file, path, [&](std::string_view piece) { sum.add(piece); }));
  if (bytes < *size) throw ReadError(path, fmt::format("is cut off: {} of {} bytes", bytes, *size));
  if (head_of(sum.hex(), static_cast<std::uint64_t>(bytes)) != head)
    throw ReadError(path, "is corrupt: its checksum is not that of its content");
}

/// Gives the file a second name, in place of what had it; on a file system without such, that name alone: who
/// looks for the file finds the previous one then.
void keep_as(const std::filesystem::path& path, const std::filesystem::path& previous) {
  const std::filesystem::path linked = previous.string() + ".part";
  ::unlink(linked.c_str());
  if (::link(path.c_str(), linked.c_str()) != 0) {
    if (errno == ENOENT) return;
    const bool no_second_names = errno == EPERM || errno == ENOTSUP || errno == EOPNOTSUPP || errno == EMLINK;
    if (no_second_names && ::rename(path.c_str(), previous.c_str()) == 0) return;
    throw WriteError(previous, std::strerror(errno));
  }
  if (::rename(linked.c_str(), previous.c_str()) != 0) throw WriteError(previous, std::strerror(errno));
  ::unlink(linked.c_str());  // rename does nothing if both are the same file
}

}  // namespace

std::filesystem::path previous_checkpoint(const std::filesystem::path& path) {
  return path.string() + ".previous";
}

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& head, const EachField& fields) {
  const hdf5::Quiet quiet;
  AtomicFile file(path);
  errno = 0;
  try {
    write_content(file.staged(), head, fields);
    const std::string text = head_for(file.descriptor(), path);
    if (::pwrite(file.descriptor(), text.data(), kHead, 0) != static_cast<ssize_t>(kHead))
      throw WriteError(path, std::strerror(errno));
  } catch (const hdf5::Failure& failure) {  // the system's reason where it is one
    throw WriteError(path, errno != 0 ? std::strerror(errno) : failure.what());
  }
  file.close();
  keep_as(path, previous_checkpoint(path));
  file.take_place();
  flush_directory(path.parent_path());
}

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  write_checkpoint(path, checkpoint, [&](const UseField& use) {
    for (const auto& [name, field] : checkpoint.state) use(name, field);
  });
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
  const hdf5::Quiet quiet;
  check_content(path);
  try {
    return checkpoint_in(path);
  } catch (const hdf5::Failure& failure) {
    throw ReadError(path, fmt::format("is no checkpoint of this program: {}", failure.what()));
  }
}

std::string resumed_differently(const Checkpoint& checkpoint, const std::string& program, int threads) {
  if (checkpoint.program != program)
    return fmt::format("the checkpoint was written by another program ({}, not {})", checkpoint.program,
                       program);
  if (checkpoint.threads != threads)
    return fmt::format("the checkpoint was written by a run of {} threads, not {}", checkpoint.threads,
                       threads);
  return "";
}

}  // namespace fiberchain::dem
