#include "reference/rod_shooting.hpp"

#include <array>
#include <cmath>

#include "reference/gsl_ode.hpp"
#include "reference/rod_ends.hpp"

namespace fiberchain::reference::detail {
namespace {

using Eigen::Map;
using Eigen::Matrix3d;

constexpr int state_size = 13;  // r, quaternion (w last), n, m
/// Derivatives by turn, force and moment at the begin and by the load factor; those by the position are
/// trivial.
constexpr int column_count = 10, column_size = 12;
using Flat = std::array<double, state_size + column_count * column_size>;
using Columns = Eigen::Matrix<double, column_size, column_count>;

Flat packed(const SectionState& s) {
  Flat flat{};
  Map<Vector3d>(flat.data()) = s.position;
  Map<Eigen::Quaterniond>(flat.data() + 3) = s.frame;
  Map<Vector3d>(flat.data() + 7) = s.force;
  Map<Vector3d>(flat.data() + 10) = s.moment;
  Map<Columns> columns(flat.data() + state_size);
  columns.setZero();
  columns.block<9, 9>(3, 0).setIdentity();
  return flat;
}

SectionState unpacked(const double* flat) {
  return {Map<const Vector3d>(flat), Map<const Eigen::Quaterniond>(flat + 3).normalized(),
          Map<const Vector3d>(flat + 7), Map<const Vector3d>(flat + 10)};
}

/// What all sections of a segment share.
struct Along {
  const ScaledRod& rod;
  Vector3d rest_curvature;
  Vector3d weight, following, weight_rate, following_rate;  ///< rates by the load factor

  Along(const ScaledRod& r, const RodSegment& part, double factor)
      : rod(r),
        rest_curvature(part.rest_curvature[0], part.rest_curvature[1], part.rest_curvature[2]),
        weight(r.steady.weight + factor * r.varied.weight),
        following(r.steady.following_weight + factor * r.varied.following_weight),
        weight_rate(r.varied.weight),
        following_rate(r.varied.following_weight) {}

