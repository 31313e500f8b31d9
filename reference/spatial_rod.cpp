#include "reference/spatial_rod.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multiroots.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>

#include "reference/errors.hpp"
#include "reference/gsl_ode.hpp"

namespace fiberchain::reference {
namespace {

using Eigen::Map;
using Eigen::Vector3d;

Vector3d vector(const SpaceVector& u) { return {u[0], u[1], u[2]}; }

/// Lengths in L and forces in EI / L^2, so that one set of tolerances serves every rod.
struct ScaledRod {
  std::vector<RodSegment> segments;
  double torsion;  ///< GJ / EI
  double stretch;  ///< EI / (EA L^2)
  Vector3d force, moment, weight;
};

double length_of(const SpatialRod& rod) {
  double length = 0;
  for (const RodSegment& part : rod.segments) {
    require_positive("length", part.length);
    length += part.length;
  }
  require_positive("length", length);
  return length;
}

ScaledRod scaled(const SpatialRod& rod, const RodLoads& loads, double length) {
  require_positive("bending", rod.bending);
  require_positive("torsion", rod.torsion);
  require_positive_or_infinite("axial", rod.axial);
  const double force = length * length / rod.bending;
  ScaledRod one{.segments = rod.segments,
                .torsion = rod.torsion / rod.bending,
                .stretch = 1 / (rod.axial * force),
                .force = force * vector(loads.force),
                .moment = length / rod.bending * vector(loads.moment),
                .weight = force * length * vector(loads.weight)};
  for (RodSegment& part : one.segments) {
    part.length /= length;
    for (double& component : part.rest_curvature) component *= length;
  }
  return one;
}

/// Loads between none and all.
ScaledRod loaded(ScaledRod rod, double factor) {
  for (Vector3d* load : {&rod.force, &rod.moment, &rod.weight}) *load *= factor;
  return rod;
}

/// r, the section's quaternion (w last, as Eigen stores it), m.
using SectionState = std::array<double, 10>;

void slopes(const ScaledRod& rod, const RodSegment& part, double beyond, const double* state,
            double* derivative) {
  const Eigen::Quaterniond turn = Map<const Eigen::Quaterniond>(state + 3).normalized();
  const Vector3d tangent = turn * Vector3d::UnitX(), force = rod.force + beyond * rod.weight;
  const Vector3d moment = turn.conjugate() * Vector3d(Map<const Vector3d>(state + 7));
  const Vector3d curvature =
      vector(part.rest_curvature) + Vector3d(moment[0] / rod.torsion, moment[1], moment[2]);
  const Vector3d along = (1 + rod.stretch * force.dot(tangent)) * tangent;
  Map<Vector3d>{derivative} = along;
  const Eigen::Quaterniond spin(0, curvature[0] / 2, curvature[1] / 2, curvature[2] / 2);
  Map<Eigen::Quaterniond>(derivative + 3) = Map<const Eigen::Quaterniond>(state + 3) * spin;
  Map<Vector3d>(derivative + 7) = force.cross(along);
}

/// The free end's state with this moment at the clamp.
SectionState end_of(const ScaledRod& rod, const Vector3d& clamp_moment) {
  SectionState state{0, 0, 0, 0, 0, 0, 1, clamp_moment[0], clamp_moment[1], clamp_moment[2]};
  double begin = 0;
  for (const RodSegment& part : rod.segments) {
    Map<Eigen::Quaterniond> turn(state.data() + 3);
    turn = turn * Eigen::Quaterniond(Eigen::AngleAxisd(part.corner, Vector3d::UnitZ()));
    detail::OdeIntegrator along(
        state.size(),
        [&](double s, const double* at, double* slope) { slopes(rod, part, 1 - begin - s, at, slope); }, {},
        "a rod in space");
    double s = 0;
    along.advance(s, part.length, state);
    begin += part.length;
  }
  return state;
}

Vector3d from_gsl(const gsl_vector* v) {
  return {gsl_vector_get(v, 0), gsl_vector_get(v, 1), gsl_vector_get(v, 2)};
}

int miss(const gsl_vector* clamp_moment, void* of, gsl_vector* out) {
  const auto& rod = *static_cast<const ScaledRod*>(of);
  const SectionState end = end_of(rod, from_gsl(clamp_moment));
  for (std::size_t i = 0; i < 3; ++i) gsl_vector_set(out, i, end[7 + i] - rod.moment[static_cast<int>(i)]);
  return std::isfinite(gsl_vector_get(out, 0)) ? GSL_SUCCESS : GSL_EBADFUNC;
}

/// The moment at the clamp, near `start`.
Vector3d shoot(ScaledRod rod, const Vector3d& start) {
  gsl_multiroot_function function{&miss, 3, &rod};
  const std::unique_ptr<gsl_multiroot_fsolver, decltype(&gsl_multiroot_fsolver_free)> solver(
      gsl_multiroot_fsolver_alloc(gsl_multiroot_fsolver_hybrids, 3), &gsl_multiroot_fsolver_free);
  const std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)> first(gsl_vector_alloc(3), &gsl_vector_free);
  for (std::size_t i = 0; i < 3; ++i) gsl_vector_set(first.get(), i, start[static_cast<int>(i)]);
  int status = gsl_multiroot_fsolver_set(solver.get(), &function, first.get());
  for (int tries = 0; status == GSL_SUCCESS && tries < 100; ++tries) {
    if (gsl_multiroot_test_residual(solver->f, 1e-11) == GSL_SUCCESS) return from_gsl(solver->x);
    status = gsl_multiroot_fsolver_iterate(solver.get());
  }
  throw NoConvergence("the clamp's moment of a rod in space");
}

}  // namespace

SpaceVector spatial_rod_end(const SpatialRod& rod, const RodLoads& loads, int load_steps) {
  const double length = length_of(rod);
  const ScaledRod all = scaled(rod, loads, length);
  Vector3d clamp_moment = Vector3d::Zero(), before = clamp_moment;
  for (int step = 1; step <= load_steps; ++step) {
    const Vector3d ahead = 2 * clamp_moment - before;
    before = clamp_moment;
    clamp_moment = shoot(loaded(all, static_cast<double>(step) / load_steps), ahead);
  }
  const SectionState end = end_of(all, clamp_moment);
  return {end[0] * length, end[1] * length, end[2] * length};
}

}  // namespace fiberchain::reference
