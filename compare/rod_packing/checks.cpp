#include "compare/rod_packing/rod_packing.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/validation.hpp"

namespace fiberchain::compare {
namespace {

/// Long rods, then the two surfaces.
std::vector<Measured> packed(const ValidationInput& in) {
  const auto packings = pack_rods({{.seed = 1},
                                   {.seed = 2},
                                   {.aspect_ratio = 15, .spacing = 5, .fibers = 180},
                                   {.aspect_ratio = 15, .smooth = false, .spacing = 1, .fibers = 180}},
                                  {.jobs = in.jobs});
  for (const RodPacking& p : packings) {
    if (p.status != "finished") throw InputError("a packing of rods did not finish: " + p.status);
  }
  const RodPacking &one = packings[0], &other = packings[1], &smooth = packings[2], &bumpy = packings[3];
  const double r = one.asked.aspect_ratio, fraction = r * (one.solid_fraction + other.solid_fraction) / 2,
               contacts = (one.coordination + other.coordination) / 2;
  return {{fraction,
           {one.asked.aspect_ratio, one.asked.fibers, r * one.solid_fraction, r * other.solid_fraction,
            contacts / 2}},
          {contacts, {one.coordination, other.coordination, (one.contact_ratio + other.contact_ratio) / 2}},
          {bumpy.solid_fraction / smooth.solid_fraction,
           {smooth.solid_fraction, bumpy.solid_fraction, smooth.coordination, bumpy.coordination}}};
}

}  // namespace

const Checks& rod_packing_checks() {
  static const Checks checks{
      {.ids = {"rods-philipse", "rods-coordination", "rods-bumpy"}, .measure = packed, .cost = 70}};
  return checks;
}

}  // namespace fiberchain::compare
