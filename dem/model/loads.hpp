#pragma once

#include <vector>

#include "dem/math/vec.hpp"

namespace fiberchain::dem {

/// A dead load: keeps its direction however the sphere moves or turns.
template <int Dim>
struct Load {
  int sphere;
  Vec<double, Dim> force;    ///< [N]
  Spin<double, Dim> moment;  ///< [N m]
};

/// Clamped spheres keep position and rotation; loads act at sphere centers.
template <int Dim>
struct Boundary {
  std::vector<int> clamped;
  std::vector<Load<Dim>> loads;
};

}  // namespace fiberchain::dem
