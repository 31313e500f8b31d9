#pragma once

#include "dem/record/columns.hpp"

// Packings of straight stiff rods.
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column rod_packing[] = {
    {"rod_aspect_ratio", integer, "1", "r = L/d, L between the centers of the ends"},
    {"rod_friction", number, "1", "Coulomb's coefficient between rods"},
    {"rod_pressure", number, "1", "that the packing bears, over Young's modulus"},
    {"rod_fraction", number, "1", "solid fraction of rods with round ends, spheres in a row likewise"},
    {"rod_fraction_interval", number, "1", "half of the 95 % interval of its mean over the seeds"},
    {"rod_fraction_by_aspect", number, "1", "rod_fraction times r"},
    {"rod_contacts", number, "1", "rods that touch a rod, mean"},
    {"rod_contacts_interval", number, "1", "half of the 95 % interval of its mean over the seeds"},
    {"rod_sine", number, "1", "mean |sin| of the angle between two rods; pi/4 of random directions"},
    {"rod_contact_ratio", number, "1",
     "rod_fraction v_ex/v over rod_contacts, v_ex the excluded volume at rod_sine: 1 of random contacts"},
    {"rod_cube", number, "1", "edge of the periodic cube over L"},
    {"rod_overlap", number, "1", "mean overlap of contacts over the radius"},
};

}  // namespace fiberchain::dem::columns
