#pragma once

#include <complex>
#include <vector>

#include "reference/chain_modes.hpp"
#include "reference/linear_chain.hpp"
#include "reference/time_scheme.hpp"

namespace fiberchain::reference {

/// A mode as a scheme marches it: u(n dt) = Re(shape z^n).
struct StepMode {
  std::complex<double> z;           ///< the member of a pair with positive imaginary part
  std::complex<double> eigenvalue;  ///< ln(z)/dt [1/s], to be held against that of ChainMode
  double frequency;                 ///< |eigenvalue| [rad/s]
  double damping;                   ///< -Re(eigenvalue)/|eigenvalue|
};

/// All modes of a finite chain marched by steps dt [s], lowest |ln z| first, as chain_modes() has them where
/// the step resolves them; motions as a rigid body left out. Their difference from those is the scheme's
/// error of period and damping. A dense eigensolve, up to 100 bonds. Throws InvalidArgument, NoConvergence.
std::vector<StepMode> step_modes(const LinearChain& chain, const TimeScheme& scheme, ChainMotion motion,
                                 ChainEnds ends, double dt);

}  // namespace fiberchain::reference
