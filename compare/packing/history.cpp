#include "compare/packing/history.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/study/errors.hpp"
#include "compare/study/nan.hpp"

namespace fiberchain::compare {
namespace {

using History = std::span<const PackingSample>;

/// First sample from `from` on where the mean height stops to fall (sign 1) or to rise (sign -1). The last
/// one is none: it may go on.
std::optional<std::size_t> first_turn(History h, std::size_t from, double sign) {
  for (std::size_t i = from; i + 1 < h.size(); ++i) {
    if (sign * (h[i + 1].mean_height - h[i].mean_height) > 0) return i;
  }
  return std::nullopt;
}

}  // namespace

std::string_view name(PackingStage stage) {
  switch (stage) {
    case PackingStage::reaching:
      return "reaching the bottom";
    case PackingStage::densest:
      return "densest";
    case PackingStage::expanded:
      return "expanded";
    case PackingStage::at_rest:
      return "at rest";
  }
  throw InputError("no such stage");
}

std::optional<std::size_t> find_stage(History history, PackingStage stage) {
  if (history.empty()) return std::nullopt;
  if (stage == PackingStage::at_rest) return history.size() - 1;
  const auto fastest = std::ranges::min_element(history, {}, &PackingSample::vertical_speed);
  if (!(fastest->vertical_speed < 0)) return std::nullopt;
  const auto reaching = static_cast<std::size_t>(fastest - history.begin());
  if (stage == PackingStage::reaching) return reaching;
  const auto densest = first_turn(history, reaching, 1);
  if (stage == PackingStage::densest || !densest) return densest;
  return first_turn(history, *densest, -1);
}

BendingParts bending_parts(History history) {
  if (history.size() < 10) throw InputError("a packing's history of fewer than 10 samples");
  const auto angle = &PackingSample::bending_angle;
  const auto peak = std::ranges::max_element(history, {}, angle);
  const auto trough = std::ranges::min_element(peak, history.end(), {}, angle);
  const double from = history.back().time - 0.2 * (history.back().time - history.front().time);
  double sum = 0, least = std::numeric_limits<double>::infinity(), most = -least;
  int count = 0;
  for (const PackingSample& sample : history) {
    if (sample.time < from) continue;
    sum += sample.bending_angle, ++count;
    least = std::min(least, sample.bending_angle), most = std::max(most, sample.bending_angle);
  }
  const double plateau = sum / count;
  return {peak->bending_angle, peak->time, trough->bending_angle,
          trough->time,        plateau,    (most - least) / 2 / plateau};
}

Spread spread_of(std::span<const double> values) {
  if (values.empty()) throw InputError("spread of no values");
  Spread s{.count = values.size(), .least = values[0], .most = values[0]};
  const double n = static_cast<double>(values.size());
  for (const double v : values) {
    s.mean += v / n;
    s.least = std::min(s.least, v), s.most = std::max(s.most, v);
  }
  double squares = 0;
  for (const double v : values) squares += (v - s.mean) * (v - s.mean);
  s.deviation = values.size() > 1 ? std::sqrt(squares / (n - 1)) : nan;
  return s;
}

double half_width(const Spread& spread) {
  if (spread.count < 2) return nan;
  const double n = static_cast<double>(spread.count);
  return gsl_cdf_tdist_Pinv(0.975, n - 1) * spread.deviation / std::sqrt(n);
}

}  // namespace fiberchain::compare
