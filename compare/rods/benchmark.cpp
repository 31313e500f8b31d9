#include "compare/rods/benchmark.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "compare/static/case.hpp"
#include "compare/study/errors.hpp"
#include "dem/chain/arc_chain.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::compare {

const std::vector<RodBenchmark>& rod_benchmarks() {
  static const std::vector<RodBenchmark> all = [] {
    std::vector<RodBenchmark> list = loaded_rods();
    for (const auto& more : {column_rods(), twisted_rings(), frame_rods()})
      list.insert(list.end(), more.begin(), more.end());
    return list;
  }();
  return all;
}

const RodBenchmark& rod_benchmark(std::string_view name) {
  const auto found = std::ranges::find(rod_benchmarks(), name, &RodBenchmark::name);
  if (found != rod_benchmarks().end()) return *found;
  std::vector<std::string_view> names;
  for (const RodBenchmark& one : rod_benchmarks()) names.push_back(one.name);
  throw InputError(fmt::format("there is no rod benchmark '{}'; allowed: {}", name, fmt::join(names, ", ")));
}

dem::Fiber rod_fiber(const RodSetting& setting, double arc) {
  dem::Fiber fiber = nominal_fiber(setting.bonds, setting.poisson_ratio, setting.bond);
  fiber.spacing = setting.spacing;
  fiber.mass = dem::MassModel::cylinder;
  fiber.rest_angle = arc / setting.bonds;
  fiber.diameter *= dem::bond_length(fiber) / dem::arc_length(fiber);
  return fiber;
}

double rod_length(const dem::Fiber& fiber) { return fiber.aspect_ratio * dem::arc_length(fiber); }

reference::SpatialRod continuum_rod(const dem::Fiber& fiber, std::vector<reference::RodSegment> segments,
                                    bool sheared) {
  const double EI = dem::bending_stiffness(fiber);
  const bool shears = sheared && fiber.bond_model == dem::BondModel::paper;
  return {.segments = std::move(segments),
          .bending = EI,
          .torsion = 2 * EI * fiber.material.shear_modulus / fiber.material.youngs_modulus,
          .axial = dem::axial_stiffness(fiber),
          .shear = shears ? dem::shear_stiffness(fiber) : std::numeric_limits<double>::infinity()};
}

RodUnits rod_units(const dem::Fiber& fiber) {
  const double L = rod_length(fiber), EI = dem::bending_stiffness(fiber);
  return {L, EI / (L * L), EI / L, EI / (L * L * L)};
}

const dem::SingularPoint& first_singular(const dem::RodPath& path, dem::SingularKind kind) {
  const auto found = std::ranges::find(path.singular, kind, &dem::SingularPoint::kind);
  if (found == path.singular.end())
    throw dem::NoConvergence(fmt::format("the path of a rod has no {}", dem::name(kind)));
  return *found;
}

reference::SpaceVector vector_of(const dem::Vec<double, 3>& v) { return {v[0], v[1], v[2]}; }

std::vector<double> over(const dem::Vec<double, 3>& v, double length) {
  return {v[0] / length, v[1] / length, v[2] / length};
}

std::vector<double> over(const reference::SpaceVector& v, double length) {
  return {v[0] / length, v[1] / length, v[2] / length};
}

}  // namespace fiberchain::compare
