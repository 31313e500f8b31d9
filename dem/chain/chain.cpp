#include "dem/chain/chain.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

Pose<double, 2> pose_along(const Vec<double, 2>& position, bool turned) {
  return {position, turned ? std::numbers::pi / 2 : 0.0};
}

Pose<double, 3> pose_along(const Vec<double, 3>& position, bool turned) {
  return {position, turned ? rotation({0, 0, std::numbers::pi / 2}) : Quaternion<double>{1, {0, 0, 0}}};
}

NaturalEnds<double, 2> no_offset(const Pose<double, 2>&) { return {0, 0}; }
NaturalEnds<double, 3> no_offset(const Pose<double, 3>&) { return {{1, {0, 0, 0}}, {1, {0, 0, 0}}}; }

/// Rotation that brings frame `from` to frame `to`, in the frame `from`.
double offset(double from, double to) { return to - from; }
Quaternion<double> offset(const Quaternion<double>& from, const Quaternion<double>& to) {
  return conjugate(from) * to;
}

}  // namespace

template <int Dim>
Chain<Dim> straight_chain(const Fiber& fiber) {
  check(fiber);
  if (fiber.rest_angle != 0) {
    throw InvalidInput(
        fmt::format("rest_angle = {} is not allowed: a straight chain has none", fiber.rest_angle));
  }
  Chain<Dim> chain{fiber, {}, {}};
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    chain.poses.push_back(pose_along(Vec<double, Dim>{i * bond_length(fiber)}, false));
  }
  return chain;
}

template <int Dim>
Chain<Dim> cornered_chain(const Fiber& fiber, int corner) {
  if (corner <= 0 || corner >= fiber.aspect_ratio) {
    throw InvalidInput(fmt::format("corner = {} is not allowed: it must lie between the end spheres 0 and {}",
                                   corner, fiber.aspect_ratio));
  }
  Chain<Dim> chain = straight_chain<Dim>(fiber);
  const double l = bond_length(fiber);
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    Vec<double, Dim> position{std::min(i, corner) * l, std::max(i - corner, 0) * l};
    chain.poses[i] = pose_along(position, i > corner);
  }
  chain.natural.assign(fiber.aspect_ratio, no_offset(chain.poses[0]));
  chain.natural[corner].first = offset(chain.poses[corner].orientation, chain.poses[corner + 1].orientation);
  return chain;
}

Chain<3> renumbered(const Chain<3>& chain) {
  // each sphere keeps its place; its axis points the other way: a half turn about its own y
  const Quaternion<double> flip{0, {0, 1, 0}};
  Chain<3> other = chain;
  const int bonds = chain.fiber.aspect_ratio;
  for (int i = 0; i <= bonds; ++i) {
    other.poses[i] = {chain.poses[bonds - i].position, chain.poses[bonds - i].orientation * flip};
  }
  for (int i = 0; i < static_cast<int>(chain.natural.size()); ++i) {
    const NaturalEnds<double, 3>& ends = chain.natural[bonds - 1 - i];
    other.natural[i] = {conjugate(flip) * ends.second * flip, conjugate(flip) * ends.first * flip};
  }
  return other;
}

template <int Dim>
BondKinematics<double, Dim> bond_kinematics(const Chain<Dim>& chain, const Poses<Dim>& poses, int bond) {
  if (chain.natural.empty()) return bond_kinematics(poses[bond], poses[bond + 1]);
  Pose<double, Dim> first = poses[bond], second = poses[bond + 1];
  first.orientation = turned(first.orientation, chain.natural[bond].first);
  second.orientation = turned(second.orientation, chain.natural[bond].second);
  return bond_kinematics(first, second);
}

template <int Dim>
double elastic_energy(const Chain<Dim>& chain, const Poses<Dim>& poses) {
  const BondParameters<double> bond = bond_parameters(chain.fiber);
  double energy = 0;
  for (int i = 0; i < chain.fiber.aspect_ratio; ++i) {
    const auto k = bond_kinematics(chain, poses, i);
    energy += bond_energy<double, Dim>(bond, k.separation, k.rotation);
  }
  return energy;
}

template Chain<2> straight_chain<2>(const Fiber&);
template Chain<3> straight_chain<3>(const Fiber&);
template Chain<2> cornered_chain<2>(const Fiber&, int);
template Chain<3> cornered_chain<3>(const Fiber&, int);
template BondKinematics<double, 2> bond_kinematics<2>(const Chain<2>&, const Poses<2>&, int);
template BondKinematics<double, 3> bond_kinematics<3>(const Chain<3>&, const Poses<3>&, int);
template double elastic_energy<2>(const Chain<2>&, const Poses<2>&);
template double elastic_energy<3>(const Chain<3>&, const Poses<3>&);

}  // namespace fiberchain::dem
