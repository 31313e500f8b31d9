#include <cmath>
#include <numbers>

#include "compare/rods/benchmark.hpp"
#include "reference/twisted_ring.hpp"

namespace fiberchain::compare {
namespace {

using std::numbers::pi;

std::vector<double> rod_twist(const RodSetting& setting) {
  const dem::Fiber fiber = rod_fiber(setting);
  const reference::SpatialRod rod = continuum_rod(fiber, {}, setting.sheared);
  return {reference::twisted_ring_critical_turn({.length = rod_length(fiber),
                                                 .bending = rod.bending,
                                                 .torsion = rod.torsion,
                                                 .axial = rod.axial,
                                                 .shear = rod.shear})};
}

/// A regular polygon that begins at the origin along x: all bonds turn alike, no forces.
dem::Poses<3> polygon(const dem::Fiber& fiber) {
  const int n = fiber.aspect_ratio;
  const double turn = 2 * pi / n;
  const double shortened = fiber.bond_model == dem::BondModel::corrected ? 1 - turn * turn / 24 : 1;
  const double bond = dem::bond_length(fiber) * shortened;
  dem::Poses<3> poses;
  dem::Vec<double, 3> at{};
  for (int i = 0; i <= n; ++i) {
    poses.push_back({at, {std::cos(i * turn / 2), {0, 0, std::sin(i * turn / 2)}}});
    at = at + bond * dem::Vec<double, 3>{std::cos((i + 0.5) * turn), std::sin((i + 0.5) * turn), 0};
  }
  return poses;
}

/// Both ends at one place and clamped, which is the closed ring: its sections' forces go on from the end to
/// the begin. The middle is kept from turning about the ends' tangent, which costs nothing.
std::vector<double> chain_twist(const RodSetting& setting) {
  const dem::Fiber fiber = rod_fiber(setting);
  const int n = setting.bonds;
  const double turned = 1.15 * michell_turn(setting.poisson_ratio);
  dem::RodProblem ring{.chain = dem::straight_chain<3>(fiber), .start = polygon(fiber)};
  ring.supports = {
      {.sphere = 0},
      {.sphere = n / 2, .hold_displacement = {false, false, true}, .hold_rotation = {false, false, false}},
      {.sphere = n, .turned = {turned, 0, 0}}};
  const dem::RodPath path = dem::trace_rod(
      ring,
      {.control = dem::RodControl::load, .points = 13, .tolerance = 1e-12, .singular_tolerance = 1e-13});
  return {turned * first_singular(path, dem::SingularKind::bifurcation).point.factor};
}

}  // namespace

double michell_turn(double poisson_ratio) { return 2 * pi * std::sqrt(3.0) * (1 + poisson_ratio); }

std::vector<RodBenchmark> twisted_rings() {
  return {{.name = "twisted-ring", .chain = chain_twist, .rod = rod_twist}};
}

}  // namespace fiberchain::compare
