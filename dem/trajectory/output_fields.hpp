#pragma once

#include <array>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "dem/trajectory/frame.hpp"

// Quantities of spheres and bonds in trajectories, declared once: H5MD, its reader, VTK and pictures follow.
// A new one is a member of TrajectoryFrame or FrameBond and a line here. Positions, radii and fiber numbers,
// which are the geometry, stand apart.
namespace fiberchain::dem {

struct OutputField {
  const char* name;                                   ///< of the H5MD element
  const char* point_array;                            ///< in VTK; OVITO knows velocities as "v"
  const char* unit;                                   ///< H5MD's attribute
  int width;                                          ///< numbers a sphere or bond: 1 or 3
  std::size_t (*rows)(const TrajectoryFrame& frame);  ///< how many it has
  /// All values, row after row, into memory that is kept if it fits.
  void (*get)(const TrajectoryFrame& frame, std::vector<double>& values);
  /// Sets as many rows as `values` has.
  void (*set)(TrajectoryFrame& frame, const std::vector<double>& values);

  std::vector<double> values(const TrajectoryFrame& frame) const {
    std::vector<double> all;
    get(frame, all);
    return all;
  }
};

namespace output {

inline void give(double* to, double value) { *to = value; }
inline void give(double* to, const Vec<double, 3>& value) {
  for (int c = 0; c < 3; ++c) to[c] = value[c];
}
inline void take(const double* from, double& value) { value = *from; }
inline void take(const double* from, Vec<double, 3>& value) { value = {from[0], from[1], from[2]}; }

template <class Value>
inline constexpr int width_of = std::is_same_v<Value, double> ? 1 : 3;

/// Of every sphere: a vector of numbers or of vectors in the frame.
template <auto member>
constexpr OutputField of_spheres(const char* name, const char* point_array, const char* unit) {
  using Value = typename std::remove_cvref_t<decltype(std::declval<TrajectoryFrame&>().*member)>::value_type;
  constexpr int width = width_of<Value>;
  return {name,
          point_array,
          unit,
          width,
          [](const TrajectoryFrame& frame) { return (frame.*member).size(); },
          [](const TrajectoryFrame& frame, std::vector<double>& values) {
            values.resize(width * (frame.*member).size());
            double* to = values.data();
            for (const Value& value : frame.*member) give(to, value), to += width;
          },
          [](TrajectoryFrame& frame, const std::vector<double>& values) {
            (frame.*member).resize(values.size() / width);
            for (std::size_t i = 0; i < (frame.*member).size(); ++i)
              take(&values[i * width], (frame.*member)[i]);
          }};
}

/// Of every bond: a number or a vector; the frame has the bonds.
template <auto member>
constexpr OutputField of_bonds(const char* name, const char* unit) {
  using Value = std::remove_cvref_t<decltype(std::declval<FrameBond&>().*member)>;
  constexpr int width = width_of<Value>;
  return {name,
          name,
          unit,
          width,
          [](const TrajectoryFrame& frame) { return frame.bonds.size(); },
          [](const TrajectoryFrame& frame, std::vector<double>& values) {
            values.resize(width * frame.bonds.size());
            double* to = values.data();
            for (const FrameBond& bond : frame.bonds) give(to, bond.*member), to += width;
          },
          [](TrajectoryFrame& frame, const std::vector<double>& values) {
            for (std::size_t i = 0; i < frame.bonds.size(); ++i)
              take(&values[i * width], frame.bonds[i].*member);
          }};
}

}  // namespace output

inline constexpr std::array sphere_fields = {
    output::of_spheres<&TrajectoryFrame::velocity>("velocity", "v", "m s-1"),
};

inline constexpr std::array bond_fields = {
    output::of_bonds<&FrameBond::force>("bond_force", "N"),
    output::of_bonds<&FrameBond::bending_angle>("bending_angle", "rad"),
};

}  // namespace fiberchain::dem
