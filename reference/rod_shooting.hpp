#pragma once

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <vector>

#include "reference/spatial_rod.hpp"

// Shooting along a rod in space: the equations of spatial_rod.hpp together with their derivatives by what is
// unknown at the begin.
namespace fiberchain::reference::detail {

using Eigen::Vector3d;

inline Vector3d vector(const SpaceVector& v) { return {v[0], v[1], v[2]}; }

/// Loads with lengths in L and forces in E I / L^2.
struct ScaledLoads {
  Vector3d force, moment, weight, following_force, following_weight, begin_force, begin_moment;
};

/// The problem in these units, so that one set of tolerances serves every rod.
struct ScaledRod {
  std::vector<RodSegment> segments;
  double torsion;   ///< GJ / EI
  double sideways;  ///< E I about the section's y over E I
  double stretch;   ///< EI / (EA L^2)
  double shear;     ///< EI / (GA L^2)
  ScaledLoads steady, varied;
  RodEnd begin, end;
  Vector3d end_position;
  Eigen::Quaterniond end_frame;  ///< of the end where it is held
  bool planar;
  double length;  ///< L [m]
  double force;   ///< E I / L^2 [N]
};

ScaledRod scaled(const RodProblem& problem);

struct SectionState {
  Vector3d position = Vector3d::Zero();
  Eigen::Quaterniond frame = Eigen::Quaterniond::Identity();
  Vector3d force = Vector3d::Zero();
  Vector3d moment = Vector3d::Zero();
};

/// Position, turn (spatial rotation vector), force and moment at the begin, then the load factor.
using Unknowns = Eigen::Matrix<double, 13, 1>;
using Residual = Eigen::Matrix<double, 12, 1>;
using ResidualSlope = Eigen::Matrix<double, 12, 13>;

struct Shot {
  std::vector<SectionState> sections;  ///< where segments begin, then the end
  Residual residual;                   ///< three of place and three of turn at the begin, six at the end
  ResidualSlope slope;                 ///< of it by the unknowns
};

/// @param points per segment beyond its begin where sections are wanted, too; 0: only the segments' begins
Shot shoot(const ScaledRod& rod, const SectionState& begin, double factor);

/// Sections at `points` + 1 even places.
std::vector<SectionState> shape_of(const ScaledRod& rod, const SectionState& begin, double factor,
                                   int points);

/// The begin moved and turned by increments of the unknowns.
SectionState moved(const SectionState& begin, const Unknowns& by);

SectionState scaled(const RodSection& section, const ScaledRod& rod);
RodSection section_of(const SectionState& state, const ScaledRod& rod);

}  // namespace fiberchain::reference::detail
