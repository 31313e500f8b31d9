#pragma once

#include "dem/record/columns.hpp"

// Benchmarks of rods in space.
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column rods[] = {
    {"rod_benchmark", text, "", "which rod, see compare/README.md"},
    {"rod_load", number, "1", "its load, over E I/L^2 (forces), E I/L (moments) or E I/L^3 (per length)"},
    {"rod_value", number, "1", "a number of the chain: a place over L, a critical load or turn"},
    {"rod_reference", number, "1", "the same of the rod that the chain converges to, by shooting"},
    {"rod_error", number, "1", "distance of all the benchmark's numbers from the rod's"},
    {"rod_error_doubled", number, "1", "the same with twice the bonds"},
    {"rod_order", number, "1", "order in 1/r_f from these bonds to twice as many"},
    {"rod_order_expected", number, "1", "2 of the paper's bond, 4 of the corrected one, 2 of lumped weight"},
};

}  // namespace fiberchain::dem::columns
