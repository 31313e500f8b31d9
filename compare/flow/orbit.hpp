#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/flow/history.hpp"
#include "compare/study/jobs.hpp"

// Orbits of chains in simple shear u = rate (y, 0, 0), stiff enough to be held against Jeffery's.
namespace fiberchain::compare {

/// A straight chain let go in shear. Everything is dimensionless: the result does not depend on E, d and
/// viscosity.
struct OrbitCase {
  int spheres = 11;
  dem::Hydrodynamics hydrodynamics = dem::Hydrodynamics::free_draining;
  Triple direction = {0, 1, 0};  ///< of the fiber at the start; with z = 0 the chain is planar
  double elasto_viscous = 0.01;  ///< 3 pi mu rate L^4/(E I)
  double turns = 0.5;            ///< how long, in periods of the free-draining chain, and a quarter more
  double interval = 0.1;         ///< strain between samples
  double tolerance = 1e-9;
  double poisson_ratio = 0.3;
  bool spatial = false;  ///< in space even in the plane z = 0
};

struct OrbitPoint {
  OrbitCase asked;
  double period = 0;         ///< rate times period; NaN without a half turn
  double bending_angle = 0;  ///< largest of a bond [rad]
  double stretch = 0;        ///< largest |end_to_end - 1|
  FlowHistory history;       ///< times are strains: the rate is 1
  std::string status;        ///< "finished", else why not
};

struct OrbitOptions {
  Jobs jobs = 1;
  std::function<void()> advance = [] {};  ///< called after each case, from any thread
};

/// Every case, in the order given. Throws dem::InvalidInput for a case out of range.
std::vector<OrbitPoint> orbit_points(const std::vector<OrbitCase>& cases, const OrbitOptions& options = {});

}  // namespace fiberchain::compare
