#pragma once

#include "reference/chain_modes.hpp"
#include "reference/linear_chain.hpp"
#include "reference/time_scheme.hpp"

// What one step of a scheme does to the small motions of a linear chain. A motion u ~ z^n grows if |z| > 1.
namespace fiberchain::reference {

/// Largest |z| of the wave with `phase` between neighbors, 0 to pi, on an endless chain: spectral radius of
/// the amplification matrix of strains and velocities. Without dashpots it is 1 for every stable step. A
/// `tension` [N] the chain is pulled by, 0 or above, adds its stiffness tension/l (w2 - w1)^2 across the
/// chain, no part of which stands in the scheme's matrix. Throws InvalidArgument, NoConvergence.
double wave_radius(const LinearChain& chain, const TimeScheme& scheme, ChainMotion motion, double phase,
                   double dt, double tension = 0);

/// The same over all modes of a finite chain, by a dense eigensolve: up to 200 bonds.
double chain_radius(const LinearChain& chain, const TimeScheme& scheme, ChainMotion motion, ChainEnds ends,
                    double dt, double tension = 0);

/// The largest |z| of a finite chain, 1 if nothing grows, in a time proportional to the number of bonds. What
/// grows has a real z < -1, where the symmetric pencil
/// P(z) = (z-1)^2 M + dt (theta (z-1)^2 + z - 1) C + dt^2 (beta (z-1)^2 + z) K is singular; P is positive
/// definite left of all such z. Planar motion leaves twist out; tension as above, beside K.
double growth_per_step(const LinearChain& chain, const TimeScheme& scheme, ChainEnds ends, double dt,
                       bool planar = false, double tension = 0);

/// Largest step [s] at which no wave of an endless chain grows: the least over the phase of the step at which
/// wave_radius() leaves 1. Infinite for beta >= 1/4 and theta = 1/2.
double endless_stable_step(const LinearChain& chain, const TimeScheme& scheme, bool planar = false);

/// Largest step [s] at which no mode of the finite chain grows: growth_per_step() leaves 1. Infinite as
/// above, without tension.
double finite_stable_step(const LinearChain& chain, const TimeScheme& scheme, ChainEnds ends,
                          bool planar = false, double tension = 0);

/// T_R = pi R sqrt(rho/G)/(0.1631 nu + 0.8766) [s]: time of the Rayleigh wave around half a sphere, the time
/// step rule of sphere contact. Throws InvalidArgument.
double rayleigh_step(const ChainMaterial& material);

}  // namespace fiberchain::reference
