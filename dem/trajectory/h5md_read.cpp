#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include "dem/files/file_error.hpp"
#include "dem/trajectory/h5md_contacts.hpp"
#include "dem/trajectory/h5md_layout.hpp"
#include "dem/trajectory/h5md_walls.hpp"

namespace fiberchain::dem {
namespace {

using namespace h5md;
using hdf5::Handle;

/// What an action finds in the open file, and whether all of it was of one moment; names the file in what
/// goes wrong.
template <class Action>
auto read_once(const std::filesystem::path& path, const Action& action) {
  JournaledFile journaled(path, JournaledFile::Mode::read);
  std::optional<decltype(action(hid_t{}))> found;
  std::string fault;
  try {
    const Handle file = open_in(journaled, Access::read);
    found = action(file);
  } catch (const hdf5::Failure& failure) {
    fault = failure.what();
  }
  if (journaled.changed())
    found.reset();
  else if (!found)
    throw ReadError(path, fmt::format("is no trajectory of fibers, or damaged: {}", fault));
  return found;
}

/// Reads until no run has changed the file meanwhile.
template <class Action>
auto reading_file(const std::filesystem::path& path, const Action& action) {
  const hdf5::Quiet quiet;
  constexpr int tries = 200;
  for (int i = 0; i < tries; ++i) {
    if (auto found = read_once(path, action)) return *std::move(found);
    std::this_thread::sleep_for(std::chrono::milliseconds(5 + i));
  }
  throw ReadError(path, "changes faster than it can be read");
}

/// A dataset, and the number of its elements after the first index where it is a series.
template <class Number>
std::vector<Number> whole(hid_t file, const char* name, hid_t type, std::size_t rank) {
  const Handle array = hdf5::open_array(file, name);
  const std::vector<hsize_t> size = hdf5::size_of(array);
  if (size.size() != rank) throw hdf5::Failure(fmt::format("{} is of another rank", name));
  hsize_t count = 1;
  for (const hsize_t n : size) count *= n;
  std::vector<Number> all(count);
  if (count > 0) hdf5::check(H5Dread(array, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()), name);
  return all;
}

/// One frame of a series whose entries have this size.
std::vector<double> entry(hid_t file, const std::string& element, std::int64_t n, std::vector<hsize_t> size) {
  const std::string name = value_of(element);
  const Handle series = hdf5::open_array(file, name.c_str());
  const std::vector<hsize_t> found = hdf5::size_of(series);
  if (found.empty() || static_cast<std::int64_t>(found[0]) <= n ||
      !std::equal(found.begin() + 1, found.end(), size.begin(), size.end()))
    throw hdf5::Failure(fmt::format("{} is of another size", name));
  hsize_t count = 1;
  for (const hsize_t rows : size) count *= rows;
  std::vector<double> all(count);
  if (count > 0) hdf5::read_entry(series, static_cast<hsize_t>(n), H5T_NATIVE_DOUBLE, all.data());
  return all;
}

std::vector<Vec<double, 3>> vectors(const std::vector<double>& numbers) {
  std::vector<Vec<double, 3>> all;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    all.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  return all;
}

/// "periodic" or "none" for each of three directions.
void read_boundary(hid_t file, TrajectoryFrame& frame) {
  const Handle box = hdf5::open_group(file, "particles/fibers/box");
  const Handle attribute(H5Aopen(box, "boundary", H5P_DEFAULT), &H5Aclose, "find the box's boundary");
  const Handle type(H5Aget_type(attribute), &H5Tclose, "read the box's boundary");
  const Handle space(H5Aget_space(attribute), &H5Sclose, "read the box's boundary");
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0 ||
      H5Sget_simple_extent_npoints(space) != 3)
    throw hdf5::Failure("the box's boundary is no three words");
  const std::size_t length = H5Tget_size(type);
  std::string words(3 * length, '\0');
  hdf5::check(H5Aread(attribute, type, words.data()), "read the box's boundary");
  for (std::size_t i = 0; i < 3; ++i) frame.periodic[i] = words.compare(i * length, 1, "p") == 0;
}

void read_bonds(hid_t file, std::int64_t n, TrajectoryFrame& frame) {
  const auto pairs = whole<std::int64_t>(file, kBonds, H5T_NATIVE_INT64, 2);
  const hsize_t bonds = pairs.size() / 2;
  for (std::size_t i = 0; i < bonds; ++i) {
    const std::int64_t first = pairs[2 * i];
    if (first < 0 || first + 1 >= static_cast<std::int64_t>(frame.radius.size()) ||
        pairs[2 * i + 1] != first + 1)
      throw hdf5::Failure("a bond is between spheres that do not follow each other");
    frame.bonds.push_back({first, {}, 0});
  }
  const bool nested = hdf5::is_group(file, "observables/fibers");  // of an earlier version
  for (const OutputField& field : bond_fields) {
    field.set(frame, entry(file, nested ? nested_bond_element(field) : bond_element(field), n,
                           entry_size(field, bonds)));
  }
}

/// Of a cuboid: a diagonal matrix, of earlier versions its diagonal.
Vec<double, 3> edges_of(hid_t file, std::int64_t n) {
  if (hdf5::size_of(hdf5::open_array(file, value_of(kEdges).c_str())).size() == 2)
    return vectors(entry(file, kEdges, n, {3})).front();
  const auto rows = vectors(entry(file, kEdges, n, {3, 3}));
  return {rows[0][0], rows[1][1], rows[2][2]};
}

}  // namespace