  void operator()(const double* flat, double* out) const {
    const SectionState s = unpacked(flat);
    const Matrix3d R = s.frame.toRotationMatrix();
    const Vector3d bend_soft{1 / rod.torsion, 1 / rod.sideways, 1},
        stretch_soft{rod.stretch, rod.shear, rod.shear};
    const Vector3d curvature = rest_curvature + bend_soft.cwiseProduct(Vector3d(R.transpose() * s.moment));
    const Vector3d strain = stretch_soft.cwiseProduct(Vector3d(R.transpose() * s.force));
    const Vector3d along = R * (Vector3d::UnitX() + strain);
    Map<Vector3d>{out} = along;
    const Eigen::Quaterniond spin(0, curvature[0] / 2, curvature[1] / 2, curvature[2] / 2);
    Map<Eigen::Quaterniond>(out + 3) = Map<const Eigen::Quaterniond>(flat + 3) * spin;
    Map<Vector3d>(out + 7) = -weight - R * following;
    Map<Vector3d>(out + 10) = s.force.cross(along);

    const Matrix3d bend = R * bend_soft.asDiagonal() * R.transpose(),
                   pull = R * stretch_soft.asDiagonal() * R.transpose();
    const Map<const Columns> in(flat + state_size);
    Map<Columns> rates(out + state_size);
    for (int j = 0; j < column_count; ++j) {
      const Vector3d turn = in.block<3, 1>(3, j), force = in.block<3, 1>(6, j), moment = in.block<3, 1>(9, j);
      const Vector3d place_rate = turn.cross(along) + pull * (force - turn.cross(s.force));
      rates.block<3, 1>(0, j) = place_rate;
      rates.block<3, 1>(3, j) = bend * (moment - turn.cross(s.moment));
      rates.block<3, 1>(6, j) = -turn.cross(R * following);
      rates.block<3, 1>(9, j) = s.force.cross(place_rate) + force.cross(along);
    }
    rates.block<3, 1>(6, column_count - 1) -= weight_rate + R * following_rate;
  }
};

/// The segment's corner and the force on its joint.
void enter(Flat& flat, const RodSegment& part, double factor) {
  Map<Eigen::Quaterniond> frame(flat.data() + 3);
  frame = frame * Eigen::Quaterniond(Eigen::AngleAxisd(part.corner, Vector3d::UnitZ()));
  const Map<const Vector3d> joint(part.joint_force.data());
  Map<Vector3d>(flat.data() + 7) -= factor * joint;
  Map<Columns>(flat.data() + state_size).block<3, 1>(6, column_count - 1) -= joint;
}

OdeIntegrator integrator(const Along& along) {
  return {std::tuple_size_v<Flat>,
          [along](double, const double* at, double* rate) { along(at, rate); },
          {},
          "a rod in space"};
}

Eigen::Matrix<double, 12, 13> end_slope(const Flat& flat) {
  Eigen::Matrix<double, 12, 13> slope = Eigen::Matrix<double, 12, 13>::Zero();
  slope.topLeftCorner<3, 3>().setIdentity();
  slope.rightCols<10>() = Map<const Columns>(flat.data() + state_size);
  return slope;
}

Eigen::Matrix<double, 12, 13> begin_slope() { return Eigen::Matrix<double, 12, 13>::Identity(); }

}  // namespace

Shot shoot(const ScaledRod& rod, const SectionState& begin, double factor) {
  Shot shot{{}, {}, {}};
  Flat flat = packed(begin);
  for (const RodSegment& part : rod.segments) {
    enter(flat, part, factor);
    shot.sections.push_back(unpacked(flat.data()));
    double s = 0;
    OdeIntegrator along = integrator(Along(rod, part, factor));
    along.advance(s, part.length, flat);
  }
  shot.sections.push_back(unpacked(flat.data()));
  const EndTarget first{rod.begin, Vector3d::Zero(), Eigen::Quaterniond::Identity(), -1},
      last{rod.end, rod.end_position, rod.end_frame, 1};
  const EndLoads first_loads{rod.steady.begin_force,  rod.varied.begin_force, rod.steady.begin_moment,
                             rod.varied.begin_moment, Vector3d::Zero(),       Vector3d::Zero()},
      last_loads{rod.steady.force,  rod.varied.force,           rod.steady.moment,
                 rod.varied.moment, rod.steady.following_force, rod.varied.following_force};
  const EndCondition at_first = condition(first, first_loads, begin, begin_slope(), factor),
                     at_last = condition(last, last_loads, shot.sections.back(), end_slope(flat), factor);
  shot.residual << at_first.residual, at_last.residual;
  shot.slope << at_first.slope, at_last.slope;
  return shot;
}

std::vector<SectionState> shape_of(const ScaledRod& rod, const SectionState& begin, double factor,
                                   int points) {
  std::vector<SectionState> shape{begin};
  Flat flat = packed(begin);
  double done = 0;
  for (const RodSegment& part : rod.segments) {
    enter(flat, part, factor);
    double s = 0;
    OdeIntegrator along = integrator(Along(rod, part, factor));
    while (static_cast<int>(shape.size()) <= points) {
      const double to = static_cast<double>(shape.size()) / points - done;
      if (to > part.length + 1e-12) break;
      along.advance(s, std::min(to, part.length), flat);
      shape.push_back(unpacked(flat.data()));
    }
    along.advance(s, part.length, flat);
    done += part.length;
  }
  return shape;
}

SectionState moved(const SectionState& begin, const Unknowns& by) {
  const Vector3d turn = by.segment<3>(3);
  const double angle = turn.norm();
  const Vector3d axis = angle > 0 ? Vector3d(turn / angle) : Vector3d::UnitX();
  return {begin.position + by.head<3>(),
          (Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)) * begin.frame).normalized(),
          begin.force + by.segment<3>(6), begin.moment + by.segment<3>(9)};
}

}  // namespace fiberchain::reference::detail
