#include <algorithm>

#include "compare/press/press.hpp"
#include "compare/study/errors.hpp"

namespace fiberchain::compare {
namespace {

/// Exponent of small beds, the mean of their seeds.
std::vector<Measured> exponent(const ValidationInput& in) {
  const std::vector<PressRun> runs = run_presses(press_cases(100, 20, 0.3, 1, 4), 48, in.jobs);
  std::vector<double> exponents;
  for (const PressRun& run : runs) {
    if (run.status != "finished") throw InputError("a press did not finish: " + run.status);
    exponents.push_back(fit_press(run).exponent);
  }
  const Spread n = spread_of(exponents);
  const PressCase& c = runs.front().asked;
  return {{n.mean,
           {c.fibers, c.aspect_ratio, c.friction, c.carries(), c.dense, static_cast<int>(n.count),
            half_width(n), n.least, n.most}}};
}

}  // namespace

const Checks& press_checks() {
  static const Checks checks{{.ids = {"press-van-wyk"}, .measure = exponent, .cost = 4}};
  return checks;
}

}  // namespace fiberchain::compare
