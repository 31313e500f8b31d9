#pragma once

#include <complex>
#include <vector>

#include "reference/chain_modes.hpp"
#include "reference/complex_modulus.hpp"
#include "reference/linear_chain.hpp"
#include "reference/prony_series.hpp"

// Free vibrations u(t) = Re(shape exp(s t)) of bodies whose stiffnesses are complex moduli K(s): nonlinear
// eigenproblems. Every function throws InvalidArgument, and NoConvergence where a mode stops oscillating.
namespace fiberchain::reference {

/// How a mode dies away, and what forced vibration would say of it.
struct FreeDecay {
  std::complex<double> eigenvalue;  ///< s, of the pair the one with positive imaginary part [1/s]
  double frequency;                 ///< |s| [rad/s]
  double damping;                   ///< zeta = -Re(s)/|s|
  /// tan delta/2 at the real frequency |s|: half of the mode's K''(i|s|) over its K'(i|s|), each motion of a
  /// bond weighted by the mode's |strain|^2
  double half_loss_factor;
  double difference;  ///< damping - half_loss_factor; 0 for dashpots alone
};

/// Root of s^2 + omega^2 k(s) = 0 that continues i omega as k(s) grows from 1: one relaxed frequency omega
/// [rad/s], by Newton's iteration.
FreeDecay single_mode_decay(double omega, const ComplexModulus& modulus);

/// Uniform Euler-Bernoulli beam.
struct UniformBeam {
  double length;           ///< L [m]
  double bending;          ///< E_inf I, relaxed [N m^2]
  double mass_per_length;  ///< rho A [kg/m]
};

struct ComplexBeamMode {
  int number;   ///< from 1; rigid motions do not count
  double beta;  ///< wave number times L; its shape is that of the elastic beam, since E is the same all along
  FreeDecay decay;
};

/// The lowest `count` modes: rho A s^2 + E_inf k(s) I beta^4/L^4 = 0.
std::vector<ComplexBeamMode> complex_beam_modes(const UniformBeam& beam, const ComplexModulus& modulus,
                                                ChainEnds ends, int count);

/// beta_n of the free-free beam, cos(beta) cosh(beta) = 1; n from 1.
double free_free_beta(int n);

/// What the four springs of a bond are made of; `stiffness` of the LinearChain is the relaxed one.
struct BondModuli {
  ComplexModulus stretch, shear, twist, bend;
};

/// The same as Maxwell branches.
struct BondSpectra {
  PronySeries stretch, shear, twist, bend;
};

BondModuli bond_moduli(const BondSpectra& spectra);

struct ComplexChainMode {
  FreeDecay decay;
  bool oscillates;  ///< false: a real eigenvalue, a creeping motion; half_loss_factor and difference are 0
  /// Per sphere, scaled so that the last sphere's displacement (twist: rotation) is 1, as in ChainMode;
  /// meaningless where it stays at rest, as in bending of a single free bond.
  std::vector<std::complex<double>> displacement;
  std::vector<std::complex<double>> rotation;
};

/// The lowest `count` oscillating modes, each followed from the elastic one: roots of
/// det(M s^2 + B^T diag(K k(s) + c s) B) = 0, c the chain's dashpots, by inverse iteration with the
/// stationary value of the symmetric form; springs and dashpots grow from the relaxed springs in as many
/// steps as it takes. Order of the elastic frequencies. Up to 300 bonds.
std::vector<ComplexChainMode> complex_chain_modes(const LinearChain& chain, const BondModuli& moduli,
                                                  ChainMotion motion, ChainEnds ends, int count);

/// All modes, lowest |s| first, creeping ones too, by a dense eigensolve with the branches' strains as
/// further unknowns. Up to 2000 unknowns (bonds times 2 + branches, twice that in bending with branches in
/// both).
std::vector<ComplexChainMode> all_complex_chain_modes(const LinearChain& chain, const BondSpectra& spectra,
                                                      ChainMotion motion, ChainEnds ends);

}  // namespace fiberchain::reference
