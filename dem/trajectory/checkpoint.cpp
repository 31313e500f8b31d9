#include "dem/trajectory/checkpoint.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "dem/files/atomic_file.hpp"
#include "dem/files/file_error.hpp"
#include "dem/files/numbers.hpp"
#include "dem/files/sha256.hpp"
#include "dem/trajectory/hdf5.hpp"

namespace fiberchain::dem {
namespace {

using hdf5::Handle;

constexpr std::string_view kMagic = "fiberchain checkpoint ";
/// 1: the state as one array without names; 2: a dataset for every field of the state.
constexpr int kFormat = 2;
constexpr const char *kState = "state", *kVersion = "version";
constexpr std::size_t kHead = 512;  ///< HDF5 looks for itself at 0, 512, 1024 ...

std::string head_of(const std::string& image) {
  std::string head = fmt::format("{}{}\nsha256 {}\nbytes {}\n", kMagic, kFormat, sha256(image), image.size());
  head.resize(kHead, '\0');
  return head;
}

/// Access to an HDF5 file in memory.
Handle in_memory() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose, "make a property list");
  hdf5::check(H5Pset_fapl_core(access, 1 << 20, false), "work in memory");
  return access;
}

void set_number(hid_t file, const char* name, hid_t memory, hid_t stored, const void* value) {
  hdf5::write_array(file, name, {memory, stored}, {1}, value, false);
}

hdf5::Stored type_of(const std::vector<double>&) { return {H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE}; }
hdf5::Stored type_of(const std::vector<std::int64_t>&) { return {H5T_NATIVE_INT64, H5T_STD_I64LE}; }

/// A dataset a field, of reals or integers, with its version.
void write_state(hid_t file, const SavedState& state) {
  const Handle group = hdf5::make_group(file, kState);
  for (const auto& [name, field] : state) {
    const Handle dataset = std::visit(
        [&](const auto& numbers) {
          return hdf5::write_array(group, name.c_str(), type_of(numbers), {numbers.size()}, numbers.data(),
                                   false);
        },
        field.values);
    hdf5::set_attribute(dataset, kVersion, std::vector<std::int32_t>{field.version});
  }
}

