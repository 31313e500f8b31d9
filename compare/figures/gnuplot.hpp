#pragma once

#include <string>

namespace fiberchain::compare {

/// What gnuplot writes to its standard output when it is given this script.
/// @throws FigureError if gnuplot is not installed, fails, or writes nothing
std::string run_gnuplot(const std::string& script);

}  // namespace fiberchain::compare
