#pragma once

#include "dem/record/columns.hpp"

// Fibers cut into bonds of another length than they are thick.
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column spacing[] = {
    {"spacing", number, "1", "s = l/d, length of a bond over the diameter; 1 of touching spheres"},
    {"frequency_error", number, "1",
     "frequency of the first mode over that of the uniform slender beam, less 1"},
    {"damping_over_bond_damping", number, "1", "xi_f of the first mode over xi_b, both small"},
    {"damping_law_error", number, "1",
     "that over (beta_1^2/4) s/r_f^2, the law of many bonds with the cylinder's mass, less 1"},
    {"stable_step_gain", number, "1",
     "largest stable step without dashpots over that of the paper's touching spheres"},
    {"spacing_goal", text, "", "what bonds are counted for: free end (of the cantilever), first frequency"},
    {"touching_error", number, "1", "its error with the paper's bond and touching spheres"},
    {"spaced_error", number, "1",
     "error of the fewest corrected bonds that keep it; `bonds` is their number"},
    {"times_fewer", number, "1", "touching spheres' number of bonds over those; their spacing"},
};

}  // namespace fiberchain::dem::columns
