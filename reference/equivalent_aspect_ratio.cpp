#include "reference/equivalent_aspect_ratio.hpp"

#include <cmath>
#include <limits>

#include "reference/errors.hpp"

namespace fiberchain::reference {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Range {
  double low, high;
};

constexpr Range cox_range{4.66, infinity};             // r_e = r at exp(1.24^2) = 4.653
constexpr Range goldsmith_mason_range{1.36, 218};      // r_e = 1 at 1.352, highest at 0.742/0.0034 = 218.2
constexpr Range harris_pittman_range{2.32, infinity};  // r_e = r at 1.14^(1/0.156) = 2.316
constexpr Range zhang_range{1.66, 172};                // r_e = r at 1.658 and 172.197

double within(const Range& range, double aspect_ratio) {
  require_between("aspect_ratio", aspect_ratio, range.low, range.high);
  return aspect_ratio;
}

}  // namespace

double free_draining_bretherton(int spheres) {
  require_between("spheres", spheres, 1, 1000000);
  const double n = spheres;
  return (n * n - 1) / (n * n + 3);
}

double free_draining_aspect_ratio(int spheres) {
  require_between("spheres", spheres, 1, 1000000);
  const double n = spheres;
  return std::sqrt((n * n + 1) / 2);
}

double cox_aspect_ratio(double aspect_ratio) {
  const double r = within(cox_range, aspect_ratio);
  return 1.24 * r / std::sqrt(std::log(r));
}

double goldsmith_mason_aspect_ratio(double aspect_ratio) {
  const double r = within(goldsmith_mason_range, aspect_ratio);
  return (0.742 - 0.0017 * r) * r;
}

double harris_pittman_aspect_ratio(double aspect_ratio) {
  return 1.14 * std::pow(within(harris_pittman_range, aspect_ratio), 0.844);
}

double zhang_aspect_ratio(double aspect_ratio) {
  const double r = within(zhang_range, aspect_ratio);
  return ((3.5e-5 * r - 0.00467) * r + 0.764) * r + 0.404;
}

const std::vector<AspectRatioCorrelation>& aspect_ratio_correlations() {
  static const std::vector<AspectRatioCorrelation> all{
      {"Cox", &cox_aspect_ratio, cox_range.low, cox_range.high,
       "slender bodies (r -> infinity); r_e > r below 4.65",
       "R. G. Cox, J. Fluid Mech. 45 (1971) 625-657, doi 10.1017/S0022112071000259, as quoted in fiberoripy "
       "(N. Meyer, github.com/meyer-nils/fiberoripy, aspect_ratios.py)"},
      {"Goldsmith-Mason", &goldsmith_mason_aspect_ratio, goldsmith_mason_range.low,
       goldsmith_mason_range.high, "r_e < 1 below 1.35, falls beyond 218",
       "H. L. Goldsmith and S. G. Mason, in Rheology: Theory and Applications 4 (1967) 85-250, as quoted in "
       "fiberoripy, whose later versions give O. L. Forgacs and S. G. Mason, J. Colloid Sci. 14 (1959) "
       "457-472, "
       "as its source; fit to measured periods"},
      {"Harris-Pittman", &harris_pittman_aspect_ratio, harris_pittman_range.low, harris_pittman_range.high,
       "r_e > r below 2.32",
       "J. B. Harris and J. F. T. Pittman, J. Colloid Interface Sci. 50 (1975) 280-282; neither it nor a "
       "work "
       "quoting it was seen"},
      {"Zhang", &zhang_aspect_ratio, zhang_range.low, zhang_range.high, "r_e > r below 1.66 and beyond 172",
       "D. Zhang, D. E. Smith, D. A. Jack, S. Montgomery-Smith, J. Manuf. Sci. Eng. 133 (2011) 051002, doi "
       "10.1115/1.4004831 (abstract seen; finite elements, cylinders), formula as quoted in fiberoripy"}};
  return all;
}

}  // namespace fiberchain::reference
