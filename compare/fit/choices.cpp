#include "compare/fit/choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "compare/measure/static_release.hpp"
#include "compare/static/case.hpp"

namespace fiberchain::compare {
namespace {

std::vector<int> every(int first, int last, int step) {
  std::vector<int> values;
  for (int value = first; value <= last; value += step) values.push_back(value);
  return values;
}

/// r_f = 8, 10, 20 and 30 are named in the paper's text and figures; it calls 6 too small and shows none
/// beyond 30.
std::vector<std::vector<int>> aspect_ratio_sets() {
  return {{6, 8, 10, 15, 20},  {6, 8, 10, 15, 20, 30},  {8, 10, 15, 20},      {8, 10, 20, 30},
          {8, 10, 15, 20, 30}, {8, 10, 12, 15, 20, 30}, {10, 15, 20, 25, 30}, every(8, 20, 2),
          every(8, 30, 2),     every(5, 30, 1)};
}

std::vector<ChoiceLoad> loads() {
  using Kind = ChoiceLoad::Kind;
  return {{Kind::reduced, 0.01}, {Kind::reduced, 1.0}, {Kind::force, 0.001}, {Kind::force, 0.004}};
}

/// Orders requests so that equal ones are asked once.
struct Earlier {
  static auto key(const SlopeRequest& r) {
    return std::tuple(r.aspect_ratio, r.load, r.peaks.first, r.peaks.last);
  }
  bool operator()(const SlopeRequest& a, const SlopeRequest& b) const { return key(a) < key(b); }
};
using Slopes = std::map<SlopeRequest, double, Earlier>;

SlopeRequest request_of(const FitChoice& choice, int aspect_ratio) {
  return {aspect_ratio, reduced_load(choice.load, aspect_ratio), choice.peaks};
}

Slopes measured(const std::vector<FitChoice>& choices, const SlopeMeasurement& measure) {
  Slopes slopes;
  for (const FitChoice& choice : choices) {
    for (const int aspect_ratio : choice.aspect_ratios) slopes[request_of(choice, aspect_ratio)] = 0;
    for (const int aspect_ratio : {8, 10}) slopes[request_of(choice, aspect_ratio)] = 0;
  }
  std::vector<SlopeRequest> requests;
  for (const auto& [request, slope] : slopes) requests.push_back(request);
  const std::vector<double> values = measure(requests);
  auto value = values.begin();
  for (auto& [request, slope] : slopes) slope = *value++;
  return slopes;
}

double curve_departure(const FitChoice& choice, const DampingFit& fit) {
  double largest = 0;
  for (const int r_f : choice.aspect_ratios) {
    const double paper = damping_law(DampingLaw::exponential, {kPaperA, kPaperB}, r_f);
    largest =
        std::max(largest, std::abs(damping_law(DampingLaw::exponential, fit.parameters, r_f) / paper - 1));
  }
  return largest;
}

ChoiceOutcome outcome_of(const FitChoice& choice, const Slopes& slopes) {
  std::vector<DampingDatum> points;
  for (const int r_f : choice.aspect_ratios) points.push_back({r_f, slopes.at(request_of(choice, r_f))});
  const DampingFit fit = fit_damping({DampingLaw::exponential, choice.weighting}, points);
  return {choice,
          fit,
          fit.parameters[0] / kPaperA - 1,
          fit.parameters[1] / kPaperB - 1,
          curve_departure(choice, fit),
          slopes.at(request_of(choice, 8)),
          slopes.at(request_of(choice, 10))};
}

}  // namespace

double reduced_load(const ChoiceLoad& load, int aspect_ratio) {
  if (load.kind == ChoiceLoad::Kind::reduced) return load.value;
  return load.value / dem::load_force(nominal_fiber(aspect_ratio, 0.3, dem::BondModel::paper), 1.0);
}

std::vector<FitChoice> fit_choices() {
  std::vector<FitChoice> choices;
  for (const auto& set : aspect_ratio_sets())
    for (const ChoiceLoad& load : loads())
      for (const PeakRange peaks : {PeakRange{0, 4}, {0, 9}, {1, 5}, {1, 10}})
        for (const FitKind kind : {FitKind::unweighted, FitKind::logarithmic})
          choices.push_back({set, load, peaks, kind});
  return choices;
}

SlopeMeasurement chain_slopes(const ChainKind& kind, const Jobs& jobs) {
  return [kind, jobs](const std::vector<SlopeRequest>& requests) {
    std::map<std::pair<int, double>, std::size_t> motions;  // one for each fiber and load
    std::vector<StaticReleaseRequest> releases;
    std::vector<std::pair<std::size_t, std::size_t>> places;
    for (const SlopeRequest& request : requests) {
      const auto [motion, is_new] =
          motions.try_emplace({request.aspect_ratio, request.load}, releases.size());
      if (is_new) {
        dem::Fiber fiber = nominal_fiber(request.aspect_ratio, kind.poisson_ratio, dem::BondModel::paper);
        fiber.bond_damping = kind.bond_damping;
        releases.push_back({fiber, request.load, {}});
      }
      places.emplace_back(motion->second, releases[motion->second].peaks.size());
      releases[motion->second].peaks.push_back(request.peaks);
    }
    const std::vector<StaticReleaseResult> results = static_release_damping(releases, jobs);
    std::vector<double> slopes;
    for (const auto& [release, range] : places)
      slopes.push_back(results[release].damping[range].ratio / kind.bond_damping);
    return slopes;
  };
}

double distance(const ChoiceOutcome& outcome) {
  return std::max(std::abs(outcome.departure_a), std::abs(outcome.departure_b));
}

std::vector<ChoiceOutcome> choice_outcomes(const std::vector<FitChoice>& choices,
                                           const SlopeMeasurement& measure) {
  const Slopes slopes = measured(choices, measure);
  std::vector<ChoiceOutcome> outcomes;
  for (const FitChoice& choice : choices) outcomes.push_back(outcome_of(choice, slopes));
  std::ranges::stable_sort(outcomes, {}, distance);
  return outcomes;
}

std::string describe(const std::vector<int>& values) {
  const bool evenly = values.size() > 5 && [&] {
    for (std::size_t i = 2; i < values.size(); ++i) {
      if (values[i] - values[i - 1] != values[1] - values[0]) return false;
    }
    return true;
  }();
  if (!evenly) return fmt::format("{}", fmt::join(values, ","));
  const int step = values[1] - values[0];
  return fmt::format("{}..{}", values.front(), values.back()) + (step == 1 ? "" : fmt::format(":{}", step));
}

std::string describe(const ChoiceLoad& load) {
  return load.kind == ChoiceLoad::Kind::reduced ? fmt::format("{:g}", load.value)
                                                : fmt::format("{:g} N", load.value);
}

}  // namespace fiberchain::compare
