#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/fit/fit.hpp"
#include "compare/measure/peaks.hpp"
#include "compare/study/jobs.hpp"

// What a and b of the paper's exponential come out as under choices that the paper does not state: which
// fibers, which load, which peaks, which weighting. A choice that gives the paper's numbers is a guess at
// what was done, no proof.
namespace fiberchain::compare {

/// The load that holds every fiber before its release.
struct ChoiceLoad {
  enum class Kind {
    reduced,  ///< P L^2 / (E I), the same for every fiber
    force     ///< P [N], the same for every fiber, of the nominal fiber (d = 2 mm, E = 2.6 MPa)
  };
  Kind kind;
  double value;
};

/// P L^2 / (E I) of a fiber with that many bonds.
double reduced_load(const ChoiceLoad& load, int aspect_ratio);

struct FitChoice {
  std::vector<int> aspect_ratios;
  ChoiceLoad load;
  PeakRange peaks;
  FitKind weighting;  ///< unweighted or logarithmic
};

/// Every combination of ten sets of aspect ratios, four loads, four ranges of peaks and both weightings.
std::vector<FitChoice> fit_choices();

/// One measurement: xi_f / xi_b of a static release.
struct SlopeRequest {
  int aspect_ratio;
  double load;  ///< P L^2 / (E I)
  PeakRange peaks;
};

/// Answers all requests, in their order.
using SlopeMeasurement = std::function<std::vector<double>(const std::vector<SlopeRequest>&)>;

/// The paper's cases on the chain itself: static releases of the nominal fiber, incremental bonds. One motion
/// answers every range of peaks asked of it.
SlopeMeasurement chain_slopes(const ChainKind& kind, const Jobs& jobs);

/// What became of a choice.
struct ChoiceOutcome {
  FitChoice choice;
  DampingFit fit;
  double departure_a;      ///< a / 0.03709 - 1
  double departure_b;      ///< b / 0.1615 - 1
  double departure_curve;  ///< largest |fit / Eq 20 - 1| over the choice's own aspect ratios
  double slope_8;          ///< xi_f / xi_b at r_f = 8 with this load and these peaks; the paper has 0.01045
  double slope_10;         ///< the same at 10; the paper has 0.00698
};

/// Larger of |departure_a| and |departure_b|.
double distance(const ChoiceOutcome& outcome);

/// Every choice fitted, nearest to the paper's a and b first. All that has to be measured is asked for at
/// once.
std::vector<ChoiceOutcome> choice_outcomes(const std::vector<FitChoice>& choices,
                                           const SlopeMeasurement& measure);

/// "6, 8, 10", "5..30", "8..30:2"
std::string describe(const std::vector<int>& aspect_ratios);
std::string describe(const ChoiceLoad& load);

}  // namespace fiberchain::compare
