#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dem/trajectory/frame.hpp"

/// What the color of a sphere tells.
namespace fiberchain::compare {

struct Shade {
  std::string name;   ///< as the command line has it, and the file
  std::string label;  ///< of the color scale, without the unit
  std::string unit;   ///< "" without
  bool is_signed;     ///< its zero is the middle of the colors
  /// A number for each sphere of the frame.
  std::function<std::vector<double>(const dem::TrajectoryFrame&)> values;
};

/// All that are known: every field of spheres and bonds that trajectories have (output_fields.hpp), of
/// vectors the size and the components, and some that follow from them. A bond's stands at a sphere as the
/// mean of its bonds.
const std::vector<Shade>& shades();

/// @throws InvalidInput where there is none of this name
const Shade& shade_named(std::string_view name);

/// Ends of the color scale: those of the data without its lowest and highest half percent, which show in the
/// end colors.
std::pair<double, double> range_of(std::vector<double> values);

/// Those of all these frames.
std::pair<double, double> shade_range(std::span<const dem::TrajectoryFrame> frames, const Shade& shade);

}  // namespace fiberchain::compare
