#include "dem/run/frame_state.hpp"

#include <fmt/format.h>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

/// The spheres [from, to) of a frame, which are a fiber.
ChainState<3> fiber_in(const TrajectoryFrame& frame, std::size_t from, std::size_t to) {
  ChainState<3> fiber;
  for (std::size_t i = from; i < to; ++i) {
    if (frame.radius[i] != frame.radius[from])
      throw InvalidInput(fmt::format("fiber {} of the frame has spheres of several sizes", frame.fiber[i]));
    fiber.poses.push_back({frame.position[i], {}});
    fiber.velocity.push_back(frame.velocity[i]);
  }
  if (fiber.poses.size() < 2)
    throw InvalidInput(fmt::format("fiber {} of the frame is a single sphere", frame.fiber[from]));
  fiber.spin.resize(fiber.poses.size());
  orient_along(fiber);
  return fiber;
}

}  // namespace

CarriedState state_of_frame(const TrajectoryFrame& frame) {
  CarriedState state;
  state.time = frame.time;
  const std::size_t spheres = frame.position.size();
  for (std::size_t from = 0; from < spheres;) {
    std::size_t to = from + 1;
    while (to < spheres && frame.fiber[to] == frame.fiber[from]) ++to;
    ChainState<3> fiber = fiber_in(frame, from, to);
    const bool alike = !state.groups.empty() && state.groups.back().radius == frame.radius[from] &&
                       state.groups.back().spheres() == static_cast<int>(to - from);
    if (!alike)
      state.groups.push_back({.radius = frame.radius[from], .fibers = {}, .histories = {}, .loads = {}});
    state.groups.back().fibers.push_back(std::move(fiber));
    from = to;
  }
  return state;
}

}  // namespace fiberchain::dem
