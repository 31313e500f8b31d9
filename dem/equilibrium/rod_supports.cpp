#include "dem/equilibrium/rod_supports.hpp"

#include <cmath>

#include "dem/equilibrium/rod_loads.hpp"

namespace fiberchain::dem {
namespace {

using V = Vec<double, 3>;
using Eigen::Vector3d;
using tangent_detail::eigen;

V axis_of(const Quaternion<double>& axes, int k) {
  V unit{};
  unit[k] = 1;
  return rotate(axes, unit);
}

V vec(const Vector3d& v) { return {v[0], v[1], v[2]}; }

/// Where a clamp's orientation shall go, along its turns of motion.
void hold_clamp(HeldSphere& s, const RodSupport& support, const Quaternion<double>& start,
                const Quaternion<double>& now, double factor) {
  const Quaternion<double> target = rotation(factor * support.turned) * start;
  const Eigen::Matrix3d axes = s.directions.bottomRightCorner<3, 3>();
  s.missing.tail<3>() = axes.transpose() * eigen(rotation_vector(target * conjugate(now)));
  s.rate.tail<3>() = axes.transpose() * eigen(support.turned);
}

/// A hinge about axis `free`: the sphere's own axis that was there comes back to it.
void hold_hinge(HeldSphere& s, int free, const Quaternion<double>& since_start) {
  const V a = vec(s.directions.col(3 + free).tail<3>());
  const Vector3d back = eigen(cross(rotate(since_start, a), a));
  for (int k = 0; k < 3; ++k) {
    if (k != free) s.missing[3 + k] = back.dot(s.directions.col(3 + k).tail<3>());
  }
}

/// A universal joint with axis `held`: outer axis o in space, inner axis i carried by the sphere, which stays
/// across o; the third motion, about n = o x i, is the held one. A turn of c about n takes c off i.o.
void hold_universal(HeldSphere& s, int held, const Quaternion<double>& since_start) {
  const int outer = (held + 1) % 3, inner = (held + 2) % 3;
  const V o = vec(s.directions.col(3 + outer).tail<3>());
  const V i = rotate(since_start, vec(s.directions.col(3 + inner).tail<3>()));
  const V n = cross(o, i);
  s.directions.col(3 + inner).tail<3>() = eigen(i);
  s.directions.col(3 + held).tail<3>() = eigen((1 / norm(n)) * n);
  s.missing[3 + held] = dot(i, o);
  s.turned = true;
  s.outer = 3 + outer;
  s.inner = 3 + inner;
}

void hold_rotation(HeldSphere& s, const RodSupport& support, const Pose<double, 3>& start,
                   const Pose<double, 3>& now, double factor) {
  const auto& hold = support.hold_rotation;
  const int count = hold[0] + hold[1] + hold[2];
  const Quaternion<double> since_start = now.orientation * conjugate(start.orientation);
  const auto the = [&](bool which) { return hold[0] == which ? 0 : hold[1] == which ? 1 : 2; };
  if (count == 3) hold_clamp(s, support, start.orientation, now.orientation, factor);
  if (count == 2) hold_hinge(s, the(false), since_start);
  if (count == 1) hold_universal(s, the(true), since_start);
}

void hold(HeldSphere& s, const RodSupport& support, const Pose<double, 3>& start, const Pose<double, 3>& now,
          double factor) {
  for (int k = 0; k < 3; ++k) {
    s.held[static_cast<std::size_t>(k)] = support.hold_displacement[static_cast<std::size_t>(k)];
    s.held[static_cast<std::size_t>(3 + k)] = support.hold_rotation[static_cast<std::size_t>(k)];
    s.directions.block<3, 1>(0, k) = s.directions.block<3, 1>(3, 3 + k) = eigen(axis_of(support.axes, k));
  }
  s.turned = support.axes.w * support.axes.w < 1;
  const Eigen::Matrix3d axes = s.directions.topLeftCorner<3, 3>();
  s.missing.head<3>() = axes.transpose() * eigen(start.position + factor * support.moved - now.position);
  s.rate.head<3>() = axes.transpose() * eigen(support.moved);
  hold_rotation(s, support, start, now, factor);
}

/// Rows and columns of one sphere in its support's motions, held rows as identities.
void apply(const HeldSphere& s, std::size_t i, RodSystem& system) {
  ChainTangent<3>& K = system.K;
  const std::size_t last = system.held.size() - 1;
  if (s.turned) {
    const auto& T = s.directions;
    const Vector3d moment = system.unbalanced[i].tail<3>();
    system.unbalanced[i] = (T.transpose() * system.unbalanced[i]).eval();
    system.by_factor[i] = (T.transpose() * system.by_factor[i]).eval();
    K.diagonal[i] = (T.transpose() * K.diagonal[i] * T).eval();
    if (i > 0) {
      K.lower[i] = (T.transpose() * K.lower[i]).eval();
      K.upper[i - 1] = (K.upper[i - 1] * T).eval();
    }
    if (i < last) {
      K.upper[i] = (T.transpose() * K.upper[i]).eval();
      K.lower[i + 1] = (K.lower[i + 1] * T).eval();
    }
    if (s.inner >= 0) {  // the inner axis turns about the outer one: d(i.m) = (o x i).m
      const Vector3d o = T.col(s.outer).tail<3>(), inner = T.col(s.inner).tail<3>();
      K.diagonal[i](s.inner, s.outer) -= o.cross(inner).dot(moment);
    }
  }
  for (int k = 0; k < 6; ++k) {
    if (!s.held[static_cast<std::size_t>(k)]) continue;
    K.lower[i].row(k).setZero();
    K.upper[i].row(k).setZero();
    K.diagonal[i].row(k).setZero();
    K.diagonal[i](k, k) = 1;
    system.unbalanced[i][k] = s.missing[k];
    system.by_factor[i][k] = -s.rate[k];
  }
}

}  // namespace

std::vector<HeldSphere> held_spheres(const RodProblem& problem, const Poses<3>& start, const Poses<3>& poses,
                                     double factor) {
  std::vector<HeldSphere> held(poses.size());
  const auto hold_one = [&](RodSupport support) {
    if (problem.planar) {
      support.hold_displacement[2] = support.hold_rotation[0] = support.hold_rotation[1] = true;
    }
    const auto i = static_cast<std::size_t>(support.sphere);
    hold(held[i], support, start[i], poses[i], factor);
  };
  for (const RodSupport& support : problem.supports) hold_one(support);
  for (std::size_t i = 0; problem.planar && i < held.size(); ++i) {
    if (!held[i].any()) {
      hold_one({.sphere = static_cast<int>(i),
                .hold_displacement = {false, false, true},
                .hold_rotation = {true, true, false}});
    }
  }
  return held;
}

RodSystem rod_system(const RodProblem& problem, const Poses<3>& start, const Poses<3>& poses, double factor) {
  RodSystem system{rod_stiffness(problem, poses, factor), rod_forces(problem, poses, factor),
                   ChainVector<3>(poses.size(), SphereVector<3>::Zero()),
                   held_spheres(problem, start, poses, factor)};
  add_loads(problem, poses, {.steady = 0, .scaled = -1}, system.by_factor);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (system.held[i].any()) apply(system.held[i], i, system);
  }
  return system;
}

ChainTangent<3> held_tangent(const RodProblem& problem, const RodSystem& system, double lambda) {
  ChainTangent<3> A = system.K;
  const Fiber& fiber = problem.chain.fiber;
  const double length = fiber_length(fiber), unit = lambda * bending_stiffness(fiber) / length;
  SphereVector<3> w = SphereVector<3>::Constant(unit);
  w.head<3>() /= length * length;
  const std::size_t last = system.held.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    for (int k = 0; k < 6; ++k) {
      if (!system.held[i].held[static_cast<std::size_t>(k)]) {
        A.diagonal[i](k, k) -= w[k];
        continue;
      }
      if (i > 0) A.upper[i - 1].col(k).setZero();
      if (i < last) A.lower[i + 1].col(k).setZero();
      A.diagonal[i].col(k).setZero();
      A.diagonal[i](k, k) = 1;
    }
  }
  return A;
}

void to_global(const std::vector<HeldSphere>& held, ChainVector<3>& motion) {
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (held[i].turned) motion[i] = (held[i].directions * motion[i]).eval();
  }
}

}  // namespace fiberchain::dem
