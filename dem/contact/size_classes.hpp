#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem/contact/sorted_cells.hpp"

// Spheres in classes of size, radii of a class within a factor of two, each in sorted cells of its own: what
// a search costs does not depend on the largest body. Hierarchical grids: Ogarko & Luding, Computer Physics
// Communications 183 (2012) 931.
namespace fiberchain::dem {

/// Class of a radius: 0 of the largest, one more with each half of it; those that are much smaller share the
/// last.
int size_class(double radius, double largest);
inline constexpr int most_size_classes = 16;

class SizeClasses {
 public:
  SizeClasses() = default;
  /// Without places. Spheres of a class with a gap below `skin` [m] are searched in neighboring cells.
  SizeClasses(const SphereSet& all, double skin);

  /// Those that occur, by falling size.
  int count() const { return static_cast<int>(classes_.size()); }
  int of(std::int32_t sphere) const { return class_[sphere]; }
  const SortedCells& cells(int k) const { return classes_[k].cells; }

  /// Sorts the spheres of these classes, bit k for class k, all of which stand at finite positions.
  void sort(std::uint32_t which, const SphereSet& all, std::span<const Vec<double, 3>> positions);
  std::uint32_t all() const { return (1u << classes_.size()) - 1; }

  /// A sphere moves; false where it has strayed so far from where it was sorted that its class must be sorted
  /// again before the next search.
  bool move(std::int32_t sphere, const Vec<double, 3>& to);

  /// Distance [m] from a sphere with this reach (its radius and the largest gap) to where neighbors of class
  /// k were sorted, at most.
  double reach_into(int k, double reach) const { return reach + classes_[k].largest + classes_[k].slack; }

 private:
  struct Class {
    double largest;  ///< radius [m]
    double edge;     ///< of its cells, at least [m]
    double slack;    ///< displacement of a sphere since it was sorted that the cells allow [m]
    std::vector<std::int32_t> members;
    SortedCells cells;
  };
  std::vector<Class> classes_;
  std::vector<std::uint8_t> class_;          ///< of each sphere
  std::vector<std::int32_t> slot_;           ///< of each sphere in the cells of its class
  std::vector<Vec<double, 3>> first_place_;  ///< where each sphere was sorted
};

}  // namespace fiberchain::dem
