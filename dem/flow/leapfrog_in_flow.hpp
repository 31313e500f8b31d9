#pragma once

#include "dem/flow/integrate_in_flow.hpp"

namespace fiberchain::dem {

/// integrate_in_flow() by the leapfrog.
template <int Dim>
FlowRecord leapfrog_in_flow(const FlowCase<Dim>& flow, const std::vector<double>& times,
                            const FlowOptions& options, const FlowSample<Dim>& sample);

/// A fiber to follow and the times of interest.
template <int Dim>
struct FlowJob {
  FlowCase<Dim> flow;
  std::vector<double> times;
};

/// The state of a job at one of its times.
template <int Dim>
using FlowJobSample = std::function<void(std::size_t job, double time, const ChainState<Dim>& state)>;

/// leapfrog_in_flow() of many fibers. Those of one length that take equal numbers of steps march side by
/// side; a record does not depend on what marches beside it but by round-off where a fiber marches alone. One
/// that blows up stops, the others go on.
template <int Dim>
std::vector<FlowRecord> leapfrog_many_in_flow(const std::vector<FlowJob<Dim>>& jobs,
                                              const FlowOptions& options, const FlowJobSample<Dim>& sample);

}  // namespace fiberchain::dem
