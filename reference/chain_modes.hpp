#pragma once

#include <complex>
#include <vector>

#include "reference/linear_chain.hpp"

namespace fiberchain::reference {

/// What holds the chain.
enum class ChainEnds {
  clamped_free,  ///< position and rotation of sphere 0 held
  free_free      ///< nothing held; motions as a rigid body are left out
};

/// Which of the uncoupled small motions.
enum class ChainMotion { bending, axial, twist };

/// A mode u(t) = Re(shape exp(eigenvalue t)).
struct ChainMode {
  std::complex<double> eigenvalue;  ///< lambda [1/s]; the member of a pair with positive imaginary part
  double frequency;                 ///< |lambda| [rad/s]
  double damping;                   ///< -Re(lambda)/|lambda|, the xi_f of Eq 17; 1 if overdamped
  bool oscillates;                  ///< false: a real eigenvalue, a creeping motion without a partner
  /// Per sphere 0 ... bonds: displacement (across, or along for axial) [m] and rotation (in plane, or about
  /// the axis for twist) [rad], scaled so that the last sphere's displacement (twist: rotation) is 1.
  /// The one a motion does not have is empty.
  std::vector<std::complex<double>> displacement;
  std::vector<std::complex<double>> rotation;
};

/// All modes by a dense eigensolve, lowest |lambda| first. Up to 300 bonds. Throws InvalidArgument,
/// NoConvergence.
std::vector<ChainMode> chain_modes(const LinearChain& chain, ChainMotion motion, ChainEnds ends);

/// Lowest bending mode of the clamped-free chain in a time proportional to the number of bonds, by inverse
/// iteration with sums along the chain only: every digit survives for 100000 bonds. Throws InvalidArgument,
/// NoConvergence (as when the mode and its conjugate are about to meet, critically damped).
ChainMode first_bending_mode(const LinearChain& chain);

/// Eigenvalue of axial or twisting mode `number` (1 is the lowest) in closed form: m lambda^2 + 4 sin^2(a)
/// (c lambda + k) = 0 with a = (2 number - 1) pi/(4 bonds + 2) clamped-free, number pi/(2 bonds + 2)
/// free-free; of an overdamped pair the slower.
std::complex<double> rod_eigenvalue(const LinearChain& chain, ChainMotion motion, ChainEnds ends, int number);

/// First bending mode's damping of a clamped-free chain with the paper's dashpots, for many bonds:
/// (beta_1^2 / sqrt(20)) xi_b / (bonds + 1/2)^2, beta_1 = 1.87510407.
double first_bending_damping(int bonds, double bond_damping);

}  // namespace fiberchain::reference
