#include "dem/chain/bending.hpp"

#include <cmath>

namespace fiberchain::dem {

using V = Vec<double, 3>;

double angle_between(const V& a, const V& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

double bending_angle(const Chain<3>& chain, const Poses<3>& poses, int bond) {
  Quaternion<double> first = poses[bond].orientation, second = poses[bond + 1].orientation;
  if (!chain.natural.empty()) {
    first = first * chain.natural[bond].first;
    second = second * chain.natural[bond].second;
  }
  if (const double angle = chain.fiber.rest_angle; angle != 0) {
    first = first * rotation({0, 0, angle / 2});
    second = second * rotation({0, 0, -angle / 2});
  }
  return angle_between(rotate(first, V{1, 0, 0}), rotate(second, V{1, 0, 0}));
}

double turning_angle(const Poses<3>& poses, int sphere) {
  return angle_between(poses[sphere].position - poses[sphere - 1].position,
                       poses[sphere + 1].position - poses[sphere].position);
}

}  // namespace fiberchain::dem
