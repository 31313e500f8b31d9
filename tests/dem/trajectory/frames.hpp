#pragma once

#include <cmath>
#include <cstdint>

#include "dem/trajectory/frame.hpp"
#include "dem/trajectory/wall_surface.hpp"

namespace fiberchain::test {

/// Bent fibers that turn and sink: no number in it is round, and each differs from every other.
inline dem::TrajectoryFrame bent_fibers(int fibers, int spheres, std::int64_t step) {
  dem::TrajectoryFrame frame{};
  frame.time = 1.7e-4 * static_cast<double>(step);
  frame.step = step;
  frame.low = {-0.011, 0.002, -0.03};
  frame.high = {0.093, 0.107, 0.11 - 1e-5 * static_cast<double>(step)};
  frame.periodic[0] = frame.periodic[2] = true;
  for (int f = 0; f < fibers; ++f) {
    const double radius = 1.1e-3 * (1 + 0.3 * std::sin(f)), spin = 0.4 * f + 3 * frame.time;
    for (int i = 0; i < spheres; ++i) {
      const double s = 2 * radius * i, bend = 20 * s * s * (1 + 0.1 * f);
      frame.position.push_back({0.01 + s * std::cos(spin) - bend * std::sin(spin),
                                0.02 + s * std::sin(spin) + bend * std::cos(spin),
                                0.004 * f - 0.3 * frame.time});
      frame.velocity.push_back({-3 * s * std::sin(spin), 3 * s * std::cos(spin), -0.3 - 0.01 * i + 0.02 * f});
      frame.radius.push_back(radius);
      frame.fiber.push_back(f);
      if (i == 0) continue;
      const auto first = static_cast<std::int64_t>(frame.position.size()) - 2;
      frame.bonds.push_back(
          {first, {1e-3 * i, -2e-4 * f, 1e-5 * static_cast<double>(step)}, 0.01 * i + 1e-4 * f + frame.time});
    }
  }
  return frame;
}

/// With a contact of every kind, of numbers that no float holds.
inline dem::TrajectoryFrame with_contacts(dem::TrajectoryFrame frame) {
  const double t = 0.1 + frame.time;
  frame.has_contacts = true;
  frame.contacts = {
      {0, 7, dem::ContactKind::fibers, {t, 0.2, 0.3}, {0.6, 0, 0.8}, {1e-3 * t, -2e-4, 3e-5}},
      {3, 2, dem::ContactKind::wall, {0.01, t, 0.03}, {0, -1, 0}, {1e-5, 2e-3 * t, 0}},
      {1, 4, dem::ContactKind::same_fiber, {0.04, 0.01, t}, {0, 0.8, -0.6}, {0.1, 0.2, 0.3 * t}}};
  return frame;
}

/// A triangle and a square.
inline std::vector<dem::WallSurface> two_walls() {
  return {{"plane", {{0, 0, 0}, {0.1, 0, 0.01}, {0, 0.3, 0}}, {{0, 1, 2}}},
          {"box obstacle", {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, {{0, 1, 2}, {0, 2, 3}}}};
}

/// The same somewhere else at every step.
inline dem::TrajectoryFrame with_walls(dem::TrajectoryFrame frame) {
  const double t = 0.3 + frame.time;
  frame.walls = {{{t, 0, 0.2}, dem::rotation(dem::Vec<double, 3>{t, 0.1, 0}), true},
                 {{0.1, -t, 0}, {1, {}}, frame.step != 10}};
  return frame;
}

}  // namespace fiberchain::test
