#pragma once

#include <Eigen/Dense>
#include <span>
#include <string>
#include <vector>

#include "reference/beam_history.hpp"
#include "reference/cvode.hpp"

namespace fiberchain::reference::detail {

/// Samples by CVODE of a beam with rhs(), jacobian() and sample() of its state, from `start` at time 0.
template <class Beam>
BeamHistory march_beam(const Beam& beam, const Eigen::VectorXd& start, const std::vector<double>& times,
                       const BeamResolution& resolution, const std::string& name) {
  const auto size = start.size();
  const auto view = [size](std::span<const double> state) {
    return Eigen::Map<const Eigen::VectorXd>(state.data(), size);
  };
  const std::span<const double> start_state(start.data(), static_cast<std::size_t>(size));
  Cvode cvode(
      resolution.method,
      [&](double, std::span<const double> state, std::span<double> derivative) {
        beam.rhs(view(state), {derivative.data(), size});
      },
      [&](double, std::span<const double> state, std::span<double> jacobian) {
        beam.jacobian(view(state), {jacobian.data(), size, size});
      },
      0, start_state, resolution.tolerances, name);
  BeamHistory history;
  for (const double time : times) {
    history.samples.push_back(beam.sample(time, view(time == 0 ? start_state : cvode.advance(time))));
  }
  history.statistics = cvode.statistics();
  return history;
}

}  // namespace fiberchain::reference::detail
