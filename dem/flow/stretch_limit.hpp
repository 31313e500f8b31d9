#pragma once

#include <string>

#include "dem/chain/chain.hpp"
#include "dem/model/fluid.hpp"

// A flow that draws a fiber out faster than its bonds pull it back has no shape to come to: their springs are
// linear and the drag grows with the length.
namespace fiberchain::dem {

/// Rate of stretching along the fiber [1/s] beyond which the bonds cannot hold it: K_n / (6 pi mu R) times
/// 4 sin^2(pi / (2 N)), the slowest of N free draining spheres on a line. With interactions it is larger.
double bearable_stretching(const Fiber& fiber, const Fluid& fluid);

/// Largest rate [1/s] at which a flow stretches a line in it: of the symmetric part of its gradient.
double largest_stretching(const Gradient& gradient);

/// What tears a fiber out, with both rates.
std::string stretch_cause(const Fiber& fiber, const Fluid& fluid, double time);

/// Names the bond, the time and the rates where a bond is ten times as long as at rest; empty where none is.
template <int Dim>
std::string stretch_failure(const Chain<Dim>& chain, const Poses<Dim>& poses, const Fluid& fluid,
                            double time);

}  // namespace fiberchain::dem
