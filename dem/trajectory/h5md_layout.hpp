#pragma once

#include <hdf5.h>

#include <array>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "dem/trajectory/h5md.hpp"
#include "dem/trajectory/hdf5.hpp"
#include "dem/trajectory/hdf5_vfd.hpp"
#include "dem/trajectory/output_fields.hpp"

// Where things stand in a trajectory, for its writer and its reader.
namespace fiberchain::dem::h5md {

inline constexpr const char* kPosition = "particles/fibers/position";
inline constexpr const char* kSteps = "particles/fibers/position/step";
inline constexpr const char* kEdges = "particles/fibers/box/edges";
inline constexpr const char* kOrigin = "particles/fibers/box/origin";
inline constexpr const char* kId = "particles/fibers/id";
inline constexpr const char* kBonds = "connectivity/bonds";

inline std::string value_of(const std::string& element) { return element + "/value"; }
inline std::string sphere_element(const OutputField& field) {
  return std::string("particles/fibers/") + field.name;
}
inline std::string bond_element(const OutputField& field) { return std::string("observables/") + field.name; }
/// Where earlier versions put it: MDAnalysis does not look into groups there.
inline std::string nested_bond_element(const OutputField& field) {
  return std::string("observables/fibers/") + field.name;
}

/// Elements in time of every trajectory.
inline std::vector<std::string> elements() {
  std::vector<std::string> all = {kPosition};
  for (const OutputField& field : sphere_fields) all.push_back(sphere_element(field));
  all.insert(all.end(), {kEdges, kOrigin});
  for (const OutputField& field : bond_fields) all.push_back(bond_element(field));
  return all;
}

/// Size of an entry of a field: rows of `width`, or of one number.
inline std::vector<hsize_t> entry_size(const OutputField& field, hsize_t rows) {
  return field.width == 1 ? std::vector<hsize_t>{rows}
                          : std::vector<hsize_t>{rows, static_cast<hsize_t>(field.width)};
}

static_assert(std::is_trivially_copyable_v<Vec<double, 3>> && sizeof(Vec<double, 3>) == 3 * sizeof(double),
              "vectors are written as rows of three");

/// Names of the scalars in the file.
inline std::vector<std::string> scalar_names(hid_t file) {
  std::vector<std::string> names = hdf5::names_in(hdf5::open_group(file, "observables"));
  std::erase(names, "fibers");
  for (const OutputField& field : bond_fields) std::erase(names, field.name);
  return names;
}

/// A group with a value that grows, its step and time those of the positions.
void make_element(hid_t file, const std::string& name, hid_t type, const std::vector<hsize_t>& size,
                  const std::string& unit, bool compressed);

/// Whether the numbers of the spheres are in time.
inline bool has_growing_id(hid_t file) { return hdf5::has(file, value_of(kId)); }

enum class Access { create, change, read };

/// Earlier versions of HDF5's metadata have no checksums, and one changed byte ends the program.
/// @throws hdf5::Failure
inline void require_checksums(const JournaledFile& journaled) {
  std::array<char, 9> start{};
  journaled.read(FileHead::kBytes, start.data(), start.size());
  constexpr std::string_view signature("\x89HDF\r\n\x1a\n", 8);
  if (std::string_view(start.data(), 8) != signature || start[8] != 3)
    throw hdf5::Failure("no HDF5 with checksums of its metadata");
}

/// The HDF5 file within a journaled file. Closing it leaves all that was written in the journaled file.
inline hdf5::Handle open_in(JournaledFile& journaled, Access access) {
  const hdf5::Handle by(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose, "make a property list");
  if (!use_journaled_file(by, journaled)) throw hdf5::Failure("HDF5 cannot use our files");
  const char* name = journaled.path().c_str();
  // metadata of this version have checksums: a damaged file is an error, not a crash of HDF5
  hdf5::check(H5Pset_libver_bounds(by, H5F_LIBVER_V110, H5F_LIBVER_V110), "choose a version");
  if (access == Access::create) {
    const hdf5::Handle head(H5Pcreate(H5P_FILE_CREATE), &H5Pclose, "make a property list");
    hdf5::check(H5Pset_userblock(head, FileHead::kBytes), "leave room for the head");
    return {H5Fcreate(name, H5F_ACC_TRUNC, head, by), &H5Fclose, "make this file"};
  }
  require_checksums(journaled);
  return {H5Fopen(name, access == Access::read ? H5F_ACC_RDONLY : H5F_ACC_RDWR, by), &H5Fclose,
          "open this file"};
}

}  // namespace fiberchain::dem::h5md
