#include "compare/rod_packing/rod_packing.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/validation.hpp"

namespace fiberchain::compare {
namespace {

/// Long rods; then short ones of both surfaces.
std::vector<Measured> packed(const ValidationInput& in) {
  RodPackingCase small{.aspect_ratio = 8, .spacing = 1, .fibers = 80, .looks = 40}, bumps = small;
  bumps.smooth = false;
  const auto packings = pack_rods({{.seed = 1}, small, bumps}, {.jobs = in.jobs});
  for (const RodPacking& p : packings) {
    if (p.status != "finished") throw InputError("a packing of rods did not finish: " + p.status);
  }
  const RodPacking &rods = packings[0], &smooth = packings[1], &bumpy = packings[2];
  const double r = rods.asked.aspect_ratio;
  return {{r * rods.solid_fraction, {rods.asked.aspect_ratio, rods.asked.fibers, rods.coordination / 2}},
          {rods.coordination, {rods.contact_ratio}},
          {bumpy.solid_fraction / smooth.solid_fraction,
           {smooth.solid_fraction, bumpy.solid_fraction, smooth.coordination, bumpy.coordination}}};
}

}  // namespace

const Checks& rod_packing_checks() {
  static const Checks checks{
      {.ids = {"rods-philipse", "rods-coordination", "rods-bumpy"}, .measure = packed, .cost = 14}};
  return checks;
}

}  // namespace fiberchain::compare
