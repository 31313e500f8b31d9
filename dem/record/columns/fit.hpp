#pragma once

#include "dem/record/columns.hpp"

// Laws fitted to the damping, and calibration.
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column fit[] = {
    // Fits of the damping law.
    {"law", text, "",
     "xi_f/xi_b = a exp(-b r_f) (exponential), a r_f^-b (power) or (beta_1^2/sqrt(20))/(r_f + c)^2 "
     "(shifted_square)"},
    {"weighting", text, "",
     "least squares of xi_f/xi_b (unweighted) or of its logarithm (logarithmic); the paper's a and b "
     "(published); c = 1/2 "
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
     "AICc = n ln(RSS/n) + 2k + 2k(k + 1)/(n - k - 1), k parameters and the variance; logarithmic fits + 2 "
     "sum "
     "ln(xi_f/xi_b), so that all speak of the same data"},
    {"within_1_percent", text, "",
     "aspect ratios from 3 to 500 at which the law is within 1 % of the linear chain"},
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
    {"departure_curve", number, "1",
     "largest departure of the fit from the paper's Eq 20 over the choice's aspect ratios"},
    {"damping_slope_8", number, "1",
     "xi_f/xi_b at r_f = 8 with this load and these peaks; the paper has 0.01045"},
    {"damping_slope_10", number, "1",
     "xi_f/xi_b at r_f = 10 with this load and these peaks; the paper has 0.00698"},

    // Calibration: from a material's damping to that of the bonds.
    {"density", number, "kg/m^3", "density of the material"},
    {"mass", text, "",
     "what the chain weighs: spheres (of the material's density, two thirds of the fiber) or cylinder (the "
     "fiber)"},
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
    {"amplitude", number, "1",
     "deflection of the free end that is expected, or of the first mode let go from, y/L"},
    {"amplitude_effect", number, "1",
     "what that amplitude does to xi_f, over xi_f; a real fiber does the same"},
    {"time_step_effect", number, "1", "what the time step does to xi_f, over xi_f"},
    {"expected_error", number, "1", "amplitude_effect + time_step_effect"},
    {"fiber_damping_expected", number, "1", "xi_f expected of a run at that amplitude and time step"},
    {"beam_frequency", number, "rad/s",
     "first natural frequency of the fiber, a uniform beam of its density"},
    {"frequency_mass", number, "1",
     "part of the chain's undamped frequency over beam_frequency - 1 from the mass of its spheres"},
    {"frequency_discretization", number, "1", "part from finite bonds and the end sphere"},
    {"frequency_shear", number, "1", "part from shear"},
    {"verified_amplitude", number, "1", "y/L of the run's peaks that were measured, root mean square"},
    {"verified_expected", number, "1", "fiber_damping expected of peaks of these amplitudes"},
    {"verified_difference", number, "1", "fiber_damping of the run over verified_expected - 1"},
};

}  // namespace fiberchain::dem::columns
