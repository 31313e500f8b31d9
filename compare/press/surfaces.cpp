#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/press/press.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {
namespace {

/// Between the samples around it; NaN where the pressure stays below.
double fraction_at(const PressRun& run, double pressure) {
  const auto& all = run.samples;
  std::size_t above = all.size();
  while (above > 0 && all[above - 1].pressure > pressure) --above;
  if (above == all.size() || above == 0 || !(all[above - 1].pressure > 0)) return nan;
  const PressSample &low = all[above - 1], &high = all[above];
  const double part = std::log(pressure / low.pressure) / std::log(high.pressure / low.pressure);
  return low.solid_fraction + part * (high.solid_fraction - low.solid_fraction);
}

double last_pressure(const PressRun& run) {
  const std::size_t count = std::max<std::size_t>(1, run.samples.size() / 10);
  double sum = 0;
  for (std::size_t n = run.samples.size() - count; n < run.samples.size(); ++n)
    sum += run.samples[n].pressure / static_cast<double>(count);
  return sum;
}

PressedSurface pressed_surface(const std::vector<const PressRun*>& runs) {
  std::vector<double> touched, pressures, fractions, exponents;
  PressedSurface all{.asked = runs.front()->asked,
                     .touched = {},
                     .pressure = {},
                     .fraction = {},
                     .exponent = {},
                     .run_time = 0};
  for (const PressRun* run : runs) {
    touched.push_back(run->touched);
    pressures.push_back(last_pressure(*run) / run->youngs_modulus);
    fractions.push_back(fraction_at(*run, PressedSurface::light * run->youngs_modulus));
    exponents.push_back(fit_press(*run).exponent);
    all.run_time += run->run_time / static_cast<double>(runs.size());
  }
  all.touched = spread_of(touched), all.pressure = spread_of(pressures);
  all.fraction = spread_of(fractions), all.exponent = spread_of(exponents);
  return all;
}

dem::NamedRow surface_row(const PressedSurface& one) {
  const PressCase& c = one.asked;
  return {{"surface", std::string(c.surface->smooth ? "smooth" : "spheres")},
          {"spacing", static_cast<double>(c.surface->spacing)},
          {"fibers", std::int64_t{c.fibers}},
          {"aspect_ratio", std::int64_t{c.aspect_ratio}},
          {"press_friction", c.friction},
          {"spheres", std::int64_t{c.fibers} * (c.aspect_ratio / c.surface->spacing + 1)},
          {"seeds", static_cast<std::int64_t>(one.touched.count)},
          {"press_touched", one.touched.mean},
          {"press_touched_interval", dem::known(half_width(one.touched))},
          {"press_dense", one.pressure.mean},
          {"press_dense_interval", dem::known(half_width(one.pressure))},
          {"press_light", dem::known(one.fraction.mean)},
          {"press_light_interval", dem::known(half_width(one.fraction))},
          {"press_exponent", one.exponent.mean},
          {"run_time", one.run_time}};
}

}  // namespace

dem::Assembly bed_of_surface(const PressCase& asked, const dem::PackingScene& scene) {
  return {{inserted_fibers(scene.kinds.front().fiber, asked.surface.value(), asked.fibers, scene.filling,
                           scene.domain)},
          scene.domain,
          {.form = dem::BondForm::total, .speed = asked.speed}};
}

std::vector<PressCase> surface_cases(const std::vector<PressCase>& beds, const std::vector<int>& spacings) {
  std::vector<FiberSurface> surfaces{{.smooth = false}};
  for (const int spacing : spacings) surfaces.push_back({.smooth = true, .spacing = spacing});
  std::vector<PressCase> all;
  for (const FiberSurface& surface : surfaces) {
    for (PressCase bed : beds) {
      check(surface, bed.aspect_ratio);
      bed.surface = surface;
      all.push_back(bed);
    }
  }
  return all;
}

std::vector<PressedSurface> pressed_surfaces(const std::vector<PressRun>& runs) {
  std::vector<std::vector<const PressRun*>> alike;
  for (const PressRun& run : runs) {
    if (run.status != "finished" || !run.asked.surface) continue;
    const auto found = std::ranges::find_if(
        alike, [&](const auto& some) { return some.front()->asked.surface == run.asked.surface; });
    if (found == alike.end()) {
      alike.push_back({&run});
    } else {
      found->push_back(&run);
    }
  }
  std::vector<PressedSurface> all;
  for (const auto& some : alike) all.push_back(pressed_surface(some));
  return all;
}

dem::Table pressed_surface_table(const std::vector<PressRun>& runs) {
  return tabulate(pressed_surfaces(runs), surface_row);
}

}  // namespace fiberchain::compare
