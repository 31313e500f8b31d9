#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "compare/figures/figure.hpp"
#include "compare/packing/history.hpp"
#include "compare/study/jobs.hpp"
#include "dem/assembly/assembly.hpp"
#include "dem/record/table.hpp"

// Straight stiff rods in a periodic cube that is made smaller until they bear a given small pressure, the
// mechanical contraction of Williams & Philipse (2003): smooth and bumpy ones, of many nodes and of few.
namespace fiberchain::compare {

struct RodPackingCase {
  int aspect_ratio = 16;  ///< r = L/d, L between the centers of the ends
  bool smooth = true;
  int spacing = 4;  ///< diameters a bond; divides the aspect ratio; 1 of spheres
  double friction = 0;
  int fibers = 192;
  double pressure = 1e-5;  ///< over Young's modulus
  int looks = 120;         ///< at a relaxation, of 50 steps each, before the cube is made smaller again
  std::uint64_t seed = 1;  ///< the same start whatever surface, spacing and friction

  bool operator==(const RodPackingCase&) const = default;
};

/// Rods are spherocylinders for volumes, spheres in a row too.
struct RodPacking {
  RodPackingCase asked;
  double solid_fraction = 0;
  double coordination = 0;   ///< rods that touch a rod
  double sine = 0;           ///< mean |sin| of the angle between two rods, pi/4 of random directions
  double contact_ratio = 0;  ///< solid_fraction v_ex/v over coordination: 1 of random contacts
  double edge = 0;           ///< of the cube over the length of a rod
  double overlap = 0;        ///< of contacts, mean, over the radius
  std::int64_t nodes = 0;
  double run_time = 0;  ///< [s]
  std::string status;   ///< "finished", or why not
};

/// v_ex/v of two spherocylinders of this aspect ratio with this mean |sin| of their angle (Onsager 1949).
double excluded_volume_ratio(double aspect_ratio, double sine);

/// Group 0, at random places in a cube.
/// @throws InputError for a spacing that does not divide the aspect ratio, or of spheres
dem::Assembly loose_rods(const RodPackingCase& asked);

RodPacking pack_rods(const RodPackingCase& asked);

/// Diameters a bond of stiff rods that are cut into at least four, if they are as long: the most up to 8.
/// Longer ones see each other across a cube of 12 r rods.
int long_bonds(int aspect_ratio);

struct RodPackingOptions {
  Jobs jobs = 1;
  std::function<void()> advance = [] {};
};
std::vector<RodPacking> pack_rods(const std::vector<RodPackingCase>& cases, const RodPackingOptions& options);

/// Smooth rods of few bonds by aspect ratio; where they are compared, of aspect ratio 15 smooth ones of 1, 3
/// and 5 diameters a bond and spheres.
std::vector<RodPackingCase> rod_packing_cases(const std::vector<int>& aspect_ratios, bool compared,
                                              double friction, int fibers, int seeds);

/// Of a quantity over the seeds of each kind.
struct RodPackingKind {
  RodPackingCase asked;  ///< seed 0
  Spread solid_fraction, coordination, contact_ratio;
};
/// Of packings that finished. @throws InputError where none did
std::vector<RodPackingKind> rod_packing_kinds(const std::vector<RodPacking>& packings);

dem::Table rod_packing_table(const std::vector<RodPacking>& packings);  ///< a row a packing
dem::Table rod_packing_kind_table(
    const std::vector<RodPacking>& packings);  ///< a row a kind: means over seeds

/// Solid fraction times aspect ratio and half of the contacts, which thin rods at random have alike.
Figure rod_packing_figure(const std::vector<RodPacking>& packings);

}  // namespace fiberchain::compare
