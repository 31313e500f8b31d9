#pragma once

#include <string>
#include <string_view>
#include <vector>

// How a fiber's damping depends on its aspect ratio: xi_f / xi_b as a function of r_f, by the paper's
// formula, by others and by the linear chain itself.
namespace fiberchain::compare {

enum class DampingLaw {
  exponential,    ///< a exp(-b r_f), the paper's (Eq 20)
  power,          ///< a r_f^-b
  shifted_square  ///< (beta_1^2 / sqrt(20)) / (r_f + c)^2
};

std::string_view name(DampingLaw law);

/// Number of parameters: (a, b) of the first two laws, (c) of the third.
int parameter_count(DampingLaw law);

/// beta_1^2 / sqrt(20), beta_1 = 1.87510407 of the clamped-free beam: xi_f r_f^2 / xi_b of a long chain.
double long_chain_coefficient();

/// xi_f / xi_b.
double damping_law(DampingLaw law, const std::vector<double>& parameters, double aspect_ratio);

/// Its derivative by every parameter.
std::vector<double> damping_law_slopes(DampingLaw law, const std::vector<double>& parameters,
                                       double aspect_ratio);

/// a and b that the paper prints with Eq 20.
inline constexpr double kPaperA = 0.03709;
inline constexpr double kPaperB = 0.1615;

/// The chain that laws are held against.
struct ChainKind {
  double poisson_ratio = 0.3;
  double bond_damping = 1;  ///< xi_b, the paper's dashpots
};

/// xi_f / xi_b of the first bending mode of the clamped chain, exactly. Throws InputError for an aspect ratio
/// below 1, a xi_b that is not above 0, and an overdamped mode.
double linear_chain_slope(int aspect_ratio, const ChainKind& kind);

/// Whole aspect ratios first ... last.
struct AspectRange {
  int first, last;
};

/// The linear chain's xi_f / xi_b at every whole aspect ratio of a range; NaN where the first mode is
/// overdamped.
struct ChainCurve {
  AspectRange range;
  std::vector<double> slope;
};

/// Where regions are looked for: r_f = 3 ... 500.
inline constexpr AspectRange kRegion{3, 500};
ChainCurve chain_curve(const ChainKind& kind, AspectRange range = kRegion);

/// Where the law is within `tolerance` (relative) of the curve, as maximal runs of whole aspect ratios.
std::vector<AspectRange> region_within(DampingLaw law, const std::vector<double>& parameters,
                                       const ChainCurve& curve, double tolerance);

/// "8..11, 14" or "nowhere".
std::string describe(const std::vector<AspectRange>& region);

}  // namespace fiberchain::compare
