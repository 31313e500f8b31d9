#include "dem/chain/rod_shapes.hpp"

#include <fmt/format.h>

#include <cmath>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

using V = Vec<double, 3>;

/// The least rotation that turns the unit vector a to b; about y, or z, for opposite ones.
Quaternion<double> least_turn(const V& a, const V& b) {
  const double w = 1 + dot(a, b);
  if (w > 1e-12) return normalized(Quaternion<double>{w, cross(a, b)});
  const V other = std::abs(a[1]) < 0.9 ? V{0, 1, 0} : V{0, 0, 1};
  const V n = other - dot(other, a) * a;
  return {0, (1 / norm(n)) * n};
}

/// Bonds of a member from one point to the next.
int bonds_between(const V& from, const V& to, double l, std::size_t member) {
  const double bonds = norm(to - from) / l;
  const double whole = std::round(bonds);
  if (!(whole >= 1) || !(whole < 1e6) || std::abs(bonds - whole) > 1e-6) {
    throw InvalidInput(
        fmt::format("points {} and {} are {:.9g} bonds of {:.6g} m apart, which is not allowed: it must be a "
                    "whole number",
                    member, member + 1, bonds, l));
  }
  return static_cast<int>(whole);
}

/// A straight chain's fiber and a copy of it with the poses still to be set.
Chain<3> without_arc(const Fiber& fiber, std::string_view what) {
  if (fiber.rest_angle != 0) {
    throw InvalidInput(
        fmt::format("rest_angle = {} is not allowed: {} has straight bonds", fiber.rest_angle, what));
  }
  return straight_chain<3>(fiber);
}

}  // namespace

Chain<3> arc_rod(const Fiber& fiber) {
  check(fiber);
  Fiber straight = fiber;
  straight.rest_angle = 0;
  Chain<3> chain = straight_chain<3>(straight);
  chain.fiber = fiber;
  V place{};
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    chain.poses[static_cast<std::size_t>(i)] = {place, rotation({0, 0, i * fiber.rest_angle})};
    const double along = (i + 0.5) * fiber.rest_angle;
    place = place + bond_length(fiber) * V{std::cos(along), std::sin(along), 0};
  }
  return chain;
}

Chain<3> rod_through(const Fiber& fiber, const std::vector<V>& points) {
  Chain<3> chain = without_arc(fiber, "a rod through points");
  if (points.size() < 2) {
    throw InvalidInput(fmt::format("points: {} of them are not allowed: a rod has two ends", points.size()));
  }
  chain.natural.assign(static_cast<std::size_t>(fiber.aspect_ratio), {{1, {0, 0, 0}}, {1, {0, 0, 0}}});
  V before{1, 0, 0};
  Quaternion<double> axes{1, {0, 0, 0}};
  std::size_t sphere = 0;
  for (std::size_t m = 0; m + 1 < points.size(); ++m) {
    const int bonds = bonds_between(points[m], points[m + 1], bond_length(fiber), m);
    if (sphere + static_cast<std::size_t>(bonds) >= chain.poses.size()) {
      throw InvalidInput(
          fmt::format("aspect_ratio = {} is not allowed: the points are further apart", fiber.aspect_ratio));
    }
    const V step = (1.0 / bonds) * (points[m + 1] - points[m]), along = (1 / norm(step)) * step;
    const Quaternion<double> turn = least_turn(before, along), next = normalized(turn * axes);
    if (m == 0) chain.poses[0] = {points[0], next};
    if (m > 0) chain.natural[sphere].first = normalized(conjugate(axes) * next);
    for (int i = 1; i <= bonds; ++i)
      chain.poses[++sphere] = {points[m] + static_cast<double>(i) * step, next};
    before = along;
    axes = next;
  }
  if (sphere + 1 != chain.poses.size()) {
    throw InvalidInput(fmt::format("aspect_ratio = {} is not allowed: the points are {} bonds apart",
                                   fiber.aspect_ratio, sphere));
  }
  return chain;
}

Chain<3> placed(Chain<3> chain, const Quaternion<double>& q, const V& moved) {
  for (auto& pose : chain.poses) {
    pose = {rotate(q, pose.position) + moved, normalized(q * pose.orientation)};
  }
  return chain;
}

}  // namespace fiberchain::dem
