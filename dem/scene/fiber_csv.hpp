#pragma once

#include <istream>
#include <string>
#include <vector>

#include "dem/insertion/placement.hpp"

namespace fiberchain::dem {

/// Fibers' starts from a CSV text. The first line that is not empty and does not begin with # names the
/// columns, in any order: x, y, z [m], the center of the first sphere; ux, uy, uz, the direction, of length 1
/// to 1e-3; vx, vy, vz [m/s], the velocity, all three or none (at rest). Then a fiber a line, plain numbers.
/// `name` is what messages call the file. Throws SceneError with file, line and column for anything else.
std::vector<FiberStart> read_fiber_starts(std::istream& text, const std::string& name);

/// The same from a file.
std::vector<FiberStart> read_fiber_starts(const std::string& path);

/// Line of the n-th fiber, from 0, in the text of such a file; 0 if it has none such.
std::size_t line_of_start(const std::string& text, std::size_t n);

}  // namespace fiberchain::dem
