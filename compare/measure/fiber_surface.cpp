#include "compare/measure/fiber_surface.hpp"

#include <fmt/format.h>

#include <utility>

#include "compare/study/errors.hpp"

namespace fiberchain::compare {

void check(const FiberSurface& surface, int aspect_ratio) {
  const int spacing = surface.spacing;
  if (spacing >= 1 && aspect_ratio % spacing == 0 && (surface.smooth || spacing == 1)) return;
  throw InputError(
      fmt::format("a spacing of {} is not allowed: it divides the aspect ratio, {}, and is 1 of spheres",
                  spacing, aspect_ratio));
}

dem::FiberGroup inserted_fibers(dem::Fiber fiber, const FiberSurface& surface, int count,
                                dem::InsertionRules rules, const dem::Domain& around) {
  check(surface, fiber.aspect_ratio);
  fiber.bond_model = dem::BondModel::corrected, fiber.mass = dem::MassModel::cylinder;
  rules.gap = 0.23 * fiber.diameter;  // smooth fibers do not overlap where spheres are this far apart
  const auto rows = dem::random_insertion({{dem::straight_chain<3>(fiber), count}}, rules, around);
  fiber.aspect_ratio /= surface.spacing, fiber.spacing = surface.spacing;
  dem::FiberGroup group{dem::straight_chain<3>(fiber), {}};
  group.chain.smooth = surface.smooth;
  for (const dem::ChainState<3>& row : rows.front().fibers) {
    dem::ChainState<3> one = dem::at_rest<3>(group.chain.poses);
    for (std::size_t i = 0; i < one.poses.size(); ++i)
      one.poses[i] = row.poses[i * static_cast<std::size_t>(surface.spacing)];
    group.fibers.push_back(std::move(one));
  }
  return group;
}

}  // namespace fiberchain::compare
