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
    {"press_touched", number, "1", "other fibers that a fiber touches at the end, mean"},
    {"press_touched_interval", number, "1", "half of the 95 % interval of its mean over the seeds"},
    {"press_dense", number, "1",
     "pressure of the plate at the end over Young's modulus, mean of the last tenth"},
    {"press_dense_interval", number, "1", "half of the 95 % interval of its mean over the seeds"},
    {"press_light", number, "1", "solid fraction at which the plate's pressure is 1e-4 of Young's modulus"},
    {"press_light_interval", number, "1", "half of the 95 % interval of its mean over the seeds"},
    {"plate_pressure", number, "Pa", "on the plate, mean over the interval"},
    {"floor_pressure", number, "Pa", "on the floor, likewise"},
};

}  // namespace fiberchain::dem::columns
