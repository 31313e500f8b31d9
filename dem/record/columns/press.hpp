#pragma once

#include "dem/record/columns.hpp"

// Beds of fibers under a plate.
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column press[] = {
    {"press_friction", number, "1", "Coulomb's coefficient between fibers"},
    {"press_speed", number, "m/s", "of the plate"},
    {"press_exponent", number, "1",
     "n of the plate's pressure p = a (phi^n - phi_0^n), phi the solid fraction"},
    {"press_stiffness", number, "1", "a of it over Young's modulus"},
    {"initial_fraction", number, "1", "phi_0 of it"},
    {"press_residual", number, "1", "root mean square of ln p over its fit"},
    {"press_points", integer, "1", "samples that are fitted"},
    {"plate_pressure", number, "Pa", "on the plate, mean over the interval"},
    {"floor_pressure", number, "Pa", "on the floor, likewise"},
};

}  // namespace fiberchain::dem::columns
