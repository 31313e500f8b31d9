#pragma once

#include <string>

namespace fiberchain::compare {

/// Whether there is a program of this name on the PATH.
bool is_on_path(const std::string& program);

/// Whether there is a program gnuplot on the PATH.
bool has_gnuplot();

/// What gnuplot writes to its standard output when it is given this script.
/// @throws FigureError if gnuplot is not installed, fails, or writes nothing
std::string run_gnuplot(const std::string& script);

}  // namespace fiberchain::compare
