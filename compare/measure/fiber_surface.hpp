#pragma once

#include "dem/assembly/assembly.hpp"
#include "dem/insertion/random_insertion.hpp"

// Fibers that differ by their surface and their bonds' length alone, from the same places.
namespace fiberchain::compare {

/// What fibers of a comparison touch each other by.
struct FiberSurface {
  bool smooth = false;  ///< Chain::smooth
  int spacing = 1;      ///< diameters a bond; divides the aspect ratio; 1 of spheres

  bool operator==(const FiberSurface&) const = default;
};

/// @throws InputError for a spacing that does not divide the aspect ratio, or of spheres
void check(const FiberSurface& surface, int aspect_ratio);

/// So many fibers at rest at random places, of the corrected bond and the mass of cylinders. Their nodes are
/// those of spheres in a row, as `fiber` has them, all or every so many; of `rules` the gap is ours.
/// @throws InputError as above; dem::InvalidInput where they find no places
dem::FiberGroup inserted_fibers(dem::Fiber fiber, const FiberSurface& surface, int count,
                                dem::InsertionRules rules, const dem::Domain& around);

}  // namespace fiberchain::compare
