#include "compare/damping/references.hpp"

#include <cmath>
#include <numbers>

#include "compare/measure/linear_chain_of.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/nan.hpp"
#include "reference/damped_beam.hpp"
#include "reference/damped_elastica.hpp"
#include "reference/errors.hpp"

namespace fiberchain::compare {
namespace {

using std::numbers::pi;

/// Retardation time of bending over the beam's own time unit sqrt(mu L^4 / (E I)) = 4 r_f^2 t_b.
double reduced_retardation(const DampingCase& asked) {
  const double unit = reference::chain_time_unit(asked.aspect_ratio);
  // xi_b sqrt(2 J / K_bend) over t_b: J / K_bend = (2/5 m R^2) / (K_n R^2 / 4) = 8/5 t_b^2
  const double tau = asked.dashpots == dem::DashpotLaw::retardation_time
                         ? asked.bond_damping
                         : asked.bond_damping * std::sqrt(3.2);
  return tau / unit;
}

reference::BeamLayout layout_of(const DampingCase& asked) {
  reference::BeamLayout layout = reference::chain_layout(asked.aspect_ratio, 0.0);
  layout.retardation = reduced_retardation(asked);
  return layout;
}

std::vector<double> sample_times(double period, double periods, int samples_per_period) {
  std::vector<double> times;
  const int n = static_cast<int>(std::ceil(periods * samples_per_period));
  for (int i = 0; i <= n; ++i) times.push_back(period * i / samples_per_period);
  return times;
}

TipHistory history_of(const reference::BeamHistory& beam) {
  TipHistory history;
  for (const reference::BeamSample& s : beam.samples) {
    history.time.push_back(s.time);
    history.y.push_back(s.y);
    history.velocity.push_back(s.y_rate);
  }
  return history;
}

/// Damped Elastica in its own time unit, let go from its first mode or from its equilibrium.
reference::BeamHistory elastica_history(const DampingCase& asked, bool from_mode, double periods,
                                        int samples_per_period) {
  const reference::BeamLayout layout = layout_of(asked);
  const double period = 2 * pi / reference::beam_frequencies(layout).front();
  const reference::Release release =
      from_mode ? reference::Release{reference::Release::Shape::first_mode, asked.load / 3}
                : reference::Release{reference::Release::Shape::static_load, asked.load};
  return reference::damped_elastica(layout, release, sample_times(period, periods, samples_per_period));
}

/// Peaks asked for of the uniform linear beam with all its modes, against its first mode alone.
double higher_modes(const DampingCase& asked, double beam) {
  const reference::BeamDamping damping{reduced_retardation(asked), 0};
  const double period = 2 * pi / std::pow(reference::clamped_free_beta(1), 2);
  const auto times = sample_times(period, asked.peaks.last + 0.7, 200);
  const auto history = history_of(
      reference::damped_beam_modal(damping, {reference::Release::Shape::static_load, 0.01}, times, 40));
  try {
    return damping_from_peaks(positive_peaks(history), asked.peaks).ratio / beam - 1;
  } catch (const InputError&) {  // the higher modes make these peaks grow
    return nan;
  }
}

/// The damped Elastica measured as the chain.
void measure_elastica(DampingReferences& found, const DampingCase& asked, CleanPeaks clean) {
  const bool from_mode = clean.way == CleanPeaks::Way::mode_release;
  // a mode release starts at its peak 0 here: the beam's mode is let go at rest
  if (from_mode) clean.range = {clean.range.first + 1, clean.range.last + 1};
  const reference::BeamHistory beam = elastica_history(asked, from_mode, clean.periods(), 120);
  found.cvode = beam.statistics;
  try {
    const double frequency = reference::beam_frequencies(layout_of(asked)).front();
    found.elastica = first_mode_damping(history_of(beam), clean, frequency).peaks.ratio;
  } catch (const InputError&) {  // so much damped that its integrator's tolerance hides these peaks
  }
}

double unsheared_damping(const DampingCase& asked) {
  reference::LinearChain chain = linear_chain_of(asked);
  chain.stiffness.shear *= 1e8;
  chain.dashpot.shear *= 1e4;
  return reference::first_bending_mode(chain).damping;
}

}  // namespace

reference::LinearChain linear_chain_of(const DampingCase& asked) {
  return linear_chain_of(damped_fiber(asked));
}

TipHistory elastica_at(const DampingCase& asked, const std::vector<double>& times, double unit) {
  std::vector<double> reduced;
  for (const double t : times) reduced.push_back(t / unit);
  const reference::Release release{reference::Release::Shape::static_load, asked.load};
  return history_of(reference::damped_elastica(layout_of(asked), release, reduced));
}

DampingReferences damping_references(const DampingCase& asked, const reference::ChainMode& mode,
                                     const CleanPeaks& clean, bool with_elastica) {
  const double beam = reference::damped_beam_ratio({reduced_retardation(asked), 0}, 1);
  const double r = asked.aspect_ratio, half = r + 0.5;
  DampingReferences found{beam,
                          beam * r * r / (half * half),
                          unsheared_damping(asked),
                          mode.damping,
                          nan,
                          higher_modes(asked, beam),
                          {}};
  if (with_elastica) measure_elastica(found, asked, clean);
  return found;
}

}  // namespace fiberchain::compare
