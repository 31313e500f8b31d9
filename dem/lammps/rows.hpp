#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "dem/contact/contact_history.hpp"
#include "dem/contact/kernels/contact_kernel.hpp"
#include "dem/lammps/bond_kernel.hpp"
#include "dem/simd/lane_array.hpp"

// Spheres of a rank, its own and those of others near it, in rows as the loops want them.
namespace fiberchain::dem::mpi {

/// A contact on its way to where its sphere goes.
struct TravellingContact {
  double partner;                        ///< number of the other sphere; -1 - n of wall n
  double history[contact_history_size];  ///< as if the sphere that has it were the first body
};

/// Indices are LAMMPS's: own spheres, then ghosts, then `pads`.
struct Rows {
  static constexpr int pads = 3;

  LaneArray position_radius, velocity_spin, orientation;
  LaneArray load;                  ///< of contacts, load_size a sphere
  LaneArray history;               ///< bond_history_size a sphere: of the bond behind it
  std::vector<std::int32_t> kind;  ///< of contacts
  std::vector<std::vector<TravellingContact>> contacts;  ///< where lists are not valid

  /// Room for so many spheres; what there is stays.
  void grow(std::size_t spheres) {
    const std::size_t rows = spheres + pads + lanes_beyond;
    const auto larger = [&](LaneArray& array, int numbers) {
      if (array.size() >= rows * numbers) return;
      LaneArray grown(rows * numbers);
      std::copy_n(array.data(), array.size(), grown.data());
      array = std::move(grown);
    };
    larger(position_radius, position_radius_size), larger(velocity_spin, velocity_spin_size);
    larger(orientation, quaternion_size), larger(load, load_size), larger(history, bond_history_size);
    if (kind.size() < rows) kind.resize(rows, 0);
    if (contacts.size() < spheres) contacts.resize(spheres);
  }

  double* position_of(std::size_t i) { return position_radius.data() + i * position_radius_size; }
  double* motion_of(std::size_t i) { return velocity_spin.data() + i * velocity_spin_size; }
  double* orientation_of(std::size_t i) { return orientation.data() + i * quaternion_size; }
  double* load_of(std::size_t i) { return load.data() + i * load_size; }
  double* history_of(std::size_t i) { return history.data() + i * bond_history_size; }
};

}  // namespace fiberchain::dem::mpi
