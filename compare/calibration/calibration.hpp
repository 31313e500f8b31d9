#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "dem/model/fiber.hpp"
#include "reference/chain_modes.hpp"

// From the damping of a material to that of the bonds and back, on the linear chain's first bending mode,
// exactly.
namespace fiberchain::compare {

/// Ways to say how a material damps.
enum class DampingMeasure {
  damping_ratio,   ///< xi_f
  log_decrement,   ///< delta = 2 pi xi_f / sqrt(1 - xi_f^2) (Eq 17)
  quality_factor,  ///< Q = 1 / (2 xi_f)
  loss_factor      ///< eta = 2 xi_f
};

std::string_view name(DampingMeasure measure);

/// xi_f of a material's damping. Throws InputError for a value that is not above 0 and finite, and for one
/// that means xi_f >= 1: no vibration.
double to_damping_ratio(DampingMeasure measure, double value);

/// How far the free end swings, for the estimate of what that does to xi_f.
enum class AmplitudeMeasure {
  load,           ///< P L^2 / (E I) that holds the fiber before its release
  tip_deflection  ///< y / L
};

/// y / L. Throws InputError below 0 and beyond largest_amplitude.
double to_amplitude(AmplitudeMeasure measure, double value);

/// Largest y / L that the effect of the amplitude was measured at (a load of 2.4).
inline constexpr double largest_amplitude = 0.55;

/// Change of xi_f, in parts of itself, when the free end swings by y / L = a: -a^2 (0.460 + 0.27 a^2 + 0.27
/// a^4). Measured on the inextensible damped Elastica from one peak to the next once mode 2 is gone, xi_f =
/// 0.002 ... 0.04, a up to 0.55: within 0.003 of that; the extra half sphere of a chain with r_f = 10 makes
/// it 1.5 % larger. It is the beam's own, not an error of the chain: a real fiber does the same.
double amplitude_effect(double amplitude);

/// Change of xi_f, in parts of itself, by the leapfrog with lagged damping at a step dt: with w = omega dt
/// the characteristic roots are z^2 - (2 - w^2 - 2 xi w) z + (1 - 2 xi w) = 0.
double time_step_effect(double damping_ratio, double frequency, double time_step);

/// What a fiber shall do and how much it swings. The fiber's dashpot law says what is sought; its own setting
/// is not read by calibrate().
struct CalibrationCase {
  dem::Fiber fiber;
  double amplitude = 0;  ///< expected y / L
  std::optional<double> step_ratio =
      std::nullopt;  ///< dt / t_b of the run to be; as dem::ReleaseOptions if left out
  /// Whether size and material are a real fiber's; without, the answers are ratios and the rest is left out.
  bool dimensional = true;
};

/// Where the chain's first mode departs from the fiber's own, a uniform beam's, in parts of the beam's value.
struct BeamDeparture {
  double mass;            ///< mass of the spheres in place of the fiber's
  double discretization;  ///< finite bonds, half a sphere more at the free end, spin of the spheres
  double shear;           ///< shear springs and dashpots
};

struct Calibration {
  dem::Fiber fiber;                   ///< with its dashpots set
  double damping_ratio;               ///< xi_f of the chain's first mode
  double setting;                     ///< xi_b, or tau over t_b with DashpotLaw::retardation_time
  double retardation_time;            ///< tau = c / K of the bonds in bending [s]
  reference::ChainMode mode;          ///< first bending mode of the linear chain
  double natural_frequency;           ///< |lambda| [rad/s]
  double stable_step;                 ///< largest stable dt [s]
  double bond_time;                   ///< t_b [s]
  double step;                        ///< dt that the run is expected to take [s]
  double beam_damping;                ///< the fiber's xi_f with this tau, tau omega / 2
  double beam_frequency;              ///< the fiber's, beta_1^2 sqrt(E I / (rho A L^4)) [rad/s]
  BeamDeparture damping_departure;    ///< of xi_f; the setting makes up for it
  BeamDeparture frequency_departure;  ///< of the frequency; an error of the chain that no damping mends
  double amplitude_effect;            ///< expected of a run, in parts of xi_f
  double time_step_effect;            ///< expected of a run, in parts of xi_f
};

/// The setting with which the chain's first mode has the damping ratio asked for, to 1e-9 of it. Throws
/// InputError when there is none: not in 0 < xi_f < 1, or beyond what this dashpot law reaches at this aspect
/// ratio, or r_f above 1000.
Calibration calibrate(const CalibrationCase& asked, double damping_ratio);

/// The reverse: what the fiber's own setting gives. Throws InputError for no damping and for an overdamped
/// first mode.
Calibration calibration_of(const CalibrationCase& asked);

/// What a run found. Without an amplitude asked for it is released from the first mode at y / L = 1/300, else
/// from its equilibrium at that deflection, and the first mode's peaks are measured
/// (measure/first_mode_damping.hpp), which have swung down by then.
struct Verification {
  double damping_ratio;  ///< measured
  double amplitude;      ///< y / L of the peaks measured, in the mean of their squares
  double expected;       ///< the calibration's, changed by these amplitudes
  double difference;     ///< over `expected`, - 1
  double time_step;      ///< [s]
  double bond_steps;     ///< its cost
};

/// Largest number of bond-steps that verify() takes on: about half a minute.
inline constexpr double largest_verification = 3e9;

/// Bond-steps that verify() would take.
double verification_cost(const Calibration& found, double amplitude = 0);

/// Marches the calibrated chain at the amplitude y / L asked for; 0: at a vanishing one. Throws InputError,
/// with the estimate, beyond largest_verification, and where at that amplitude higher modes outlive the
/// first.
Verification verify(const Calibration& found, double amplitude = 0);

}  // namespace fiberchain::compare
