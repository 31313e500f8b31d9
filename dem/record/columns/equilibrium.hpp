#pragma once

#include "dem/record/columns.hpp"

// Equilibrium of one fiber: what was asked, its free end and its departure from the Elastica. All lengths are
// relative to L, the total length of the bonds; angles in radians. "Elastica" is the inextensible,
// unshearable rod; "Reissner" the rod with shear and stretch, the chain's continuum limit.
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column equilibrium[] = {
    // What was asked.
    {"aspect_ratio", integer, "1", "r_f = L/d: number of bonds; the chain has one sphere more"},
    {"poisson_ratio", number, "1", "Poisson's ratio nu; the shear modulus is E/(2(1 + nu))"},
    {"load", number, "1", "dead load at the free end, P L^2/(E I)"},
    {"bond", text, "",
     "bond law: paper, or corrected (K_t = 3/4 K_n and a rest length that shortens with bending)"},
    {"form", text, "",
     "form of the bond law: total (from an energy, no history) or incremental (as the paper)"},
    {"method", text, "", "way to the equilibrium: solve (Newton) or march (time steps)"},
    {"dimension", text, "", "planar or spatial"},
    {"bond_damping", number, "1", "xi_b, damping coefficient of a bond"},
    {"step_ratio", number, "1", "time step over t_b = sqrt(m/K_n), in the mean where steps differ"},
    {"step_ratio_asked", number, "1", "the same as asked for; empty where it was left to the program"},
    {"time_step", number, "s", "time step; of CVODE the mean"},
    {"rolling_friction", number, "1", "xi_r, rolling friction coefficient of a bond (Eq 21)"},
    {"bond_evaluations", integer, "1", "evaluations of the forces of one bond"},
    {"linear_solves", integer, "1", "eliminations along the whole chain"},
    {"integrator", text, "",
     "leapfrog, leapfrog-damped (dashpots solved within the step), implicit or cvode"},

    // Free end: chain and references.
    {"tip_y", number, "1", "deflection of the free end along the load, y/L"},
    {"tip_x", number, "1", "shortening of the free end toward the clamp, 1 - x/L"},
    {"tip_angle", number, "rad", "rotation of the free end"},
    {"tip_z", number, "1", "displacement of the free end out of the plane of fiber and load, z/L"},
    {"elastica_tip_y", number, "1", "tip_y of the Elastica"},
    {"elastica_tip_x", number, "1", "tip_x of the Elastica"},
    {"elastica_tip_angle", number, "rad", "tip_angle of the Elastica"},
    {"reissner_tip_y", number, "1", "tip_y of the rod with shear and stretch"},
    {"reissner_tip_x", number, "1", "tip_x of the rod with shear and stretch"},
    {"reissner_tip_angle", number, "rad", "tip_angle of the rod with shear and stretch"},

    // Departure from the Elastica and its budget; the parts add up to the whole.
    {"departure_y", number, "1", "(tip_y - elastica_tip_y)/elastica_tip_y"},
    {"departure_x", number, "1", "(tip_x - elastica_tip_x)/elastica_tip_x"},
    {"departure_angle", number, "1", "(tip_angle - elastica_tip_angle)/elastica_tip_angle"},
    {"departure_distance", number, "1", "distance of the free end from the Elastica's, |dr|/L"},
    {"departure_distance_unstretched", number, "1",
     "the same distance after the part of stretch is taken off"},
    {"order", number, "1",
     "order in 1/r_f at which departure_distance falls from the row before; in shear-stiffness of "
     "period_error in mu rate/E, in shear-inertia of inertia_distance in the Stokes number"},
    {"order_unstretched", number, "1",
     "order in 1/r_f at which departure_distance_unstretched falls from the row before"},
    {"discretization_y", number, "1",
     "part of departure_y from the finite bonds: chain - rod with shear and stretch"},
    {"discretization_x", number, "1", "part of departure_x from the finite bonds"},
    {"discretization_angle", number, "1", "part of departure_angle from the finite bonds"},
    {"shear_y", number, "1", "part of departure_y from shear: rod with shear - Elastica"},
    {"shear_x", number, "1", "part of departure_x from shear"},
    {"shear_angle", number, "1", "part of departure_angle from shear"},
    {"stretch_y", number, "1",
     "part of departure_y from stretch: rod with shear and stretch - rod with shear"},
    {"stretch_x", number, "1", "part of departure_x from stretch"},
    {"stretch_angle", number, "1", "part of departure_angle from stretch"},
    {"history_y", number, "1",
     "part of departure_y from the incremental form: its equilibrium - the total form's"},
    {"history_x", number, "1", "part of departure_x from the incremental form"},
    {"history_angle", number, "1", "part of departure_angle from the incremental form"},
    {"time_step_y", number, "1", "part of departure_y from the time step of the march"},
    {"time_step_x", number, "1", "part of departure_x from the time step of the march"},
    {"time_step_angle", number, "1", "part of departure_angle from the time step of the march"},
    {"leftover_motion_y", number, "1", "part of departure_y from the motion left when the march stopped"},
    {"leftover_motion_x", number, "1", "part of departure_x from the motion left when the march stopped"},
    {"leftover_motion_angle", number, "1",
     "part of departure_angle from the motion left when the march stopped"},

    // Shape of a fiber at rest.
    {"sphere", integer, "1", "number of the sphere, 0 at the clamp"},
    {"position_x", number, "1", "position along the straight fiber, over L"},
    {"position_y", number, "1", "position along the part of the load across the fiber, over L"},
    {"position_z", number, "1", "position across fiber and load, over L"},
    {"angle", number, "rad", "angle of the fiber's axis at the sphere, from x toward y"},
    {"largest_strain", number, "1",
     "largest that stretch or shear of a bond can have: end load over the smaller of E A and G A; beyond 0.1 "
     "the "
     "linear laws are a rod's no more"},
};

}  // namespace fiberchain::dem::columns
