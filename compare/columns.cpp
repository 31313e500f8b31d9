#include "compare/columns.hpp"

#include <algorithm>
#include <string>

#include "compare/errors.hpp"

namespace fiberchain::compare {
namespace {

using enum CellKind;

// All lengths are relative to L, the total length of the bonds; angles in radians. "Elastica" is the
// inextensible, unshearable rod; "Reissner" the rod with shear and stretch, the chain's continuum limit.
constexpr Column kColumns[] = {
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
    {"step_ratio", number, "1", "time step over t_b = sqrt(m/K_n)"},
    {"time_step", number, "s", "time step; of CVODE the mean"},
    {"rolling_friction", number, "1", "xi_r, rolling friction coefficient of a bond (Eq 21)"},
    {"bond_evaluations", integer, "1", "evaluations of the forces of one bond"},
    {"linear_solves", integer, "1", "eliminations along the whole chain"},
    {"integrator", text, "", "leapfrog, leapfrog-damped (dashpots solved within the step), implicit or cvode"},

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
    {"order", number, "1", "order in 1/r_f at which departure_distance falls from the row before; in shear-stiffness of period_error in mu rate/E, in shear-inertia of inertia_distance in the Stokes number"},
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

    // Damped vibration: the fiber's damping ratio xi_f, measured and by every reference.
    {"dashpots", text, "", "how the dashpots are set: bond_damping (xi_b), retardation_time or bending_only (xi_b)"},
    {"retardation_ratio", number, "1", "retardation time of the bonds over t_b"},
    {"force", number, "N", "load at the free end before the release"},
    {"youngs_modulus", number, "Pa", "Young's modulus E"},
    {"shear_modulus", number, "Pa", "shear modulus G"},
    {"peaks_first", integer, "1", "first peak of fiber_damping_paper; peak 0 is the point of release"},
    {"peaks_last", integer, "1", "last peak of fiber_damping_paper"},
    {"fiber_damping", number, "1",
     "xi_f measured without mode 2: load up to 0.01 released from the first mode, else from rest, after mode 2 is gone"},
    {"fiber_damping_half_width", number, "1", "95 % half width of its fit: lack of fit, the data have no noise"},
    {"fiber_damping_sine", number, "1", "the same part of the motion fitted by a damped sine"},
    {"fiber_damping_paper", number, "1", "xi_f measured as the paper: released from rest, the peaks named"},
    {"fiber_damping_modes", number, "1", "xi_f of the linear chain's first mode"},
    {"fiber_damping_elastica", number, "1",
     "xi_f of the damped Elastica with the chain's mass layout, measured as fiber_damping"},
    {"fiber_damping_closed_form", number, "1", "(beta_1^2/sqrt(20)) xi_b/(r_f + 1/2)^2"},
    {"fiber_damping_beam", number, "1", "xi_f of the uniform Kelvin-Voigt beam"},
    {"fiber_damping_eq20", number, "1", "the paper's Eq 20, 0.03709 exp(-0.1615 r_f) xi_b"},
    {"mode_2_estimate", number, "1", "what the higher modes do to the named peaks of a linear beam, over xi_f"},
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
    {"mode_damping", number, "1", "damping ratio of that mode of the linear chain"},
    {"stable_step_ratio", number, "1", "largest stable time step over t_b"},
    {"time", number, "1", "time since the release over the first mode's period"},
    {"energy", number, "J", "kinetic and elastic energy of the chain"},
    {"chain_y", number, "1", "deflection of the chain's free end over that at the release"},
    {"elastica_y", number, "1", "the damped Elastica's, with the chain's mass layout"},

    // Rolling friction of the bonds.
    {"rolling", text, "",
     "law of rolling friction: set_valued (sticks, solved within the step) or explicit_sign (as the paper, sign of the "
     "lagged spin)"},
    {"fiber_damping_paper_half_width", number, "1", "95 % half width of the fit of fiber_damping_paper: lack of fit"},
    {"fiber_damping_first", number, "1", "xi_f of the first two of the peaks named alone"},
    {"fiber_damping_last", number, "1", "xi_f of the last two of the peaks named alone"},
    {"fiber_damping_as_bond", number, "1",
     "xi_f of the linear chain's first mode with xi_b + xi_r and no friction: if xi_r acted as xi_b does"},
    {"fiber_damping_weak", number, "1",
     "fiber_damping_modes + about 0.204 xi_r (a/L)/r_f, the linear mode's friction at the mean height a of the peaks named"},
    {"peak", integer, "1", "number of the peak of the free end; 0 is the release or the first after it"},
    {"peak_height", number, "1", "deflection of the free end at that peak, y/L"},
    {"peak_time", number, "1", "time of that peak since the release over t_b"},

    // Stability: the largest time step of an explicit scheme.
    {"scheme", text, "", "leapfrog (dashpots at the lagged velocity, as the paper) or leapfrog-damped (solved within the step)"},
    {"ends", text, "", "how the chain is held: clamped_free or free_free"},
    {"stable_step_endless", number, "1",
     "largest stable time step of the endless chain over t_b, by the amplification's spectral radius over all waves"},
    {"stable_step_modes", number, "1", "the same of this chain, by its modes"},
    {"stable_step_measured", number, "1", "the same of runs: middle between the largest step that did not grow and the next"},
    {"stable_step_half_width", number, "1", "half the distance of these two"},
    {"stable_step_difference", number, "1", "stable_step_measured/stable_step_modes - 1"},
    {"bond_time_verdict", text, "", "what a run at the paper's critical step t_b does: stable or unstable"},
    {"quarter_verdict", text, "", "what a run at 0.25 t_b does, the paper's 'small enough': stable or unstable"},
    {"quarter_growth", number, "1", "largest growth a step of a mode at 0.25 t_b: 1 if stable"},

    // Fibers in a flow; L = 2RN is the spheres' whole length in elasto_viscous, that of the bonds elsewhere.
    {"spheres", integer, "1", "N = r_f + 1, number of spheres; correlations of rigid fibers are taken at r = N"},
    {"hydrodynamics", text, "",
     "free_draining (drag of the undisturbed flow), interactions (Rotne-Prager-Yamakawa) or stresslets (these with the "
     "spheres' stresslets)"},
    {"flow_method", text, "", "inertialess, cvode (with inertia, implicit) or leapfrog (with inertia, explicit)"},
    {"elasto_viscous", number, "1", "3 pi mu rate L^4/(E I)"},
    {"strain", number, "1", "rate of the flow times time"},
    {"period", number, "1", "period of the orbit times the shear rate: twice the mean time of a half turn"},
    {"period_rigid", number, "1",
     "period of the rigid chain with the same hydrodynamics, by the reference's own route"},
    {"period_jeffery", number, "1", "period of the rigid free-draining chain: Jeffery's, r_e = sqrt((N^2 + 1)/2)"},
    {"period_error", number, "1", "period over the rigid chain's - 1"},
    {"period_cox", number, "1", "period by Cox's r_e = 1.24 r/sqrt(ln r), r = N"},
    {"period_goldsmith_mason", number, "1",
     "period by Goldsmith and Mason's fit to measurements, r_e = 0.742 r - 0.0017 r^2, r = N"},
    {"period_harris_pittman", number, "1", "period by Harris and Pittman's r_e = 1.14 r^0.844, r = N"},
    {"period_zhang", number, "1", "period by Zhang et al.'s r_e = 3.5e-5 r^3 - 0.00467 r^2 + 0.764 r + 0.404, r = N"},
    {"over_cox", number, "1", "period/period_cox - 1"},
    {"over_goldsmith_mason", number, "1", "period/period_goldsmith_mason - 1"},
    {"orbits", number, "1", "time followed over the period of the rigid chain"},
    {"direction_error", number, "1", "largest distance of the direction from Jeffery's closed form in the first orbit"},
    {"orbit_constant_drift", number, "1", "largest relative change of the orbit constant C; in the flow plane largest |p_z|"},
    {"viscous_ratio", number, "1", "mu rate/E"},
    {"regime", text, "",
     "how the fiber turns over: coil (its direction turns by 3/2 pi or more along it), else snake turn (half_turns > 2 "
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
    {"bending_angle", number, "rad", "largest bending angle of a bond; in a row of one run the largest of all"},
    {"bending_energy", number, "1", "elastic energy of the fiber, U L/(E I)"},
    {"center_x", number, "1", "center of mass along the flow, over L"},
    {"center_y", number, "1", "center of mass along the gradient of a shear, over L"},
    {"center_z", number, "1", "center of mass along the vorticity of a shear, over L"},

    // Fits of the damping law.
    {"law", text, "",
     "xi_f/xi_b = a exp(-b r_f) (exponential), a r_f^-b (power) or (beta_1^2/sqrt(20))/(r_f + c)^2 (shifted_square)"},
    {"weighting", text, "",
     "least squares of xi_f/xi_b (unweighted) or of its logarithm (logarithmic); the paper's a and b (published); c = 1/2 "
     "(derived)"},
    {"fit_a", number, "1", "a of the law"},
    {"fit_a_half_width", number, "1", "95 % half width of a: lack of fit, the data have no noise"},
    {"fit_b", number, "1", "b of the law"},
    {"fit_b_half_width", number, "1", "95 % half width of b: lack of fit"},
    {"fit_c", number, "1", "c of the law"},
    {"fit_c_half_width", number, "1", "95 % half width of c: lack of fit"},
    {"fit_a_variance", number, "1", "covariance of a with itself"},
    {"fit_b_variance", number, "1", "covariance of b with itself"},
    {"fit_ab_covariance", number, "1", "covariance of a and b"},
    {"fit_c_variance", number, "1", "covariance of c with itself"},
    {"fit_points", integer, "1", "number of aspect ratios fitted"},
    {"fit_rms", number, "1", "root mean square of fit_residual on the fitted points"},
    {"fit_largest", number, "1", "largest fit_residual on the fitted points"},
    {"held_out_points", integer, "1", "number of aspect ratios held out"},
    {"held_out_rms", number, "1", "root mean square of fit_residual on the points held out"},
    {"held_out_largest", number, "1", "largest fit_residual on the points held out"},
    {"information_criterion", number, "1",
     "AICc = n ln(RSS/n) + 2k + 2k(k + 1)/(n - k - 1), k parameters and the variance; logarithmic fits + 2 sum "
     "ln(xi_f/xi_b), so that all speak of the same data"},
    {"within_1_percent", text, "", "aspect ratios from 3 to 500 at which the law is within 1 % of the linear chain"},
    {"within_5_percent", text, "", "the same within 5 %"},
    {"within_20_percent", text, "", "the same within 20 %"},
    {"held_out", integer, "1", "1 if the aspect ratio was held out of the fits, else 0"},
    {"damping_slope", number, "1", "xi_f/xi_b measured on the chain"},
    {"damping_slope_fit", number, "1", "xi_f/xi_b of the law"},
    {"fit_residual", number, "1", "damping_slope_fit/damping_slope - 1"},
    {"damping_slope_modes", number, "1", "xi_f/xi_b of the linear chain's first mode"},
    {"aspect_ratios", text, "", "aspect ratios fitted under this choice"},
    {"departure_a", number, "1", "fit_a/0.03709 - 1, from the paper's a"},
    {"departure_b", number, "1", "fit_b/0.1615 - 1, from the paper's b"},
    {"departure_curve", number, "1", "largest departure of the fit from the paper's Eq 20 over the choice's aspect ratios"},
    {"damping_slope_8", number, "1", "xi_f/xi_b at r_f = 8 with this load and these peaks; the paper has 0.01045"},
    {"damping_slope_10", number, "1", "xi_f/xi_b at r_f = 10 with this load and these peaks; the paper has 0.00698"},

    // Calibration: from a material's damping to that of the bonds.
    {"density", number, "kg/m^3", "density of the spheres"},
    {"diameter", number, "m", "diameter d of the fiber"},
    {"target_damping", number, "1", "xi_f asked for"},
    {"retardation_time", number, "s", "retardation time of the bonds in bending, dashpot over spring"},
    {"log_decrement", number, "1", "2 pi xi_f/sqrt(1 - xi_f^2)"},
    {"quality_factor", number, "1", "1/(2 xi_f)"},
    {"loss_factor", number, "1", "2 xi_f"},
    {"natural_frequency", number, "rad/s", "|lambda| of the linear chain's first bending mode"},
    {"natural_frequency_hertz", number, "Hz", "the same over 2 pi"},
    {"bond_time", number, "s", "t_b = sqrt(m/K_n)"},
    {"stable_time_step", number, "s", "largest stable time step"},
    {"verification_cost", number, "1", "bonds times time steps of the run that verifies"},
    {"amplitude", number, "1", "deflection of the free end that is expected, or of the first mode let go from, y/L"},
    {"amplitude_effect", number, "1", "what that amplitude does to xi_f, over xi_f; a real fiber does the same"},
    {"time_step_effect", number, "1", "what the time step does to xi_f, over xi_f"},
    {"expected_error", number, "1", "amplitude_effect + time_step_effect"},
    {"fiber_damping_expected", number, "1", "xi_f expected of a run at that amplitude and time step"},
    {"beam_frequency", number, "rad/s", "first natural frequency of the uniform beam with the spheres' mass per length"},
    {"frequency_discretization", number, "1",
     "part of the chain's undamped frequency over beam_frequency - 1 from finite bonds and the end sphere"},
    {"frequency_shear", number, "1", "part from shear"},
    {"verified_difference", number, "1", "fiber_damping of the run over fiber_damping_modes - 1"},

    // What it cost and how it ended.
    {"status", text, "", "converged or finished (and why as it was), or why not"},
    {"residual", number, "1",
     "largest moment out of balance over any cross section, over P L, when the run stopped"},
    {"iterations", integer, "1", "Newton iterations, all load steps together"},
    {"steps", integer, "1", "time steps of the march"},
    {"run_time", number, "s", "wall-clock time of the run"},

    // Run time against error.
    {"problem", text, "", "what is asked, with its load or aspect ratio"},
    {"setting", text, "", "what sets the accuracy of the method: time step, tolerance, residual or number of bonds"},
    {"lanes", integer, "1", "chains side by side in the lanes of a vector; times are those of one"},
    {"error", number, "1", "distance from the reference: over L, or relative for xi_f"},
    {"reference_error", number, "1", "error of the reference itself, estimated"},
    {"run_time_median", number, "s", "median of the runs; run_time is the least"},
    {"runs", integer, "1", "warm runs timed; a run of more than 2 s is timed once"},
    {"factorizations", integer, "1", "Newton matrices set up"},
    {"wanted_error", number, "1", "largest error allowed"},
    {"among", text, "", "methods chosen among: all, or those that follow the motion in time"},
    {"run_time_paper", number, "s", "run time of the paper's way at the cheapest setting that keeps the error"},
    {"speedup", number, "1", "run_time_paper over run_time"},

    // What is skipped, and the inner loops.
    {"skipped", text, "", "what a scene does without"},
    {"scene", text, "", "what is left"},
    {"scenes", integer, "1", "pairs of scenes that differ in this alone"},
    {"time_with", number, "s", "time of a bond-step, or of the whole answer, before it is skipped"},
    {"time_without", number, "s", "the same after"},
    {"saving", number, "1", "time_with over time_without; median where there are several scenes"},
    {"saving_least", number, "1", "least saving of these scenes"},
    {"saving_largest", number, "1", "largest saving of these scenes"},
    {"physics", text, "", "dimension, form of the bond law and features of an inner loop"},
    {"instruction_set", text, "", "scalar, sse2, avx2 or avx512"},
    {"bond_step_ns", number, "ns", "time of a step over bonds and lanes, all lanes full, chains of 11 spheres"},
    {"bond_step_target_ns", number, "ns", "largest bond_step_ns wanted"},
    {"lone_bond_step_ns", number, "ns", "time of a step over bonds, one chain of 11 spheres alone"},
    {"lone_target_ns", number, "ns", "largest lone_bond_step_ns wanted"},
    {"additions", number, "1", "additions and subtractions of a bond-step, counted from the loop"},
    {"multiplications", number, "1", "multiplications of a bond-step"},
    {"fusable", number, "1", "of its additions those of a product, one instruction with it where there are fused ones"},
    {"divisions", number, "1", "divisions of a bond-step"},
    {"square_roots", number, "1", "square roots of a bond-step"},
    {"sines", number, "1", "sines and cosines of a bond-step"},
    {"arc_tangents", number, "1", "arc tangents of a bond-step"},
    {"arithmetic_bound_ns", number, "ns",
     "least time of its additions, multiplications and circular functions at the core's measured peak"},
    {"divider_bound_ns", number, "ns", "least time of its divisions and square roots, which run beside the others"},
    {"bound_fraction", number, "1", "larger of both bounds over bond_step_ns"},
    {"multiply_add_ns", number, "ns", "time of an addition or multiplication, or of both fused, on one double at the core's peak"},
    {"divide_ns", number, "ns", "the same of a division"},
    {"square_root_ns", number, "ns", "the same of a square root"},
    {"sine_ns", number, "ns", "the same of a sine or cosine"},
    {"arc_tangent_ns", number, "ns", "the same of an arc tangent"},

    // Validation matrix.
    {"id", text, "", "identifier of the claim or published value, unique"},
    {"feature", text, "", "what is tested"},
    {"reference_kind", text, "", "exact, published, independent method or regression"},
    {"expected", number, "", "value of the reference, in the unit of the row"},
    {"measured", number, "", "value found here, in the unit of the row"},
    {"difference", number, "", "measured - expected"},
    {"tolerance", number, "", "largest |difference| at which the row holds"},
    {"verdict", text, "", "holds, disputed (published, found wrong; see evidence) or fails"},
    {"evidence", text, "", "how the row was measured, and why if it is disputed"},

    // Published values, data/published/*.csv.
    {"quantity", text, "", "the quantity published"},
    {"value", number, "", "its value, in the unit of the row"},
    {"unit", text, "", "unit of the row"},
    {"source", text, "", "where it is published"},
    {"page_or_figure", text, "", "page, figure, table or equation in the source"},
    {"statement", text, "", "the source's words, or what the number stands for"},

    // The dictionary as a table.
    {"column", text, "", "name of a column"},
    {"kind", text, "", "type of the column's cells: number, integer or text"},
    {"meaning", text, "", "meaning of the column"},

    // How a run of many fibers goes.
    {"step", integer, "1", "time steps done since the start of the scene"},
    {"simulated_time", number, "s", "time since the start of the scene"},
    {"contacts", integer, "1", "pairs that touch: spheres of fibers with each other and with walls"},
    {"kinetic_energy", number, "J", "of all spheres, spin included"},
    {"height", number, "m", "of the packing, as the run defines it"},
    {"step_rate", number, "1/s", "steps over the wall-clock time since the run was begun or resumed"},
    {"time_left", number, "s", "wall-clock time until the last step at that rate"},
};

}  // namespace

std::span<const Column> all_columns() { return kColumns; }

const Column& find_column(std::string_view name) {
  const auto* found = std::ranges::find(kColumns, name, &Column::name);
  if (found == std::end(kColumns)) throw TableError("no column is called '" + std::string(name) + "'");
  return *found;
}

std::string_view to_string(CellKind kind) {
  switch (kind) {
    case number:
      return "number";
    case integer:
      return "integer";
    case text:
      return "text";
  }
  throw TableError("no such kind of cell");
}

}  // namespace fiberchain::compare
