#include "dem/trajectory/h5md_contacts.hpp"

#include <fmt/format.h>

#include <array>
#include <numeric>
#include <string>
#include <vector>

#include "dem/trajectory/h5md_layout.hpp"

namespace fiberchain::dem::h5md {
namespace {

using hdf5::Handle;

constexpr hsize_t kRows = 1024;  ///< of a chunk
constexpr const char* kVectors[] = {"point", "normal", "force"};

std::string contact_array(const char* name) { return std::string(kContacts) + "/" + name; }

/// A vector of a contact by its place in kVectors.
Vec<double, 3>& vector_of(FrameContact& contact, int n) {
  return n == 0 ? contact.point : n == 1 ? contact.normal : contact.force;
}

/// Rows of each frame, at least 0, up to before `frames`.
hsize_t rows_before(hid_t file, hsize_t frames) {
  const Handle series = hdf5::open_array(file, value_of(kContactCount).c_str());
  const std::vector<hsize_t> size = hdf5::size_of(series);
  if (size.size() != 1 || size[0] < frames) throw hdf5::Failure("numbers of contacts are missing");
  std::vector<std::int64_t> counts(size[0]);
  if (size[0] == 0) return 0;
  hdf5::check(H5Dread(series, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, counts.data()),
              "read numbers of contacts");
  hsize_t sum = 0;
  for (hsize_t n = 0; n < frames; ++n) sum += static_cast<hsize_t>(std::max<std::int64_t>(counts[n], 0));
  return sum;
}

void write_count(hid_t file, hsize_t n, std::int64_t count) {
  hdf5::write_entry(hdf5::open_array(file, value_of(kContactCount).c_str()), n, H5T_NATIVE_INT64, &count);
}

/// Appends rows to an array of them.
void append(hid_t file, const char* name, hid_t type, const void* values, hsize_t count) {
  const Handle array = hdf5::open_array(file, contact_array(name).c_str());
  const hsize_t first = hdf5::size_of(array)[0];
  hdf5::resize_series(array, first + count);
  hdf5::write_rows(array, first, count, type, values);
}

template <class Number>
std::vector<Number> rows(hid_t file, const char* name, hid_t type, hsize_t width, hsize_t first,
                         hsize_t count) {
  const Handle array = hdf5::open_array(file, contact_array(name).c_str());
  const std::vector<hsize_t> size = hdf5::size_of(array);
  if (size.size() != (width > 1 ? 2 : 1) || (width > 1 && size[1] != width) || size[0] < first + count)
    throw hdf5::Failure(fmt::format("{} is of another size", contact_array(name)));
  std::vector<Number> all(width * count);
  hdf5::read_rows(array, first, count, type, all.data());
  return all;
}

}  // namespace

bool has_contacts(hid_t file) { return hdf5::has(file, kContacts); }

void make_contacts(hid_t file, hsize_t frames) {
  const Handle group = hdf5::make_group(file, kContacts);
  hdf5::make_rows(group, "pair", H5T_STD_I64LE, 2, kRows);
  hdf5::make_rows(group, "kind", H5T_STD_I32LE, 1, kRows);
  const Handle point = hdf5::make_rows(group, "point", H5T_IEEE_F64LE, 3, kRows);
  hdf5::set_text_for_python(point, "unit", "m");
  hdf5::make_rows(group, "normal", H5T_IEEE_F32LE, 3, kRows);
  const Handle force = hdf5::make_rows(group, "force", H5T_IEEE_F32LE, 3, kRows);
  hdf5::set_text_for_python(force, "unit", "N");
  make_element(file, kContactCount, H5T_STD_I64LE, {}, "", false);
  hdf5::resize_series(hdf5::open_array(file, value_of(kContactCount).c_str()), frames);
  for (hsize_t n = 0; n < frames; ++n) write_count(file, n, -1);
}

void append_contacts(hid_t file, hsize_t n, const TrajectoryFrame& frame) {
  const hsize_t count = frame.contacts.size();
  write_count(file, n, frame.has_contacts ? static_cast<std::int64_t>(count) : -1);
  if (!frame.has_contacts || count == 0) return;
  std::vector<std::int64_t> pairs;
  std::vector<std::int32_t> kinds;
  for (const FrameContact& contact : frame.contacts) {
    pairs.insert(pairs.end(), {contact.first, contact.second});
    kinds.push_back(static_cast<std::int32_t>(contact.kind));
  }
  append(file, "pair", H5T_NATIVE_INT64, pairs.data(), count);
  append(file, "kind", H5T_NATIVE_INT32, kinds.data(), count);
  std::vector<double> numbers(3 * count);
  for (int v = 0; v < 3; ++v) {
    double* to = numbers.data();
    for (FrameContact contact : frame.contacts) to = std::copy_n(vector_of(contact, v).c, 3, to);
    append(file, kVectors[v], H5T_NATIVE_DOUBLE, numbers.data(), count);
  }
}

void keep_contacts(hid_t file, hsize_t frames) {
  const hsize_t count = rows_before(file, frames);
  for (const char* name : {"pair", "kind", kVectors[0], kVectors[1], kVectors[2]})
    hdf5::resize_series(hdf5::open_array(file, contact_array(name).c_str()), count);
}

void read_contacts(hid_t file, hsize_t n, TrajectoryFrame& frame) {
  std::int64_t known = 0;
  const hsize_t first = rows_before(file, n);
  hdf5::read_entry(hdf5::open_array(file, value_of(kContactCount).c_str()), n, H5T_NATIVE_INT64, &known);
  frame.has_contacts = known >= 0;
  if (known <= 0) return;
  const auto count = static_cast<hsize_t>(known);
  const auto pairs = rows<std::int64_t>(file, "pair", H5T_NATIVE_INT64, 2, first, count);
  const auto kinds = rows<std::int32_t>(file, "kind", H5T_NATIVE_INT32, 1, first, count);
  const auto spheres = static_cast<std::int64_t>(frame.radius.size());
  frame.contacts.resize(count);
  for (hsize_t i = 0; i < count; ++i) {
    if (kinds[i] < 0 || kinds[i] > 2) throw hdf5::Failure("a contact is of an unknown kind");
    FrameContact& contact = frame.contacts[i];
    contact.first = pairs[2 * i], contact.second = pairs[2 * i + 1];
    contact.kind = static_cast<ContactKind>(kinds[i]);
    const bool at_wall = contact.kind == ContactKind::wall;
    if (contact.first < 0 || contact.first >= spheres || contact.second < (at_wall ? 1 : 0) ||
        (!at_wall && contact.second >= spheres))
      throw hdf5::Failure("a contact has no such spheres");
  }
  for (int v = 0; v < 3; ++v) {
    const auto numbers = rows<double>(file, kVectors[v], H5T_NATIVE_DOUBLE, 3, first, count);
    for (hsize_t i = 0; i < count; ++i) std::copy_n(&numbers[3 * i], 3, vector_of(frame.contacts[i], v).c);
  }
}

}  // namespace fiberchain::dem::h5md
