#pragma once

#include "reference/chain_modes.hpp"
#include "reference/linear_chain.hpp"

// What one step of an explicit scheme does to the small motions of a linear chain. Velocities v stand half a
// step before displacements u; u+ = u + dt v+. A motion u ~ z^n grows if |z| > 1.
namespace fiberchain::reference {

enum class ExplicitScheme {
  lagged_dashpots,  ///< M v+ = M v - dt (K u + C v): dashpots at the velocity half a step before
  damped_in_step    ///< (M + dt/2 C) v+ = (M - dt/2 C) v - dt K u: dashpots at the mean velocity of the step
};

/// Largest |z| of the wave with `phase` between neighbors, 0 to pi, on an endless chain: spectral radius of
/// the amplification matrix of strains and velocities. Without dashpots it is 1 for every stable step. Throws
/// InvalidArgument, NoConvergence.
double wave_radius(const LinearChain& chain, ExplicitScheme scheme, ChainMotion motion, double phase,
                   double dt);

/// The same over all modes of a finite chain, by a dense eigensolve: up to 100 bonds.
double chain_radius(const LinearChain& chain, ExplicitScheme scheme, ChainMotion motion, ChainEnds ends,
                    double dt);

/// The largest |z| of a finite chain, 1 if nothing grows, in a time proportional to the number of bonds. What
/// grows has a real z < -1, where the symmetric pencil P(z) = (z-1)^2 M + dt D(z) C + dt^2 z K, D = z - 1
/// (lagged) or (z^2 - 1)/2, is singular; P is positive definite left of all such z. Planar motion leaves
/// twist out.
double growth_per_step(const LinearChain& chain, ExplicitScheme scheme, ChainEnds ends, double dt,
                       bool planar = false);

/// Largest step [s] at which no wave of an endless chain grows: the least over the phase of the step at which
/// wave_radius() leaves 1.
double endless_stable_step(const LinearChain& chain, ExplicitScheme scheme, bool planar = false);

/// Largest step [s] at which no mode of the finite chain grows: growth_per_step() leaves 1.
double finite_stable_step(const LinearChain& chain, ExplicitScheme scheme, ChainEnds ends,
                          bool planar = false);

/// T_R = pi R sqrt(rho/G)/(0.1631 nu + 0.8766) [s]: time of the Rayleigh wave around half a sphere, the time
/// step rule of sphere contact. Throws InvalidArgument.
double rayleigh_step(const ChainMaterial& material);

}  // namespace fiberchain::reference
