#include "dem/contact/wall_view.hpp"

namespace fiberchain::dem {

WallView wall_view_at(const Wall& wall, int shape_index, WallNeighbors& near, const double* parameters,
                      double time, double step) {
  WallView view{};
  const WallPose pose = pose_at(wall, time);
  const WallVelocity motion = velocity_at(wall, time - 0.5 * step);
  wall.shape.numbers(pose, view.shape);
  view.shape_index = shape_index;
  for (int c = 0; c < 3; ++c) {
    view.center[c] = pose.center_now()[c];
    view.velocity[c] = motion.velocity[c];
    view.spin[c] = motion.spin[c];
  }
  view.slots = near.slots.data();
  view.count = static_cast<std::int32_t>(near.slots.size());
  view.nearest = near.nearest.data();
  view.contact = near.contact.data();
  view.parameters = parameters;
  return view;
}

}  // namespace fiberchain::dem
