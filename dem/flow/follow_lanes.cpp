#include "dem/flow/follow_lanes.hpp"

#include "dem/errors.hpp"

namespace fiberchain::dem {

template <int Dim>
FlowRecord follow_by_leapfrog(const FlowCase<Dim>&, const std::vector<double>&, const FlowOptions&, const FlowSample<Dim>&) {
  throw InvalidInput("method: leapfrog is not built");
}

template FlowRecord follow_by_leapfrog<2>(const FlowCase<2>&, const std::vector<double>&, const FlowOptions&,
                                          const FlowSample<2>&);
template FlowRecord follow_by_leapfrog<3>(const FlowCase<3>&, const std::vector<double>&, const FlowOptions&,
                                          const FlowSample<3>&);

}  // namespace fiberchain::dem