std::string image_of(const Checkpoint& checkpoint) {
  const Handle file(H5Fcreate("checkpoint", H5F_ACC_TRUNC, H5P_DEFAULT, in_memory()), &H5Fclose,
                    "make a file");
  hdf5::set_attribute(file, "program", checkpoint.program);
  hdf5::set_attribute(file, "scene_sha256", checkpoint.scene_sha256);
  const std::vector<char> scene(checkpoint.scene.begin(), checkpoint.scene.end());
  hdf5::write_array(file, "scene", {H5T_NATIVE_UCHAR, H5T_STD_U8LE}, {scene.size()}, scene.data(), false);
  const std::int64_t threads = checkpoint.threads;
  set_number(file, "threads", H5T_NATIVE_INT64, H5T_STD_I64LE, &threads);
  set_number(file, "step", H5T_NATIVE_INT64, H5T_STD_I64LE, &checkpoint.step);
  set_number(file, "time", H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE, &checkpoint.time);
  hdf5::write_array(file, "inserted", type_of(checkpoint.inserted), {checkpoint.inserted.size()},
                    checkpoint.inserted.data(), false);
  write_state(file, checkpoint.state);
  hdf5::flush(file);
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  std::string image(static_cast<std::size_t>(std::max<ssize_t>(size, 0)), '\0');
  if (size <= 0 || H5Fget_file_image(file, image.data(), image.size()) != size)
    throw hdf5::Failure("HDF5 gives no image");
  return image;
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

Checkpoint checkpoint_in(std::string& image) {
  const Handle access = in_memory();
  hdf5::check(H5Pset_file_image(access, image.data(), image.size()), "take the image");
  const Handle file(H5Fopen("checkpoint", H5F_ACC_RDONLY, access), &H5Fclose, "open the image");
  Checkpoint checkpoint;
  checkpoint.program = hdf5::text_attribute(file, "program").value_or("");
  checkpoint.scene_sha256 = hdf5::text_attribute(file, "scene_sha256").value_or("");
  const auto scene = array<char>(file, "scene", H5T_NATIVE_UCHAR);
  checkpoint.scene.assign(scene.begin(), scene.end());
  checkpoint.threads = static_cast<int>(number<std::int64_t>(file, "threads", H5T_NATIVE_INT64));
  checkpoint.step = number<std::int64_t>(file, "step", H5T_NATIVE_INT64);
  checkpoint.time = number<double>(file, "time", H5T_NATIVE_DOUBLE);
  checkpoint.state = state_in(file);
  checkpoint.inserted = array<std::int64_t>(file, "inserted", H5T_NATIVE_INT64);
  return checkpoint;
}

/// The rest of the line that begins with this word in the head; "" if there is none.
std::string_view line_of(std::string_view head, std::string_view word) {
  const std::size_t at = head.find(word);
  if (at == std::string_view::npos) return "";
  const std::size_t from = at + word.size(), end = head.find('\n', from);
  return end == std::string_view::npos ? "" : head.substr(from, end - from);
}

/// The image behind the head, checked.
std::string checked_image(const std::filesystem::path& path, const std::string& content) {
  const std::string_view head = std::string_view(content).substr(0, kHead);
  if (!head.starts_with(kMagic)) throw ReadError(path, "is no checkpoint");
  const auto format = parse_integer(line_of(head, kMagic));
  if (!format) throw ReadError(path, "is corrupt: no format");
  if (*format < kFormat)
    throw ReadError(
        path,
        fmt::format("is a checkpoint of the old format {}, whose state has no named fields; this program "
                    "reads format {}",
                    *format, kFormat));
  if (*format != kFormat)
    throw ReadError(
        path, fmt::format("is a checkpoint of format {}; this program reads format {}", *format, kFormat));
  const auto size = parse_integer(line_of(head, "\nbytes "));
  if (!size)
    throw ReadError(path, content.size() < kHead ? "is cut off within its head" : "is corrupt: no size");
  const auto bytes = static_cast<std::int64_t>(content.size() - std::min(content.size(), kHead));
  if (bytes < *size) throw ReadError(path, fmt::format("is cut off: {} of {} bytes", bytes, *size));
  std::string image = content.substr(kHead);
  if (head_of(image) != head) throw ReadError(path, "is corrupt: its checksum is not that of its content");
  return image;
}

std::string content_of(const std::filesystem::path& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ReadError(path, fmt::format("cannot open this checkpoint: {}", std::strerror(errno)));
  if (std::filesystem::is_directory(path)) throw ReadError(path, "is a directory, not a checkpoint");
  return {std::istreambuf_iterator<char>(file), {}};
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

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  const hdf5::Quiet quiet;
  std::string content;
  try {
    const std::string image = image_of(checkpoint);
    content = head_of(image) + image;
  } catch (const hdf5::Failure& failure) {
    throw WriteError(path, failure.what());
  }
  AtomicFile file(path, content);
  keep_as(path, previous_checkpoint(path));
  file.take_place();
  flush_directory(path.parent_path());
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
  const hdf5::Quiet quiet;
  std::string image = checked_image(path, content_of(path));
  try {
    return checkpoint_in(image);
  } catch (const hdf5::Failure& failure) {
    throw ReadError(path, fmt::format("is no checkpoint of this program: {}", failure.what()));
  }
}

Checkpoint read_checkpoint(const std::filesystem::path& path, const std::string& scene_sha256) {
  Checkpoint checkpoint = read_checkpoint(path);
  if (checkpoint.scene_sha256 != scene_sha256) {
    throw ReadError(path, fmt::format("belongs to another scene (SHA-256 {:.12}..., not {:.12}...)",
                                      checkpoint.scene_sha256, scene_sha256));
  }
  return checkpoint;
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
