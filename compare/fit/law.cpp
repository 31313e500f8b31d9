#include "compare/fit/law.hpp"

#include <fmt/format.h>

#include <cmath>

#include "compare/study/errors.hpp"
#include "compare/study/nan.hpp"
#include "reference/chain_modes.hpp"
#include "reference/damped_beam.hpp"

namespace fiberchain::compare {
namespace {

void check(int aspect_ratio, const ChainKind& kind) {
  if (aspect_ratio < 1)
    throw InputError(fmt::format("aspect ratio {} is not allowed: it must be 1 or more", aspect_ratio));
  if (!(kind.bond_damping > 0) || !std::isfinite(kind.bond_damping)) {
    throw InputError(fmt::format("bond damping {} is not allowed: it must be above 0", kind.bond_damping));
  }
}

/// NaN if the first mode is overdamped.
double slope_or_nan(int aspect_ratio, const ChainKind& kind) {
  const auto chain = reference::linear_chain({aspect_ratio, 1, 1, kind.poisson_ratio, 1});
  const auto mode = reference::first_bending_mode(reference::with_bond_damping(chain, kind.bond_damping));
  return mode.oscillates ? mode.damping / kind.bond_damping : nan;
}

}  // namespace

std::string_view name(DampingLaw law) {
  switch (law) {
    case DampingLaw::exponential:
      return "exponential";
    case DampingLaw::power:
      return "power";
    default:
      return "shifted_square";
  }
}

int parameter_count(DampingLaw law) { return law == DampingLaw::shifted_square ? 1 : 2; }

double long_chain_coefficient() {
  static const double coefficient = std::pow(reference::clamped_free_beta(1), 2) / std::sqrt(20.0);
  return coefficient;
}

double damping_law(DampingLaw law, const std::vector<double>& p, double r_f) {
  switch (law) {
    case DampingLaw::exponential:
      return p[0] * std::exp(-p[1] * r_f);
    case DampingLaw::power:
      return p[0] * std::pow(r_f, -p[1]);
    default:
      return long_chain_coefficient() / ((r_f + p[0]) * (r_f + p[0]));
  }
}

std::vector<double> damping_law_slopes(DampingLaw law, const std::vector<double>& p, double r_f) {
  const double y = damping_law(law, p, r_f);
  switch (law) {
    case DampingLaw::exponential:
      return {std::exp(-p[1] * r_f), -r_f * y};
    case DampingLaw::power:
      return {std::pow(r_f, -p[1]), -std::log(r_f) * y};
    default:
      return {-2 * y / (r_f + p[0])};
  }
}

double linear_chain_slope(int aspect_ratio, const ChainKind& kind) {
  check(aspect_ratio, kind);
  const double slope = slope_or_nan(aspect_ratio, kind);
  if (std::isnan(slope)) {
    throw InputError(
        fmt::format("the first mode of a chain with aspect ratio {} and bond damping {} is overdamped",
                    aspect_ratio, kind.bond_damping));
  }
  return slope;
}

ChainCurve chain_curve(const ChainKind& kind, AspectRange range) {
  check(range.first, kind);
  ChainCurve curve{range, {}};
  for (int r_f = range.first; r_f <= range.last; ++r_f) curve.slope.push_back(slope_or_nan(r_f, kind));
  return curve;
}

std::vector<AspectRange> region_within(DampingLaw law, const std::vector<double>& parameters,
                                       const ChainCurve& curve, double tolerance) {
  std::vector<AspectRange> region;
  for (std::size_t i = 0; i < curve.slope.size(); ++i) {
    const int r_f = curve.range.first + static_cast<int>(i);
    const double off = damping_law(law, parameters, r_f) / curve.slope[i] - 1;
    if (!(std::abs(off) <= tolerance)) continue;
    if (!region.empty() && region.back().last == r_f - 1) {
      region.back().last = r_f;
    } else {
      region.push_back({r_f, r_f});
    }
  }
  return region;
}

std::string describe(const std::vector<AspectRange>& region) {
  std::string text;
  for (const AspectRange& run : region) {
    if (!text.empty()) text += ", ";
    text += run.first == run.last ? fmt::format("{}", run.first) : fmt::format("{}..{}", run.first, run.last);
  }
  return text.empty() ? "nowhere" : text;
}

}  // namespace fiberchain::compare
