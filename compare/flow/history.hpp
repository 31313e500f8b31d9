#pragma once

#include <array>
#include <vector>

#include "dem/flow/integrate_in_flow.hpp"
#include "dem/scene/build_fiber.hpp"

// What a fiber in a flow does, measured at moments of its history.
namespace fiberchain::compare {

using Triple = std::array<double, 3>;

/// The fiber at one moment.
struct FlowMoment {
  double time;            ///< [s]
  Triple direction;       ///< unit vector from the first sphere to the last
  Triple direction_rate;  ///< its change [1/s]
  Triple center;          ///< of mass, over L
  double end_to_end;      ///< distance of the end spheres over that of the straight fiber
  double bending_angle;   ///< largest of a bond [rad]
  double energy;          ///< elastic, U L/(E I)
};

/// Places of the spheres at one moment, over L.
struct FlowShape {
  double time;  ///< [s]
  std::vector<Triple> spheres;
};

struct FlowHistory {
  std::vector<FlowMoment> moments;
  std::vector<FlowShape> shapes;
  dem::FlowRecord record;
  double run_time;  ///< [s]
};

using dem::even_times;

/// Follows the fiber; the shape of every `shape_interval`-th moment is kept, none with 0. L is the length of
/// the bonds. Throws as dem::integrate_in_flow.
template <int Dim>
FlowHistory integrate_in_flow_history(const dem::FlowCase<Dim>& flow, const std::vector<double>& times,
                                      const dem::FlowOptions& options, int shape_interval = 0);

}  // namespace fiberchain::compare
