#include "compare/flow/history.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace fiberchain::compare {
namespace {

template <int Dim>
Triple triple(double factor, const dem::Vec<double, Dim>& v) {
  Triple t{};
  for (int i = 0; i < Dim; ++i) t[static_cast<std::size_t>(i)] = factor * v[i];
  return t;
}

template <int Dim>
double largest_bend(const dem::Chain<Dim>& chain, const dem::Poses<Dim>& poses) {
  double largest = 0;
  for (int i = 0; i < chain.fiber.aspect_ratio; ++i) {
    largest = std::max(largest, dem::bend_squared(dem::bond_kinematics<Dim>(chain, poses, i).rotation));
  }
  return std::sqrt(largest);
}

template <int Dim>
FlowMoment moment_of(const dem::Chain<Dim>& chain, double time, const dem::ChainState<Dim>& state) {
  const double L = dem::fiber_length(chain.fiber);
  const auto& poses = state.poses;
  const auto span = poses.back().position - poses.front().position;
  const double distance = dem::norm(span);
  const auto p = (1 / distance) * span;
  const auto change = (1 / distance) * (state.velocity.back() - state.velocity.front());
  dem::Vec<double, Dim> sum{};
  for (const auto& pose : poses) sum = sum + pose.position;
  return {time,
          triple<Dim>(1, p),
          triple<Dim>(1, change - dem::dot(p, change) * p),
          triple<Dim>(1 / (L * static_cast<double>(poses.size())), sum),
          distance / L,
          largest_bend(chain, poses),
          dem::elastic_energy(chain, poses) * L / dem::bending_stiffness(chain.fiber)};
}

template <int Dim>
FlowShape shape_of(const dem::Chain<Dim>& chain, double time, const dem::Poses<Dim>& poses) {
  FlowShape shape{time, {}};
  for (const auto& pose : poses) {
    shape.spheres.push_back(triple<Dim>(1 / dem::fiber_length(chain.fiber), pose.position));
  }
  return shape;
}

}  // namespace

template <int Dim>
FlowHistory integrate_in_flow_history(const dem::FlowCase<Dim>& flow, const std::vector<double>& times,
                                      const dem::FlowOptions& options, int shape_interval) {
  FlowHistory history{};
  const auto begin = std::chrono::steady_clock::now();
  history.record =
      dem::integrate_in_flow<Dim>(flow, times, options, [&](double time, const dem::ChainState<Dim>& state) {
        if (shape_interval > 0 && history.moments.size() % static_cast<std::size_t>(shape_interval) == 0) {
          history.shapes.push_back(shape_of(flow.chain, time, state.poses));
        }
        history.moments.push_back(moment_of(flow.chain, time, state));
      });
  history.run_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return history;
}

template FlowHistory integrate_in_flow_history<2>(const dem::FlowCase<2>&, const std::vector<double>&,
                                                  const dem::FlowOptions&, int);
template FlowHistory integrate_in_flow_history<3>(const dem::FlowCase<3>&, const std::vector<double>&,
                                                  const dem::FlowOptions&, int);

}  // namespace fiberchain::compare
