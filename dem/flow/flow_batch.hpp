#pragma once

#include "dem/flow/leapfrog_in_flow.hpp"
#include "dem/motion/kernels/chain_batch.hpp"

namespace fiberchain::dem {

/// What the leapfrog does to take a fiber to its times.
struct FlowPlan {
  double stable;                ///< largest stable step [s]
  std::vector<double> lengths;  ///< of the steps that lead to each time [s]
  std::vector<double> counts;   ///< whole steps from the time before; 0 where it is the same
  Clamps clamps;
};

/// Throws InvalidInput for a case that makes no sense or is not built, or a step asked for that is unstable.
template <int Dim>
FlowPlan plan_of(const FlowCase<Dim>& flow, const std::vector<double>& times, const FlowOptions& options);

/// Fibers of one length and kind that march side by side, with equal numbers of steps.
template <int Dim>
class FlowBatch {
 public:
  struct Member {
    const FlowCase<Dim>* flow;
    const std::vector<double>* times;
    FlowPlan plan;
  };

  FlowBatch(std::vector<Member> members, const FlowOptions& options);

  /// To the last time, handing out states on the way; `sample` gets the number of the member.
  std::vector<FlowRecord> run(const FlowJobSample<Dim>& sample);

 private:
  struct Lane {
    double step, time = 0;  ///< the step at hand, the time reached [s]
    FlowRecord record{};
  };

  void take_step(std::size_t lane, double step);
  void stretch(int steps);
  void find_break(std::size_t lane, int steps);
  void count(std::size_t lane, int steps);
  bool whole(std::size_t lane) const { return lanes_[lane].record.failure.empty(); }

  std::vector<Member> members_;
  ChainBatch<Dim> block_;
  std::vector<Lane> lanes_;
};

}  // namespace fiberchain::dem
