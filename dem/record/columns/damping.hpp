#pragma once

#include "dem/record/columns.hpp"

// Damped vibration of a fiber, rolling friction of its bonds, stability of the time step.
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column damping[] = {
    // Damped vibration: the fiber's damping ratio xi_f, measured and by every reference.
    {"dashpots", text, "",
     "how the dashpots are set: bond_damping (xi_b), retardation_time or bending_only (xi_b)"},
    {"retardation_ratio", number, "1", "retardation time of the bonds over t_b"},
    {"force", number, "N", "load at the free end before the release"},
    {"youngs_modulus", number, "Pa", "Young's modulus E"},
    {"shear_modulus", number, "Pa", "shear modulus G"},
    {"peaks_first", integer, "1", "first peak of fiber_damping_paper; peak 0 is the point of release"},
    {"peaks_last", integer, "1", "last peak of fiber_damping_paper"},
    {"fiber_damping", number, "1",
     "xi_f of the first mode alone, to 1e-4 of it: load up to 0.01 released from that mode, else from rest: "
     "peaks after the higher modes are gone or, lightly damped, of the motion filtered about its frequency"},
    {"fiber_damping_half_width", number, "1",
     "95 % half width of its fit: lack of fit, the data have no noise"},
    {"fiber_damping_sine", number, "1", "the same part of the motion fitted by a damped sine"},
    {"fiber_damping_paper", number, "1", "xi_f measured as the paper: released from rest, the peaks named"},
    {"fiber_damping_modes", number, "1", "xi_f of the linear chain's first mode"},
    {"fiber_damping_elastica", number, "1",
     "xi_f of the damped Elastica with the chain's mass layout, measured as fiber_damping"},
    {"fiber_damping_closed_form", number, "1", "(beta_1^2/sqrt(20)) xi_b/(r_f + 1/2)^2"},
    {"fiber_damping_beam", number, "1", "xi_f of the uniform Kelvin-Voigt beam"},
    {"fiber_damping_eq20", number, "1", "the paper's Eq 20, 0.03709 exp(-0.1615 r_f) xi_b"},
    {"mode_2_estimate", number, "1",
     "what the higher modes do to the named peaks of a linear beam, over xi_f"},
    {"damping_mass", number, "1",
     "part of fiber_damping_modes over fiber_damping_beam - 1 from the mass of the spheres"},
    {"damping_discretization", number, "1",
     "part of fiber_damping_paper over fiber_damping_beam - 1 from finite bonds and the end sphere"},
    {"damping_shear", number, "1", "part from shear springs and dashpots"},
    {"damping_time_step", number, "1", "part from the time step: march at vanishing load - linear chain"},
    {"damping_amplitude", number, "1", "part from the amplitude: fiber_damping - march at vanishing load"},
    {"damping_peak_fit", number, "1", "part from the peaks: fiber_damping_paper - fiber_damping"},
    {"frequency", number, "rad/s", "damped frequency measured"},
    {"frequency_modes", number, "rad/s", "damped frequency of the linear chain's first mode"},
    {"cvode_steps", integer, "1", "steps of CVODE on the damped Elastica"},
    {"cvode_right_hand_sides", integer, "1", "its evaluations of the right-hand side"},
    {"cvode_jacobians", integer, "1", "its evaluations of the Jacobian"},
    {"cvode_error_test_failures", integer, "1", "its steps that failed the error test"},
    {"cvode_convergence_failures", integer, "1", "its nonlinear iterations that did not converge"},
    {"motion", text, "", "bending, axial or twist"},
    {"mode", integer, "1", "number of the mode, 1 the lowest"},
    {"mode_damping", number, "1", "damping ratio of that mode of the linear chain, in free decay"},
    {"stable_step_ratio", number, "1", "largest stable time step over t_b"},
    {"time", number, "1", "time since the release over the first mode's period"},
    {"energy", number, "J", "kinetic and elastic energy of the chain"},
    {"chain_y", number, "1", "deflection of the chain's free end over that at the release"},
    {"elastica_y", number, "1", "the damped Elastica's, with the chain's mass layout"},

    // Rolling friction of the bonds.
    {"rolling", text, "",
     "law of rolling friction: set_valued (sticks, solved within the step) or explicit_sign (as the paper, "
     "sign of the "
     "lagged spin)"},
    {"fiber_damping_paper_half_width", number, "1",
     "95 % half width of the fit of fiber_damping_paper: lack of fit"},
    {"fiber_damping_first", number, "1", "xi_f of the first two of the peaks named alone"},
    {"fiber_damping_last", number, "1", "xi_f of the last two of the peaks named alone"},
    {"fiber_damping_as_bond", number, "1",
     "xi_f of the linear chain's first mode with xi_b + xi_r and no friction: if xi_r acted as xi_b does"},
    {"fiber_damping_weak", number, "1",
     "fiber_damping_modes + about 0.204 xi_r (a/L)/r_f, the linear mode's friction at the mean height a of "
     "the peaks named"},
    {"peak", integer, "1", "number of the peak of the free end; 0 is the release or the first after it"},
    {"peak_height", number, "1", "deflection of the free end at that peak, y/L"},
    {"peak_time", number, "1", "time of that peak since the release over t_b"},

    // Stability: the largest time step of an explicit scheme, growth at large steps of the other.
    {"scheme", text, "",
     "leapfrog (dashpots at the lagged velocity, as the paper), leapfrog-damped (dashpots solved within the "
     "step) or leapfrog-stiff (springs, too)"},
    {"ends", text, "", "how the chain is held: clamped_free or free_free"},
    {"stable_step_endless", number, "1",
     "largest stable time step of the endless chain over t_b, by the amplification's spectral radius over "
     "all waves"},
    {"stable_step_modes", number, "1", "the same of this chain, by its modes"},
    {"stable_step_measured", number, "1",
     "the same of runs: middle between the largest step that did not grow and the next"},
    {"stable_step_half_width", number, "1", "half the distance of these two"},
    {"stable_step_difference", number, "1", "stable_step_measured/stable_step_modes - 1"},
    {"bond_time_verdict", text, "", "what a run at the paper's critical step t_b does: stable or unstable"},
    {"quarter_verdict", text, "",
     "what a run at 0.25 t_b does, the paper's 'small enough': stable or unstable"},
    {"quarter_growth", number, "1", "largest growth a step of a mode at 0.25 t_b: 1 if stable"},
    {"growth_modes", number, "1", "largest |z| of a mode, which the step multiplies by z"},
    {"growth_measured", number, "1",
     "the same of a run: largest speed of its last quarter over that of its second, a step"},
    {"growth_difference", number, "1", "growth_measured - growth_modes"},
    {"growth_margin", number, "1",
     "largest difference that a run of this length allows, in which faster motions take part"},
    {"swell", number, "1", "largest speed of the run over that of its start"},
    {"growth_verdict", text, "", "what the run does: unstable if its speed swells tenfold, else stable"},
};

}  // namespace fiberchain::dem::columns
