#include "dem/insertion/placement.hpp"

#include <fmt/format.h>

#include <cmath>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

/// Some unit vector across u, of length 1.
Vec<double, 3> across(const Vec<double, 3>& u) {
  const Vec<double, 3> other = std::abs(u[0]) < 0.6 ? Vec<double, 3>{1, 0, 0} : Vec<double, 3>{0, 1, 0};
  const Vec<double, 3> w = cross(u, other);
  return (1 / norm(w)) * w;
}

}  // namespace

Quaternion<double> rotation_between(const Vec<double, 3>& from, const Vec<double, 3>& to) {
  const Vec<double, 3> a = (1 / norm(from)) * from, b = (1 / norm(to)) * to;
  const double w = 1 + dot(a, b);
  // 1 + cos, sin: twice the half angle's, but for opposite directions
  if (w < 1e-12) return {0, across(a)};
  return normalized(Quaternion<double>{w, cross(a, b)});
}

ChainState<3> placed(const Chain<3>& chain, const Quaternion<double>& turn, const Vec<double, 3>& first,
                     const Vec<double, 3>& velocity) {
  Poses<3> poses;
  poses.reserve(chain.poses.size());
  for (const Pose<double, 3>& pose : chain.poses) {
    poses.push_back(
        {first + rotate(turn, pose.position - chain.poses.front().position), turn * pose.orientation});
  }
  ChainState<3> state = at_rest<3>(poses);
  state.velocity.assign(poses.size(), velocity);
  return state;
}

Vec<double, 3> end_to_end(const Poses<3>& poses) {
  const Vec<double, 3> r = poses.back().position - poses.front().position;
  const double bond = poses.size() > 1 ? norm(poses[1].position - poses[0].position) : 0;
  return norm(r) > 1e-6 * bond ? r : axis(poses.front());
}

ChainState<3> placed(const Chain<3>& chain, const FiberStart& start) {
  for (const auto& [what, u] : {std::pair{"position", start.position},
                                {"direction", start.direction},
                                {"velocity", start.velocity}}) {
    if (!std::isfinite(norm(u))) throw InvalidInput(fmt::format("{} of a fiber is not finite", what));
  }
  if (!(norm(start.direction) > 0))
    throw InvalidInput("direction of a fiber is (0, 0, 0): it must point somewhere");
  return placed(chain, rotation_between(axis(chain.poses.front()), start.direction), start.position,
                start.velocity);
}

}  // namespace fiberchain::dem
