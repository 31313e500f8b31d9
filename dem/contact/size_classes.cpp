#include "dem/contact/size_classes.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>

namespace fiberchain::dem {
namespace {

/// Displacement of a sphere since it was sorted that the cells allow, over its reach.
constexpr double kSlack = 0.5;

/// Where spheres are few, cells grow rather than be so many that the caches cannot hold them.
constexpr double kCellsASphere = 16;

/// Around the places of these spheres; from 0 along periodic axes.
Box box_of(std::span<const std::int32_t> members, std::span<const Vec<double, 3>> positions,
           const Vec<double, 3>& period) {
  Box box = box_around(members | std::views::transform([&](std::int32_t i) { return positions[i]; }));
  for (int c = 0; c < 3; ++c) {
    if (period[c] > 0) box.low[c] = 0;
  }
  return box;
}

}  // namespace

int size_class(double radius, double largest) {
  return std::clamp(std::ilogb(largest / radius), 0, most_size_classes - 1);
}

SizeClasses::SizeClasses(const SphereSet& all, double skin)
    : slot_(all.radius.size()), first_place_(all.radius.size()) {
  const double largest = *std::ranges::max_element(all.radius);
  std::vector<Class> classes(most_size_classes);
  for (std::size_t i = 0; i < all.radius.size(); ++i) {
    Class& own = classes[size_class(all.radius[i], largest)];
    own.members.push_back(static_cast<std::int32_t>(i));
    own.largest = std::max(own.largest, all.radius[i]);
  }
  std::erase_if(classes, [](const Class& c) { return c.members.empty(); });
  class_.resize(all.radius.size());
  for (std::size_t k = 0; k < classes.size(); ++k) {
    const double reach = 2 * classes[k].largest + skin;
    classes[k].slack = kSlack * reach;
    classes[k].edge = reach + classes[k].slack;
    for (const std::int32_t i : classes[k].members) class_[i] = static_cast<std::uint8_t>(k);
  }
  classes_ = std::move(classes);
}

void SizeClasses::sort(std::uint32_t which, const SphereSet& all, std::span<const Vec<double, 3>> positions) {
  for (std::size_t k = 0; k < classes_.size(); ++k) {
    if ((which >> k & 1) == 0) continue;
    Class& own = classes_[k];
    const CellGeometry cells(box_of(own.members, positions, all.period), all.period, own.edge,
                             kCellsASphere * static_cast<double>(own.members.size()) + 64);
    own.cells.sort(cells, own.members, all, positions, slot_);
    for (const std::int32_t i : own.members) first_place_[i] = positions[i];
  }
}

bool SizeClasses::move(std::int32_t sphere, const Vec<double, 3>& to) {
  Class& own = classes_[class_[sphere]];
  own.cells.move(slot_[sphere], to);
  return norm(to - first_place_[sphere]) <= own.slack;
}

}  // namespace fiberchain::dem
