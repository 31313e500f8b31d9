#pragma once

#include "dem/record/columns.hpp"

// Fibers that slide about a drum.
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column capstan[] = {
    {"drum_surface", text, "",
     "smooth fiber on a thick one, spheres on a cylinder (wall), smooth fiber on a ring of the same fiber "
     "(ring), spheres on a ring of spheres"},
    {"drum_friction", number, "1", "Coulomb's coefficient mu between fiber and drum"},
    {"turning", number, "1", "phi, angle between the directions of both ends, over pi"},
    {"drum_radius", number, "1", "radius of the drum over that of the fiber"},
    {"drum_bending", number, "1", "E I/(F_0 rho^2), F_0 the force that holds back, rho of the fiber's axis"},
    {"tension_ratio", number, "1", "tension where the fiber is drawn over that where it is held back"},
    {"tension_ratio_euler", number, "1", "exp(mu phi), of a thread"},
    {"tension_ratio_rod", number, "1", "of a rod that bends and is thick"},
    {"tension_error_euler", number, "1", "tension_ratio over exp(mu phi), less 1"},
    {"tension_error_rod", number, "1", "tension_ratio over that of the rod, less 1"},
    {"tension_ripple", number, "1", "largest departure of tension_ratio from its mean, over it"},
};

}  // namespace fiberchain::dem::columns
