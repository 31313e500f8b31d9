#pragma once

#include <string>

#include "compare/figures/figure.hpp"

namespace fiberchain::compare {

/// Gnuplot's commands for a heat map on axes that are no scale: a column or row per value.
/// @throws FigureError unless value has a row for every y with a column for every x, and something to draw
std::string heat_map_commands(const HeatMap& map, const std::string& x_label, const std::string& y_label);

}  // namespace fiberchain::compare
