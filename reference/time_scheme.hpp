#pragma once

#include <complex>

// Schemes that march velocities v, which stand half a step before the displacements u, by
//   (M + theta dt C + beta dt^2 K) (v+ - v) = -dt (K u + C v),  u+ = u + dt v+,
// and what one step of them does to a single damped oscillator.
namespace fiberchain::reference {

struct TimeScheme {
  double theta;  ///< part of dt C in the matrix: 0 (dashpots at v) to 1/2 (at the mean of v and v+)
  double beta;   ///< part of dt^2 K in the matrix: 0 (explicit springs) to 1
};

inline constexpr TimeScheme lagged_dashpots{0, 0};  ///< explicit, dashpots at the velocity half a step before
inline constexpr TimeScheme damped_in_step{0.5, 0};  ///< explicit springs, dashpots solved within the step
/// Springs and dashpots solved within the step: Newmark's rule with gamma = 1/2.
constexpr TimeScheme bonds_in_step(double beta) { return {0.5, beta}; }

/// Throws InvalidArgument for a theta or beta out of range.
void validate(const TimeScheme& scheme);

/// The root z (u ~ z^n) of the oscillator u'' + 2 damping w u' + w^2 u = 0 with w dt = `angle`: of a pair the
/// one with positive imaginary part, of two real ones the larger in size. Throws InvalidArgument.
std::complex<double> step_root(const TimeScheme& scheme, double angle, double damping);

/// Largest w dt at which the oscillator does not grow, by the root that leaves the circle at z = -1:
/// 1 - (1 - 2 theta) damping w dt - (1/4 - beta) (w dt)^2 = 0; infinite where it never does. The bound of the
/// stable region over w dt and damping. Throws InvalidArgument.
double stable_angle(const TimeScheme& scheme, double damping);

/// Relative errors of a mode's frequency and damping ratio.
struct ModeError {
  double frequency;  ///< numerical |lambda| over the true one, less 1; numerical lambda = ln(z)/dt
  double damping;    ///< numerical -Re(lambda)/|lambda| over the true one, less 1
};

/// Leading errors of a lightly damped mode: with h = w dt, frequency
/// (1/2 - theta) damping h - (beta - 1/12) h^2/2, damping (1/2 - theta) damping h - (beta/2 + 1/24) h^2. What
/// is left out is of the order of h^4, h^3 damping and h^2 damping^2. Throws InvalidArgument.
ModeError error_law(const TimeScheme& scheme, double angle, double damping);

}  // namespace fiberchain::reference
