#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace fiberchain::dem {

/// Brings a list of spheres by rising number up to date where some are `rebuilt` (by rising number): in the
/// order of numbers, keep(place in the list) for those that stay, renew(sphere, its place where it has one)
/// for the others.
template <class Keep, class Renew>
void walk_rebuilt(std::span<const std::int32_t> spheres, std::span<const std::int32_t> rebuilt,
                  const Keep& keep, const Renew& renew) {
  std::size_t p = 0;
  for (const std::int32_t i : rebuilt) {
    while (p < spheres.size() && spheres[p] < i) keep(p++);
    const bool was = p < spheres.size() && spheres[p] == i;
    renew(i, was ? std::optional(p++) : std::nullopt);
  }
  while (p < spheres.size()) keep(p++);
}

}  // namespace fiberchain::dem
