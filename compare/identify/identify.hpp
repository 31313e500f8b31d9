#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "compare/identify/damped_sines.hpp"
#include "dem/model/fiber.hpp"

// From a ring-down that was measured to what the fiber is: Young's modulus, damping and their uncertainty.
namespace fiberchain::compare {

/// What was let go.
enum class RecordOf {
  beam,  ///< a fiber: a uniform beam, clamped at one end
  chain  ///< a chain of this program
};

struct IdentifyCase {
  RingDownRecord record;
  /// Its diameter, aspect ratio, density, Poisson's ratio, bond and mass model; E and damping are sought.
  /// Left out: frequency and damping only.
  std::optional<dem::Fiber> fiber = {};
  RecordOf of = RecordOf::beam;
  double confidence = 0.95;
};

/// A value with the ends of its interval.
struct Estimate {
  double value = std::numeric_limits<double>::quiet_NaN(), low = value, high = value;
};

struct Identification {
  Estimate frequency = {};                      ///< undamped, omega_1 = |lambda| [rad/s]
  Estimate damping_ratio = {};                  ///< xi_f
  Estimate log_decrement = {};                  ///< delta = 2 pi xi_f / sqrt(1 - xi_f^2) (Eq 17)
  Estimate loss_factor = {};                    ///< 2 xi_f: tan delta at omega_1, to first order
  std::optional<Estimate> youngs_modulus = {};  ///< at omega_1, of the fiber or the chain [Pa]
  std::optional<Estimate> bond_damping = {};    ///< xi_b with which a chain of that E has xi_f
  SineFit fit = {};        ///< the first of its modes is the one identified, others are higher modes
  double noise = 0;        ///< standard deviation of what the fit leaves, in the record's unit
  double amplitude = 0;    ///< of the mode at the record's begin, likewise
  double periods = 0;      ///< that the record has of the mode
  double correlation = 0;  ///< of residuals with the next ones: 0 of noise
  /// Why the record cannot tell; empty where it can. Estimates that it cannot tell are not numbers.
  std::vector<std::string> doubts = {};
  std::vector<std::string> warnings = {};  ///< what makes the intervals too narrow, or the values others
};

/// Damped sines fitted by least squares, one a mode, as many as stand out of the noise (four at most); the
/// first found is the mode. Intervals: covariance of the fit with its residuals' variance, Student's t, ends
/// carried through to each quantity. Throws InputError for fewer than 12 samples, times that do not rise,
/// numbers that are not finite, a fiber that makes no sense.
Identification identify(const IdentifyCase& asked);

}  // namespace fiberchain::compare
