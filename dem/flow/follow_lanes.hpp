#pragma once

#include "dem/flow/follow.hpp"

namespace fiberchain::dem {

/// follow() by the leapfrog.
template <int Dim>
FlowRecord follow_by_leapfrog(const FlowCase<Dim>& flow, const std::vector<double>& times, const FlowOptions& options,
                              const FlowSample<Dim>& sample);

}  // namespace fiberchain::dem
