#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/elastica.hpp"
#include "reference/errors.hpp"

namespace fiberchain::reference {
namespace {

/// A trial of the paper's method: the free end moved to a = 1 - Delta. Kept as the excess of Delta over the
/// least shortening possible (where the free end would be vertical), so that 1 - q does not cancel.
struct Trial {
  Trial(double load_value, double excess_value) : load(load_value), excess(excess_value) {
    const double a_vertical = std::sqrt(2 / load);
    if (a_vertical < 1) {
      a = a_vertical - excess;
      one_minus_q = load * excess * (a_vertical - excess / 2);
    } else {
      a = 1 - excess;
      one_minus_q = 1 - load * a * a / 2;
    }
    q = load * a * a / 2;
  }

  double load;
  double excess;       ///< Delta - max(0, 1 - sqrt(2/load))
  double a;            ///< position of the free end, 1 - Delta
  double q;            ///< G at the free end, sin(theta_tip)
  double one_minus_q;  ///< 1 - q
};

double least_shortening(double load) { return std::max(0.0, 1 - std::sqrt(2 / load)); }

template <class Integrand>
double simpson(const Integrand& f, double end, int panels) {
  const double h = end / panels;
  double odd = 0;
  double even = 0;
  for (int i = 1; i < panels; i += 2) odd += f(i * h);
  for (int i = 2; i < panels; i += 2) even += f(i * h);
  return h / 3 * (f(0) + 4 * odd + 2 * even + f(end));
}

struct Integrals {
  double stretch;  ///< int (1/sqrt(1 - G^2) - 1) dx, which is Delta for the right trial
  double rise;     ///< int G/sqrt(1 - G^2) dx, the deflection
};

/// The integrals with x = kappa sinh(t), where 1 - G = (1 - q) cosh^2(t).
struct Regularized {
  static Integrals integrate(const Trial& trial, int panels) {
    const double scale = std::sqrt(2 / trial.load);
    const double end = std::asinh(std::sqrt(trial.q / trial.one_minus_q));
    const auto g_of = [&](double t) {
      const double s = std::sinh(t);
      return std::max(0.0, trial.q - trial.one_minus_q * s * s);
    };
    const auto stretch = [&](double t) {
      const double g = g_of(t);
      const double complement = std::sqrt(trial.one_minus_q) * std::cosh(t) * std::sqrt(1 + g);
      return g * g / (std::sqrt(1 + g) * (1 + complement));
    };
    const auto rise = [&](double t) { return g_of(t) / std::sqrt(1 + g_of(t)); };
    return {scale * simpson(stretch, end, panels), scale * simpson(rise, end, panels)};
  }
};

/// The integrals as printed, equal panels in x.
struct AsPrinted {
  static Integrals integrate(const Trial& trial, int panels) {
    const auto g_of = [&](double x) { return trial.load / 2 * (trial.a - x) * (trial.a + x); };
    const auto complement = [&](double x) {
      return std::sqrt((trial.one_minus_q + trial.load / 2 * x * x) * (1 + g_of(x)));
    };
    const auto stretch = [&](double x) { return 1 / complement(x) - 1; };
    const auto rise = [&](double x) { return g_of(x) / complement(x); };
    return {simpson(stretch, trial.a, panels), simpson(rise, trial.a, panels)};
  }
};

struct Bisected {
  TipState tip;
  double width;
  int bisections;
};

TipState tip_of(const Trial& trial, const Integrals& integrals) {
  const double angle = trial.q < 0.5 ? std::asin(trial.q)
                                     : std::numbers::pi / 2 - 2 * std::asin(std::sqrt(trial.one_minus_q / 2));
  return {integrals.rise, 1 - trial.a, angle};
}

template <class Rule>
Bisected bisect(double load, int panels) {
  const double least = least_shortening(load);
  double low = 0;
  double high = std::min(1.0, std::sqrt(2 / load));
  int bisections = 0;
  // Too little shortening makes the curve longer than L. The bracket is halved to its own last bit.
  for (double middle = high / 2; middle > low && middle < high; middle = low + (high - low) / 2) {
    const bool too_long = Rule::integrate({load, middle}, panels).stretch > least + middle;
    (too_long ? low : high) = middle;
    ++bisections;
  }
  const Trial trial(load, high);
  TipState tip = tip_of(trial, Rule::integrate(trial, panels));
  tip.x = least + high;
  return {tip, high - low, bisections};
}

template <class Rule>
PaperElastica with_error(double load, int panels) {
  require_between("load", load, 0, max_elastica_load);
  require_between("panels", panels, 4, 100000);
  if (panels % 4 != 0) throw InvalidArgument("panels", panels, "a multiple of 4, 4 to 100000");
  if (load == 0) return {};
  const Bisected fine = bisect<Rule>(load, panels);
  const Bisected coarse = bisect<Rule>(load, panels / 2);
  const TipState error{std::abs(fine.tip.y - coarse.tip.y) + fine.width,
                       std::abs(fine.tip.x - coarse.tip.x) + fine.width,
                       std::abs(fine.tip.angle - coarse.tip.angle) + fine.width};
  return {fine.tip, error, fine.width, fine.bisections};
}

}  // namespace

PaperElastica elastica_paper(double load, int panels) { return with_error<Regularized>(load, panels); }

PaperElastica elastica_paper_singular(double load, int panels) { return with_error<AsPrinted>(load, panels); }

}  // namespace fiberchain::reference
