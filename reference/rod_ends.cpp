#include "reference/rod_ends.hpp"

namespace fiberchain::reference::detail {
namespace {

using Eigen::Matrix3d;
using Rows = Eigen::Matrix<double, 3, 13>;

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return m;
}

Eigen::Quaterniond turned(const Vector3d& by) {
  const double angle = by.norm();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, angle > 0 ? Vector3d(by / angle) : Vector3d::UnitX()));
}

/// Half the sum of t_i x e_i over target and section's axes: zero where they agree.
void clamped_rows(const EndTarget& target, const SectionState& at, const Rows& turn, double factor,
                  EndCondition& out) {
  const Vector3d rate = vector(target.end.turned);
  const Matrix3d T = (turned(factor * rate) * target.frame).toRotationMatrix(),
                 E = at.frame.toRotationMatrix();
  Vector3d sum = Vector3d::Zero(), by_factor = Vector3d::Zero();
  Matrix3d by_turn = Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vector3d t = T.col(i), e = E.col(i);
    sum += t.cross(e);
    by_factor += rate.cross(t).cross(e);
    by_turn += t.dot(e) * Matrix3d::Identity() - e * t.transpose();  // t x (turn x e)
  }
  out.residual.tail<3>() = sum / 2;
  out.slope.bottomRows<3>() = by_turn / 2 * turn;
  out.slope.bottomRows<3>().col(12) += by_factor / 2;
}

/// The hinge's axis stays where it is, the moment about it is given; without an axis all of the moment.
void moment_rows(const EndTarget& target, const EndLoads& loads, const SectionState& at, const Rows& turn,
                 const Rows& moment, double factor, EndCondition& out) {
  Vector3d miss = target.outward * at.moment - loads.moment - factor * loads.moment_rate;
  Rows by = target.outward * moment;
  by.col(12) -= loads.moment_rate;
  if (target.end.joint == RodJoint::hinge) {
    const Vector3d a = vector(target.end.hinge_axis).normalized(),
                   now = at.frame * (target.frame.conjugate() * a);
    const Matrix3d onto = a * a.transpose();
    miss = Vector3d(a.cross(now) + onto * miss);
    by = Rows(onto * by - cross_matrix(a) * cross_matrix(now) * turn);
  }
  out.residual.tail<3>() = miss;
  out.slope.bottomRows<3>() = by;
}

void place_rows(const EndTarget& target, const EndLoads& loads, const SectionState& at,
                const Eigen::Matrix<double, 12, 13>& by, double factor, EndCondition& out) {
  const Vector3d rate = vector(target.end.moved), miss = at.position - target.position - factor * rate;
  const Vector3d follows = at.frame * Vector3d(loads.following + factor * loads.following_rate),
                 follows_rate = at.frame * loads.following_rate;
  const Vector3d unbalanced = target.outward * at.force - loads.force - factor * loads.force_rate - follows;
  Rows place = by.topRows<3>();
  place.col(12) -= rate;
  Rows force = target.outward * by.middleRows<3>(6) + cross_matrix(follows) * by.middleRows<3>(3);
  force.col(12) -= loads.force_rate + follows_rate;
  for (int i = 0; i < 3; ++i) {
    const bool held = target.end.held[static_cast<std::size_t>(i)];
    out.residual[i] = held ? miss[i] : unbalanced[i];
    out.slope.row(i) = held ? place.row(i) : force.row(i);
  }
}

}  // namespace

EndCondition condition(const EndTarget& target, const EndLoads& loads, const SectionState& at,
                       const Eigen::Matrix<double, 12, 13>& by, double factor) {
  EndCondition out{};
  place_rows(target, loads, at, by, factor, out);
  const Rows turn = by.middleRows<3>(3), moment = by.bottomRows<3>();
  if (target.end.joint == RodJoint::clamped)
    clamped_rows(target, at, turn, factor, out);
  else
    moment_rows(target, loads, at, turn, moment, factor, out);
  return out;
}

}  // namespace fiberchain::reference::detail