void leave_hdf5_as_it_is_at_exit() { H5dont_atexit(); }

TrajectoryFrame present_part(TrajectoryFrame frame) {
  if (frame.absent == 0 && frame.missing.empty()) return frame;
  std::vector<bool> here(frame.position.size() - static_cast<std::size_t>(frame.absent), true);
  here.resize(frame.position.size(), false);
  for (const std::int64_t sphere : frame.missing) here[static_cast<std::size_t>(sphere)] = false;
  std::vector<std::int64_t> number(here.size());  // of a sphere among those that are here
  std::int64_t count = 0;
  for (std::size_t i = 0; i < here.size(); ++i) {
    number[i] = count;
    count += here[i];
  }
  const auto reduce = [&](auto& rows, std::size_t width) {
    std::size_t to = 0;
    for (std::size_t i = 0; i < here.size(); ++i) {
      for (std::size_t k = 0; here[i] && k < width; ++k) rows[to++] = rows[i * width + k];
    }
    rows.resize(to);
  };
  for (const OutputField& field : sphere_fields) {
    std::vector<double> values = field.values(frame);
    reduce(values, static_cast<std::size_t>(field.width));
    field.set(frame, values);
  }
  reduce(frame.position, 1), reduce(frame.radius, 1), reduce(frame.fiber, 1);
  std::erase_if(frame.bonds,
                [&](const FrameBond& bond) { return !here[static_cast<std::size_t>(bond.first)]; });
  for (FrameBond& bond : frame.bonds) bond.first = number[static_cast<std::size_t>(bond.first)];
  for (FrameContact& contact : frame.contacts) {
    contact.first = number[static_cast<std::size_t>(contact.first)];
    if (contact.kind != ContactKind::wall) contact.second = number[static_cast<std::size_t>(contact.second)];
  }
  frame.absent = 0;
  frame.missing.clear();
  return frame;
}

TrajectoryReader::TrajectoryReader(std::filesystem::path path) : path_(std::move(path)) {
  reading_file(path_, [&](hid_t file) {
    steps_ = whole<std::int64_t>(file, kSteps, H5T_NATIVE_INT64, 1);
    times_ = whole<double>(file, "particles/fibers/position/time", H5T_NATIVE_DOUBLE, 1);
    if (steps_.size() != times_.size()) throw hdf5::Failure("as many steps as times are wanted");
    if (hdf5::has(file, "parameters") && hdf5::has(file, "parameters/runs/0"))
      provenance_ = hdf5::text_attributes(hdf5::open_group(file, "parameters/runs/0"));
    walls_ = read_wall_surfaces(file);
    return true;
  });
}

TrajectoryFrame TrajectoryReader::read(std::int64_t n) const {
  if (n < 0 || n >= frames()) throw ReadError(path_, fmt::format("has no frame {}: it has {}", n, frames()));
  return reading_file(path_, [&](hid_t file) {
    TrajectoryFrame frame{};
    frame.time = times_[static_cast<std::size_t>(n)];
    frame.step = steps_[static_cast<std::size_t>(n)];
    const auto steps = whole<std::int64_t>(file, kSteps, H5T_NATIVE_INT64, 1);
    if (static_cast<std::int64_t>(steps.size()) <= n || steps[static_cast<std::size_t>(n)] != frame.step)
      throw hdf5::Failure(
          fmt::format("frame {} is no more of step {}: another run has begun", n, frame.step));
    frame.radius = whole<double>(file, "particles/fibers/radius", H5T_NATIVE_DOUBLE, 1);
    frame.fiber = whole<std::int32_t>(file, "particles/fibers/fiber", H5T_NATIVE_INT32, 1);
    const hsize_t spheres = frame.radius.size();
    if (frame.fiber.size() != spheres) throw hdf5::Failure("radii and fibers differ in number");
    frame.position = vectors(entry(file, kPosition, n, {spheres, 3}));
    for (const OutputField& field : sphere_fields)
      field.set(frame, entry(file, sphere_element(field), n, entry_size(field, spheres)));
    frame.low = vectors(entry(file, kOrigin, n, {3})).front();
    frame.high = frame.low + edges_of(file, n);
    read_boundary(file, frame);
    read_bonds(file, n, frame);
    if (!walls_.empty()) set_poses(entry(file, kWallPoses, n, {walls_.size(), wall_pose_size}), frame);
    if (has_contacts(file)) read_contacts(file, static_cast<hsize_t>(n), frame);
    if (has_growing_id(file)) {
      const std::vector<double> id = entry(file, kId, n, {spheres});
      for (std::size_t i = 0; i < id.size(); ++i) {
        if (id[i] == -1) frame.missing.push_back(static_cast<std::int64_t>(i));
      }
    }
    return present_part(std::move(frame));
  });
}

Scalars TrajectoryReader::scalars(std::int64_t n) const {
  return reading_file(path_, [&](hid_t file) {
    Scalars all;
    for (const std::string& name : scalar_names(file))
      all.emplace_back(name, entry(file, "observables/" + name, n, {}).front());
    return all;
  });
}

}  // namespace fiberchain::dem
