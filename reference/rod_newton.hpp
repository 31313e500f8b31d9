#pragma once

#include <vector>

#include "reference/rod_shooting.hpp"

// Newton's method for what is unknown at a rod's begin, at a load factor or along a path.
namespace fiberchain::reference::detail {

/// An equilibrium in scaled units.
struct RodPoint {
  SectionState begin;
  double factor;
  Shot shot;
  Unknowns tangent = Unknowns::Unit(12);  ///< of the path
};

/// A row that the step along a path has to meet: row . increments = value.
struct StepRow {
  Unknowns row;
  double value;
};

/// From `start` by Newton's method; increments are held to `step`, or the load factor where it is.
/// Throws NoConvergence.
RodPoint converged(const ScaledRod& rod, const SectionState& start, double factor, const StepRow& step);

/// The path's unit tangent in this metric, on the side of `along`.
Unknowns tangent(const ScaledRod& rod, const ResidualSlope& slope, const Unknowns& along);

/// Weights of the unknowns in a path's length.
Unknowns metric(const ScaledRod& rod);

RodEquilibrium equilibrium_of(const ScaledRod& rod, const RodPoint& point);

}  // namespace fiberchain::reference::detail
