#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <ranges>

#include "dem/files/file_error.hpp"
#include "dem/model/errors.hpp"
#include "dem/trajectory/h5md_contacts.hpp"
#include "dem/trajectory/h5md_layout.hpp"
#include "dem/trajectory/h5md_walls.hpp"
#include "dem/trajectory/hdf5_chunks.hpp"

namespace fiberchain::dem {

/// What frames are made in, kept from one to the next.
struct FrameRoom {
  std::vector<double> numbers;
  hdf5::ChunkWriter chunks;
};

namespace {

using namespace h5md;
using hdf5::Handle;

// Functions: these names open HDF5, which is not to be before main.
hdf5::Stored stored_double() { return {H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE}; }
hdf5::Stored stored_integer() { return {H5T_NATIVE_INT64, H5T_STD_I64LE}; }

/// Runs what uses HDF5, and names the file in what goes wrong.
template <class Action>
auto writing_file(const std::filesystem::path& path, const Action& action) {
  const hdf5::Quiet quiet;
  try {
    return action();
  } catch (const hdf5::Failure& failure) {
    throw ReadError(path, failure.what());
  }
}

void write_head(hid_t file, const TrajectoryHeader& header) {
  const Handle head = hdf5::make_group(file, "h5md");
  hdf5::set_attribute(head, "version", std::vector<std::int32_t>{1, 1});
  hdf5::set_text_for_python(hdf5::make_group(head, "author"), "name", header.author);
  const Handle creator = hdf5::make_group(head, "creator");
  hdf5::set_text_for_python(creator, "name", "fiberchain");
  hdf5::set_text_for_python(creator, "version", header.creator_version);
  const Handle modules = hdf5::make_group(head, "modules");
  hdf5::set_attribute(hdf5::make_group(modules, "units"), "version", std::vector<std::int32_t>{1, 0});
}

void write_run(hid_t file, const TrajectoryHeader& header) {
  const Handle runs = hdf5::has(file, "parameters")
                          ? hdf5::open_group(file, "parameters/runs")
                          : hdf5::make_group(hdf5::make_group(file, "parameters"), "runs");
  const Handle run = hdf5::make_group(runs, std::to_string(hdf5::names_in(runs).size()).c_str());
  for (const auto& [key, value] : header.provenance) hdf5::set_attribute(run, key.c_str(), value);
}

void write_box(hid_t group, const TrajectoryFrame& frame) {
  const Handle box = hdf5::make_group(group, "box");
  hdf5::set_attribute(box, "dimension", std::vector<std::int32_t>{3});
  std::vector<std::string> boundary;
  for (const bool periodic : frame.periodic) boundary.emplace_back(periodic ? "periodic" : "none");
  hdf5::set_attribute(box, "boundary", boundary);
}

/// Numbers of the spheres; -1 for those that are not there.
std::vector<std::int32_t> ids(const TrajectoryFrame& frame) {
  std::vector<std::int32_t> id(frame.position.size());
  std::iota(id.begin(), id.end(), 0);
  std::fill(id.end() - frame.absent, id.end(), -1);
  for (const std::int64_t sphere : frame.missing) id[static_cast<std::size_t>(sphere)] = -1;
  return id;
}

/// What does not change: radius, number of the fiber, number of the sphere, bonds.
void write_fixed(hid_t file, hid_t group, const TrajectoryFrame& frame, bool growing) {
  const hsize_t spheres = frame.position.size();
  const hdf5::Stored integer{H5T_NATIVE_INT32, H5T_STD_I32LE};
  hdf5::write_array(group, "radius", stored_double(), {spheres}, frame.radius.data(), true);
  hdf5::write_array(group, "fiber", integer, {spheres}, frame.fiber.data(), true);
  if (!growing) hdf5::write_array(group, "id", integer, {spheres}, ids(frame).data(), true);
  std::vector<std::int64_t> pairs;
  for (const FrameBond& bond : frame.bonds) {
    pairs.push_back(bond.first);
    pairs.push_back(bond.first + 1);
  }
  const Handle connectivity = hdf5::make_group(file, "connectivity");
  const Handle bonds =
      hdf5::write_array(connectivity, "bonds", stored_integer(), {frame.bonds.size(), 2}, pairs.data(), true);
  hobj_ref_t reference;
  hdf5::check(H5Rcreate(&reference, file, "particles/fibers", H5R_OBJECT, -1), "refer to a group");
  const Handle space(H5Screate(H5S_SCALAR), &H5Sclose, "make a dataspace");
  const Handle attribute(
      H5Acreate2(bonds, "particles_group", H5T_STD_REF_OBJ, space, H5P_DEFAULT, H5P_DEFAULT), &H5Aclose,
      "make an attribute");
  hdf5::check(H5Awrite(attribute, H5T_STD_REF_OBJ, &reference), "write an attribute");
}

void write_layout(hid_t file, const TrajectoryHeader& header, const TrajectoryFrame& frame,
                  const Scalars& scalars) {
  const hsize_t spheres = frame.position.size(), bonds = frame.bonds.size();
  write_head(file, header);
  write_run(file, header);
  hdf5::make_group(file, "particles");
  const Handle fibers = hdf5::make_group(file, "particles/fibers");
  write_box(fibers, frame);
  hdf5::make_group(file, "observables");
  make_element(file, kPosition, H5T_IEEE_F64LE, {spheres, 3}, "", true);
  for (const OutputField& field : sphere_fields)
    make_element(file, sphere_element(field), H5T_IEEE_F32LE, entry_size(field, spheres), field.unit, true);
  make_element(file, kEdges, H5T_IEEE_F64LE, {3, 3}, "m", false);
  make_element(file, kOrigin, H5T_IEEE_F64LE, {3}, "m", false);
  for (const OutputField& field : bond_fields)
    make_element(file, bond_element(field), H5T_IEEE_F32LE, entry_size(field, bonds), field.unit, true);
  if (header.growing) make_element(file, kId, H5T_STD_I32LE, {spheres}, "", true);
  for (const auto& [name, value] : scalars)
    make_element(file, "observables/" + name, H5T_IEEE_F64LE, {}, "", false);
  write_fixed(file, fibers, frame, header.growing);
  if (!header.walls.empty()) write_wall_surfaces(file, header.walls);
  if (header.contacts) make_contacts(file, 0);
}

/// Every series of the file, once.
std::vector<std::string> all_series(hid_t file) {
  std::vector<std::string> all = {std::string(kPosition) + "/step", std::string(kPosition) + "/time"};
  for (const std::string& element : elements()) all.push_back(value_of(element));
  if (has_growing_id(file)) all.push_back(value_of(kId));
  if (has_walls(file)) all.push_back(value_of(kWallPoses));
  if (has_contacts(file)) all.push_back(value_of(kContactCount));
  for (const std::string& name : scalar_names(file)) all.push_back(value_of("observables/" + name));
  return all;
}

void set_frames(hid_t file, hsize_t count) {
  for (const std::string& series : all_series(file))
    hdf5::resize_series(hdf5::open_array(file, series.c_str()), count);
}

void check_same(hid_t file, const TrajectoryFrame& frame, const Scalars& scalars) {
  const auto size = [&](const std::string& name, std::size_t index) {
    const auto all = hdf5::size_of(hdf5::open_array(file, name.c_str()));
    return all.size() > index ? all[index] : 0;
  };
  const hsize_t spheres = size(value_of(kPosition), 1), bonds = size(kBonds, 0);
  if (spheres != frame.position.size() || bonds != frame.bonds.size()) {
    throw InvalidInput(
        fmt::format("a frame of {} spheres and {} bonds does not go with earlier ones of {} and {}",
                    frame.position.size(), frame.bonds.size(), spheres, bonds));
  }
  std::vector<std::string> names;
  for (const auto& [name, value] : scalars) names.push_back(name);
  std::ranges::sort(names);
  if (names != scalar_names(file)) throw InvalidInput("the scalars of a frame are not those of earlier ones");
  if (has_walls(file) && size(value_of(kWallPoses), 1) != frame.walls.size())
    throw InvalidInput("the walls of a frame are not those of earlier ones");
}

/// Whether each sphere is not there.
std::vector<bool> away(const TrajectoryFrame& frame) {
  std::vector<bool> all(frame.position.size(), false);
  std::fill(all.end() - frame.absent, all.end(), true);
  for (const std::int64_t sphere : frame.missing) all[static_cast<std::size_t>(sphere)] = true;
  return all;
}

/// Numbers of spheres that are not there are none.
void blank(const TrajectoryFrame& frame, std::size_t width, std::vector<double>& numbers) {
  if (frame.absent == 0 && frame.missing.empty()) return;
  const std::vector<bool> blanked = away(frame);
  for (std::size_t i = 0; i < blanked.size(); ++i) {
    if (blanked[i])
      std::fill_n(numbers.begin() + static_cast<std::ptrdiff_t>(i * width), width, std::nan(""));
  }
}

/// The number to 37 bits, an error of 2^-37 of it at most: the two bytes that become zero cost nothing.
double rounded(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return std::isfinite(value) ? std::bit_cast<double>((bits + 0x8000) & ~std::uint64_t{0xffff}) : value;
}

void round_positions(const TrajectoryFrame& frame, std::vector<double>& numbers) {
  numbers.resize(3 * frame.position.size());
  double* to = numbers.data();
  for (const Vec<double, 3>& x : frame.position) {
    for (int c = 0; c < 3; ++c) *to++ = rounded(x[c]);
  }
  blank(frame, 3, numbers);
}

void write_frame(hid_t file, hsize_t n, const TrajectoryFrame& frame, const Scalars& scalars,
                 FrameRoom& room) {
  std::vector<double>& numbers = room.numbers;
  const auto put = [&](const std::string& name, hid_t type, const void* values) {
    hdf5::write_entry(hdf5::open_array(file, name.c_str()), n, type, values);
  };
  const Vec<double, 3> size = frame.high - frame.low,
                       edges[3] = {{size[0], 0, 0}, {0, size[1], 0}, {0, 0, size[2]}};
  put(std::string(kPosition) + "/step", H5T_NATIVE_INT64, &frame.step);
  put(std::string(kPosition) + "/time", H5T_NATIVE_DOUBLE, &frame.time);
  const auto put_numbers = [&](const std::string& name) {
    room.chunks.write(hdf5::open_array(file, name.c_str()), n, numbers);
  };
  round_positions(frame, numbers);
  put_numbers(value_of(kPosition));
  for (const OutputField& field : sphere_fields) {
    field.get(frame, numbers);
    blank(frame, static_cast<std::size_t>(field.width), numbers);
    put_numbers(value_of(sphere_element(field)));
  }
  put(value_of(kEdges), H5T_NATIVE_DOUBLE, edges);
  put(value_of(kOrigin), H5T_NATIVE_DOUBLE, &frame.low);
  for (const OutputField& field : bond_fields) {
    if (frame.bonds.empty()) continue;
    field.get(frame, numbers);
    put_numbers(value_of(bond_element(field)));
  }
  if (has_growing_id(file)) put(value_of(kId), H5T_NATIVE_INT32, ids(frame).data());
  for (const auto& [name, value] : scalars) put(value_of("observables/" + name), H5T_NATIVE_DOUBLE, &value);
  if (has_walls(file)) {
    pose_numbers(frame, numbers);
    put_numbers(value_of(kWallPoses));
  }
  if (has_contacts(file)) append_contacts(file, n, frame);
}

void check_frame(const TrajectoryFrame& frame) {
  const std::size_t spheres = frame.position.size();
  const auto outside = [&](const FrameBond& bond) {
    return bond.first < 0 || bond.first + 1 >= static_cast<std::int64_t>(spheres);
  };
  if (spheres == 0) throw InvalidInput("a frame without spheres");
  const auto incomplete = [&](const OutputField& field) { return field.rows(frame) != spheres; };
  if (std::ranges::any_of(sphere_fields, incomplete) || frame.radius.size() != spheres ||
      frame.fiber.size() != spheres)
    throw InvalidInput("a frame's positions, velocities, radii and fibers differ in number");
  if (frame.absent < 0 || frame.absent > static_cast<std::int64_t>(spheres))
    throw InvalidInput("a frame lacks more spheres than it has");
  if (std::ranges::any_of(frame.bonds, outside)) throw InvalidInput("a frame's bond has no such spheres");
  const auto lone = [&](const FrameContact& contact) {
    return contact.first < 0 || contact.first >= static_cast<std::int64_t>(spheres) || contact.second < 0 ||
           (contact.kind != ContactKind::wall && contact.second >= static_cast<std::int64_t>(spheres));
  };
  if (std::ranges::any_of(frame.contacts, lone)) throw InvalidInput("a frame's contact has no such spheres");
}

/// Beside FILE.h5 a link FILE.h5md: by that suffix MDAnalysis knows what it is. Where it cannot be made, on
/// file systems without links, it is left out.
void link_h5md(const std::filesystem::path& path) {
  const std::filesystem::path link = std::filesystem::path(path).replace_extension(".h5md");
  std::error_code ignored;
  if (link == path || std::filesystem::exists(std::filesystem::symlink_status(link, ignored))) return;
  std::filesystem::create_symlink(path.filename(), link, ignored);
}

}  // namespace

void h5md::make_element(hid_t file, const std::string& name, hid_t type, const std::vector<hsize_t>& size,
                        const std::string& unit, bool compressed) {
  const Handle group = hdf5::make_group(file, name.c_str());
  const Handle value = hdf5::make_series(group, "value", type, size, compressed);
  if (!unit.empty()) hdf5::set_text_for_python(value, "unit", unit);
  if (name == kPosition) {
    hdf5::make_series(group, "step", H5T_STD_I64LE, {}, false);
    const Handle time = hdf5::make_series(group, "time", H5T_IEEE_F64LE, {}, false);
    hdf5::set_text_for_python(time, "unit", "s");
    return;
  }
  for (const char* shared : {"step", "time"}) {
    hdf5::check(H5Lcreate_hard(file, (std::string(kPosition) + "/" + shared).c_str(), group, shared,
                               H5P_DEFAULT, H5P_DEFAULT),
                "link a dataset");
  }
}

TrajectoryWriter::TrajectoryWriter(std::filesystem::path path, TrajectoryHeader header)
    : path_(std::move(path)), header_(std::move(header)), room_(std::make_unique<FrameRoom>()) {}

TrajectoryWriter::TrajectoryWriter(TrajectoryWriter&&) noexcept = default;
TrajectoryWriter& TrajectoryWriter::operator=(TrajectoryWriter&&) noexcept = default;
TrajectoryWriter::~TrajectoryWriter() = default;

TrajectoryWriter TrajectoryWriter::resume(std::filesystem::path path, TrajectoryHeader header,
                                          std::int64_t last_step) {
  TrajectoryWriter writer(std::move(path), std::move(header));
  if (!std::filesystem::exists(writer.path_)) return writer;
  const TrajectoryReader before(writer.path_);
  const auto kept = std::ranges::upper_bound(before.steps(), last_step) - before.steps().begin();
  if (kept == 0) return writer;
  JournaledFile journaled(writer.path_, JournaledFile::Mode::change);
  writing_file(writer.path_, [&] {
    const Handle file = open_in(journaled, Access::change);
    set_frames(file, static_cast<hsize_t>(kept));
    if (has_contacts(file)) {
      keep_contacts(file, static_cast<hsize_t>(kept));
    } else if (writer.header_.contacts) {
      make_contacts(file, static_cast<hsize_t>(kept));
    }
    write_run(file, writer.header_);
    hdf5::flush(file);
  });
  journaled.commit();
  writer.times_.assign(before.times().begin(), before.times().begin() + kept);
  writer.last_step_ = before.steps()[static_cast<std::size_t>(kept) - 1];
  return writer;
}

void TrajectoryWriter::append(const TrajectoryFrame& frame, const Scalars& scalars) {
  check_frame(frame);
  if ((frame.absent > 0 || !frame.missing.empty()) && !header_.growing)
    throw InvalidInput("a frame lacks spheres in a file that does not grow");
  if (frame.walls.size() != header_.walls.size()) throw InvalidInput("a frame has other walls than its file");
  if (!times_.empty() && frame.step <= last_step_)
    throw InvalidInput(fmt::format("a frame of step {} after one of step {}", frame.step, last_step_));
  const bool first = times_.empty();
  JournaledFile journaled(path_, first ? JournaledFile::Mode::create : JournaledFile::Mode::change);
  writing_file(path_, [&] {
    const Handle file = open_in(journaled, first ? Access::create : Access::change);
    first ? write_layout(file, header_, frame, scalars) : check_same(file, frame, scalars);
    set_frames(file, times_.size() + 1);
    write_frame(file, times_.size(), frame, scalars, *room_);
    hdf5::flush(file);
  });
  journaled.commit();
  times_.push_back(frame.time);
  last_step_ = frame.step;
  link_h5md(path_);
}

}  // namespace fiberchain::dem
