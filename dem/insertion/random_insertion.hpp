#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "dem/chain/fiber_group.hpp"
#include "dem/insertion/insertion_grid.hpp"
#include "dem/model/domain.hpp"

// Fibers at random positions, one after the other, where no sphere overlaps another or a wall. The same
// seed gives the same packing on any machine and any number of threads.
namespace fiberchain::dem {

/// Which ways fibers point: the direction from their first sphere to their last.
enum class Alignment {
  isotropic,  ///< all alike
  near_axis,  ///< within `angle` of the axis `direction`, either way, all such directions alike
  near_plane  ///< within `angle` of the plane across `direction`
};

struct InsertionOrientation {
  Alignment alignment = Alignment::isotropic;
  Vec<double, 3> direction{0, 0, 1};
  double angle = 0;  ///< [rad], 0 to pi/2
};

/// How to fill.
struct InsertionRules {
  Box region;  ///< holds all spheres wholly; where it spans a period, fibers cross the sides
  InsertionOrientation orientation{};
  Vec<double, 3> velocity{};  ///< of all spheres at the start [m/s]
  double gap = 0;             ///< least distance between surfaces [m]
  std::uint64_t seed = 1;
  std::int64_t attempts = 100000;  ///< a fiber
  double time = 0;                 ///< walls stand as they do then [s]
  std::int64_t first_number =
      0;  ///< fibers drawn before from this seed: later batches go on with new random numbers
};

/// How far a filling is.
struct InsertionProgress {
  std::int64_t placed, fibers;  ///< so many of so many
  std::int64_t attempts;        ///< for the fiber that is looked for now
};

/// Is told every few attempts; to stop the filling it throws.
using InsertionWatch = std::function<void(const InsertionProgress&)>;

/// What becomes of a fiber that finds no place.
enum class Shortfall {
  refuse,  ///< NoRoom
  accept   ///< it and those of its kind after it are left out
};

/// So many fibers in the chain's rest shape.
struct InsertionCount {
  Chain<3> chain;
  std::int64_t count;
};

/// One group a count, its fibers beside each other and beside spheres that are there already. Each fiber
/// draws its orientation, then its place uniformly among those where it lies in the region, until nothing is
/// in its way; the largest chains come first. What is in the way favors aligned neighbors, as for any random
/// insertion: a dense filling is not quite as isotropic as asked. Fibers of a group are numbered in the order
/// of their middles along the region's longest side. Throws InvalidInput for rules that make no sense, NoRoom
/// when a fiber finds no place and that is not accepted.
std::vector<FiberGroup> random_insertion(const std::vector<InsertionCount>& counts,
                                         const InsertionRules& rules, const Domain& domain,
                                         const PlacedSpheres& present = {}, const InsertionWatch& watch = {},
                                         Shortfall shortfall = Shortfall::refuse);

/// All spheres of fibers, to fill in more beside them.
PlacedSpheres spheres_of(const std::vector<FiberGroup>& groups);

/// Distance from a wall's surface into the domain [m] at a time; negative behind it. Infinite while the wall
/// is not there.
double distance_to(const Wall& wall, const Vec<double, 3>& point, double time);

}  // namespace fiberchain::dem
