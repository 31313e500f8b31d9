#include <cmath>

#include "compare/breaking/fragments.hpp"
#include "compare/breaking/released_rod.hpp"
#include "compare/study/validation.hpp"

namespace fiberchain::compare {
namespace {

dem::AssemblyOptions options_of(const ReleasedRod& rod) {
  return {.step = 0.4 * dem::bond_time_step(rod.fiber), .form = dem::BondForm::total};
}

double peak(int aspect_ratio) {
  const ReleasedRod rod = released_rod(aspect_ratio);
  return largest_curvature(rod, options_of(rod));
}

std::vector<Measured> flexural_wave(const ValidationInput& in) {
  const std::vector<int> aspect_ratios{80, 160, 320};
  std::vector<double> peaks(aspect_ratios.size());
  in.jobs.run(peaks.size(), [&](std::size_t n) { peaks[n] = peak(aspect_ratios[n]); });
  return {{peaks[2], {aspect_ratios[2], peaks[0], peaks[1], largest_curvature_of_beam()}}};
}

/// The strength between that of a rod which breaks and of one which does not, by halves.
std::vector<Measured> weakest_that_bears(const ValidationInput&) {
  double low = 1.2, high = 1.6;
  int runs = 0;
  for (; high - low > 2e-3; ++runs) {
    const double middle = 0.5 * (low + high);
    ReleasedRod rod = released_rod(160);
    rod.fiber.strength = dem::BondStrength{.tension = middle * stress_at_rest(rod)};
    (breaks_of(rod, options_of(rod)).empty() ? high : low) = middle;
  }
  return {{high, {runs}}};
}

/// Pieces of rods with strengths by Weibull's law, cut into more bonds.
std::vector<Measured> fragments(const ValidationInput& in) {
  const std::vector<int> aspect_ratios{40, 60};
  std::vector<Fragments> all(2);
  constexpr int rods = 1600;
  in.jobs.run(all.size(), [&](std::size_t n) {
    all[n] = break_rods({.aspect_ratio = aspect_ratios[n], .rods = rods, .strength = 1.2});
  });
  return {{all[1].mean / all[0].mean,
           {rods, aspect_ratios[0], all[0].mean, all[0].deviation, aspect_ratios[1], all[1].mean,
            all[1].deviation}}};
}

}  // namespace

const Checks& breaking_checks() {
  static const Checks checks{{.ids = {"rod-flexural-wave"}, .measure = flexural_wave, .cost = 1},
                             {.ids = {"rod-strength"}, .measure = weakest_that_bears, .cost = 1},
                             {.ids = {"rod-fragments"}, .measure = fragments, .cost = 80}};
  return checks;
}

}  // namespace fiberchain::compare
