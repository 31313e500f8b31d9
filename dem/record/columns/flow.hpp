#pragma once

#include "dem/record/columns.hpp"

// Fibers in a flow, and where the time of a step goes.
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column flow[] = {
    // Fibers in a flow; L = 2RN is the spheres' whole length in elasto_viscous, that of the bonds elsewhere.
    {"spheres", integer, "1",
     "N = r_f + 1, number of spheres; correlations of rigid fibers are taken at r = N"},
    {"hydrodynamics", text, "",
     "free_draining (drag of the undisturbed flow), interactions (Rotne-Prager-Yamakawa) or stresslets "
     "(these with the "
     "spheres' stresslets)"},
    {"flow_method", text, "",
     "inertialess, cvode (with inertia, implicit) or leapfrog (with inertia, explicit)"},
    {"elasto_viscous", number, "1", "3 pi mu rate L^4/(E I)"},
    {"strain", number, "1", "rate of the flow times time"},
    {"period", number, "1", "period of the orbit times the shear rate: twice the mean time of a half turn"},
    {"period_rigid", number, "1",
     "period of the rigid chain with the same hydrodynamics, by the reference's own route"},
    {"period_jeffery", number, "1",
     "period of the rigid free-draining chain: Jeffery's, r_e = sqrt((N^2 + 1)/2)"},
    {"period_error", number, "1", "period over the rigid chain's - 1"},
    {"period_cox", number, "1", "period by Cox's r_e = 1.24 r/sqrt(ln r), r = N"},
    {"period_goldsmith_mason", number, "1",
     "period by Goldsmith and Mason's fit to measurements, r_e = 0.742 r - 0.0017 r^2, r = N"},
    {"period_harris_pittman", number, "1", "period by Harris and Pittman's r_e = 1.14 r^0.844, r = N"},
    {"period_zhang", number, "1",
     "period by Zhang et al.'s r_e = 3.5e-5 r^3 - 0.00467 r^2 + 0.764 r + 0.404, r = N"},
    {"over_cox", number, "1", "period/period_cox - 1"},
    {"over_goldsmith_mason", number, "1", "period/period_goldsmith_mason - 1"},
    {"orbits", number, "1", "time followed over the period of the rigid chain"},
    {"direction_error", number, "1",
     "largest distance of the direction from Jeffery's closed form in the first orbit"},
    {"orbit_constant_drift", number, "1",
     "largest relative change of the orbit constant C; in the flow plane largest |p_z|"},
    {"viscous_ratio", number, "1", "mu rate/E"},
    {"regime", text, "",
     "how the fiber turns over: coil (its direction turns by 3/2 pi or more along it), else snake turn "
     "(half_turns > 2 "
     "axis_half_turns), else C-shaped (end_to_end_least < 0.9), else springy (< 0.99), else rigid"},
    {"gradient_extent", number, "1", "largest extent of the fiber along the gradient, over L"},
    {"direction_span", number, "rad", "largest difference of direction along the fiber at one moment"},
    {"stretch", number, "1", "largest relative change of the fiber's length along its spheres"},
    {"inflections", integer, "1", "most changes of the bend's sign along the fiber at one moment"},
    {"half_turns", integer, "1", "half turns of the vector from the first sphere to the last"},
    {"axis_half_turns", integer, "1", "half turns of the long axis of the gyration tensor, net"},
    {"stokes", number, "1", "Stokes number m rate/(6 pi mu R) of a sphere"},
    {"inertia_distance", number, "1",
     "largest distance of a sphere from where it is without inertia, over L, strains 0 to 10"},
    {"orbit_drift", number, "1", "relative change of the orbit constant C in one orbit"},
    {"orbit_drift_inertialess", number, "1", "the same without inertia: what bending does"},
    {"sphere_step_ns", number, "ns", "run time over steps and spheres"},
    {"threads", integer, "1", "threads of the run"},
    {"first_step", integer, "1", "step that the measured ones begin at"},
    {"bonds_ns", number, "ns",
     "part of sphere_step_ns: forces of bonds and reading them; of one loop with motion, what that takes by "
     "itself taken off"},
    {"motion_ns", number, "ns",
     "part of sphere_step_ns: spheres read, kicked, moved and written, measured in a loop of its own"},
    {"contacts_ns", number, "ns", "part of sphere_step_ns: which listed pairs touch, their loads, walls"},
    {"sizes", text, "", "of the fibers that are packed"},
    {"sphere_step_ratio", number, "1", "sphere_step_ns over that of fibers of one size"},
    {"search_ns", number, "ns", "part of sphere_step_ns: listing close pairs anew"},
    {"output_ns", number, "ns",
     "beside sphere_step_ns: frames of the trajectory, as often as the scene says"},
    {"sphere_bytes", number, "B", "memory that the process has grown by, over the spheres"},
    {"growth", number, "1",
     "growth rate over the rate of compression of a small even bend, rate times time from 0.5 to 1.5"},
    {"growth_chain", number, "1", "the same by the chain's own linearization about its compressed state"},
    {"growth_filament", number, "1", "the same of a thin inextensible filament"},
    {"growth_error", number, "1", "growth - growth_chain"},
    {"threshold_below", number, "1", "largest elasto-viscous number at which the bend decayed"},
    {"threshold_above", number, "1", "smallest one at which it grew"},
    {"threshold_chain", number, "1", "the threshold by the chain's own linearization"},
    {"threshold_inextensible", number, "1", "the same if bonds cannot stretch"},
    {"threshold_filament", number, "1", "the same of a thin inextensible filament"},
    {"orbit_constant", number, "1",
     "Jeffery's orbit constant as C/(1 + C), 1 in the flow plane; in a row of one run at its start"},
    {"orbit_constant_last", number, "1", "the same at the end of the run"},
    {"direction_x", number, "1", "part along the flow of the unit vector from the first sphere to the last"},
    {"direction_y", number, "1", "part of it along the gradient of a shear"},
    {"direction_z", number, "1", "part of it along the vorticity of a shear"},
    {"end_to_end", number, "1", "distance of the end spheres over that of the straight fiber"},
    {"end_to_end_least", number, "1", "least end_to_end of the run"},
    {"bending_angle", number, "rad",
     "largest bending angle of a bond; in a row of one run the largest of all"},
    {"bending_energy", number, "1", "elastic energy of the fiber, U L/(E I)"},
    {"center_x", number, "1", "center of mass along the flow, over L"},
    {"center_y", number, "1", "center of mass along the gradient of a shear, over L"},
    {"center_z", number, "1", "center of mass along the vorticity of a shear, over L"},
};

}  // namespace fiberchain::dem::columns
