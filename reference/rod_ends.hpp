#pragma once

#include "reference/rod_shooting.hpp"

// What holds and loads an end of a rod as equations: six at each end.
namespace fiberchain::reference::detail {

struct EndTarget {
  RodEnd end;
  Vector3d position;         ///< where it is held at load factor 0
  Eigen::Quaterniond frame;  ///< likewise
  double outward;            ///< 1 at the end, -1 at the begin: n times it is what the outside puts on it
};

/// Loads at factor 0 and their rates by it.
struct EndLoads {
  Vector3d force, force_rate, moment, moment_rate, following, following_rate;
};

struct EndCondition {
  Eigen::Matrix<double, 6, 1> residual;
  Eigen::Matrix<double, 6, 13> slope;
};

/// @param by derivatives of position, turn, force and moment at the end by the unknowns
EndCondition condition(const EndTarget& target, const EndLoads& loads, const SectionState& at,
                       const Eigen::Matrix<double, 12, 13>& by, double factor);

}  // namespace fiberchain::reference::detail
