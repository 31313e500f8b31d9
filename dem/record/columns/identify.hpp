#pragma once

#include "dem/record/columns.hpp"

// What a measured ring-down tells of a fiber.
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column identify[] = {
    {"identified", number, "", "value found, in the unit of the row; nan: the record cannot tell"},
    {"interval_low", number, "", "lower end of its interval (95 %, or as asked for)"},
    {"interval_high", number, "", "upper end"},
    {"record_time", number, "s", "time of a sample"},
    {"record_displacement", number, "", "displacement, in the record's unit"},
    {"fitted", number, "", "displacement of the damped sines that were fitted"},
    {"left", number, "", "what they leave"},
};

}  // namespace fiberchain::dem::columns
