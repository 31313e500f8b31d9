#pragma once

#include <vector>

#include "dem/assembly/assembly.hpp"

// A rod of uniform curvature, clamped at one end, whose other end is let go (Audoly & Neukirch, Phys. Rev.
// Lett. 95, 095505, 2005). Of a beam let go at once the curvature is 2 kappa_0 S(x), S Fresnel's integral, x
// = s / sqrt(2 pi c t) with s from the free end on and c^2 = E I over the mass per length: its largest
// value, 1.428 kappa_0, is at x = sqrt(2), whatever the time.
namespace fiberchain::compare {

struct ReleasedRod {
  dem::Fiber fiber;
  double curvature;  ///< kappa_0 [1/m]
  /// Diameters that the largest curvature of a beam goes while the end is let go: at once, spheres near it
  /// feel that they are spheres.
  double release_way = 12;
};

/// A slender rod by no round numbers, its curvature small: L kappa_0 = 0.05.
ReleasedRod released_rod(int aspect_ratio);

/// When the largest curvature of a beam is so many diameters from the free end [s].
double time_of_way(const dem::Fiber& fiber, double diameters);

/// Diameters that it goes before the fastest waves can be back from the clamp, which go about a fifth of the
/// square of that.
double undisturbed_way(int aspect_ratio);

/// The largest value of 2 S(x) [-].
double largest_curvature_of_beam();

/// Bending stress of the rod before it is let go, E R kappa_0 [Pa].
double stress_at_rest(const ReleasedRod& rod);

/// Straight bonds with this angle between their ends, spheres turned with them: a moment at its ends holds
/// it.
dem::ChainState<3> arc(const dem::Chain<3>& chain, double angle);

/// The rod at the moment its end begins to be let go.
/// @throws dem::InvalidInput for a step or a scheme that its bonds do not bear
dem::Assembly assembly_of(const ReleasedRod& rod, dem::AssemblyOptions options);

/// The largest curvature of a bond over kappa_0 until it has gone undisturbed_way().
double largest_curvature(const ReleasedRod& rod, const dem::AssemblyOptions& options);

/// Bonds that broke until then.
std::vector<dem::BondBreak> breaks_of(const ReleasedRod& rod, const dem::AssemblyOptions& options);

}  // namespace fiberchain::compare
