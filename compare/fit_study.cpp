#include <fmt/format.h>

#include <cmath>

#include "compare/damping_point.hpp"
#include "compare/errors.hpp"
#include "compare/fit_table.hpp"

// What the laws are fitted to, measured.
namespace fiberchain::compare {
namespace {

DampingCase case_of(const FitSweep& asked, int aspect_ratio) {
  DampingCase c;
  c.aspect_ratio = aspect_ratio;
  c.poisson_ratio = asked.poisson_ratio;
  c.load = asked.load;
  c.bond_damping = asked.bond_damping;
  if (asked.peaks) c.peaks = *asked.peaks;
  return c;
}

DampingDatum datum_of(const FitSweep& asked, const DampingPoint& point) {
  const double damping = asked.peaks ? point.damping_paper : point.damping;
  if (!(damping > 0)) {
    throw InputError(fmt::format("the damping at aspect ratio {} cannot be measured: {}", point.asked.aspect_ratio,
                                 point.status));
  }
  return {point.asked.aspect_ratio, damping / asked.bond_damping};
}

}  // namespace

FitSweep::FitSweep() {
  for (int r_f = 5; r_f <= 30; ++r_f) aspect_ratio.push_back(r_f);
}

FitStudy fit_study(const FitSweep& asked, int jobs) {
  const ChainKind kind{asked.poisson_ratio, asked.bond_damping};
  FitStudy study{asked, {}, {}, chain_curve(kind), {}, {}};
  std::vector<DampingCase> cases;
  for (const int r_f : asked.aspect_ratio) cases.push_back(case_of(asked, r_f));
  for (const int r_f : asked.held_out) cases.push_back(case_of(asked, r_f));
  const std::vector<DampingPoint> measured = damping_points(cases, {.jobs = jobs, .elastica = false});
  for (std::size_t i = 0; i < measured.size(); ++i) {
    (i < asked.aspect_ratio.size() ? study.points : study.held_out).push_back(datum_of(asked, measured[i]));
  }
  study.fits = damping_fits(study.points, study.held_out, study.chain);
  study.choices = choice_outcomes(fit_choices(), chain_slopes(kind, jobs));
  return study;
}

}  // namespace fiberchain::compare
