#pragma once

#include "dem/record/columns.hpp"

// Contacts alone: impacts, adhesion.
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column contact[] = {
    {"impact_test", integer, "1", "test of Chung & Ooi, Granular Matter 13 (2011) 643: 1 to 8"},
    {"impact_material", text, "", "material of the sphere; of test 8 with the variant of the large one"},
    {"incidence", number, "1", "slip of the surfaces over the normal speed before the impact"},
    {"recoil", number, "1", "slip over the normal speed after it, positive in the sense before"},
    {"recoil_reference", number, "1", "the same by the reference"},
    {"restitution", number, "1", "normal coefficient of restitution set"},
    {"restitution_found", number, "1", "normal speed after over before"},
    {"impact_spin", number, "1/s", "spin of the first sphere after"},
    {"impact_slides", text, "", "whether it slides throughout, by the reference: yes or no"},
    {"impact_steps", number, "1", "time steps in contact"},
    {"impact_error", number, "1",
     "largest difference from the reference over several moments of touch within a step: velocities and "
     "radius times "
     "spin over the normal speed of the impact (test 3: over what is left of it), force, overlap and time "
     "over "
     "their own"},
    {"impact_error_rigid", number, "1",
     "the same of velocities against rigid bodies that slide through; missing where they do not"},
    {"step_part", number, "1", "time step over the one that the program chooses"},
    {"impact_order", number, "1", "exponent of the step in impact_error, from this step to the next"},
    {"experiment", text, "", "whose points: kharaz (measured), fem (finite elements)"},
    {"impact_quantity", text, "", "tangential_restitution, spin, rebound_angle or recoil"},
    {"abscissa", number, "", "angle of incidence [degrees], or slip over mu times the normal speed"},
    {"ordinate", number, "", "the quantity there"},
};

}  // namespace fiberchain::dem::columns
