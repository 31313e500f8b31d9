#include "dem/math/monotone_cubic.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fiberchain::dem {
namespace {

/// Of an interval, as a function of x = 0 to 1: value v0 + x (r0 + x (c2 + x c3)).
struct Cubic {
  double width, v0, r0, c2, c3;
};

Cubic cubic_of(const MonotoneCubic& course, std::size_t n) {
  const double width = course.time[n + 1] - course.time[n], rise = course.value[n + 1] - course.value[n],
               r0 = width * course.rate[n], r1 = width * course.rate[n + 1];
  return {width, course.value[n], r0, 3 * rise - 2 * r0 - r1, r0 + r1 - 2 * rise};
}

double rate_of(const Cubic& c, double x) { return (c.r0 + x * (2 * c.c2 + x * 3 * c.c3)) / c.width; }

/// The interval of a time within.
std::size_t interval_of(const MonotoneCubic& course, double t) {
  return static_cast<std::size_t>(std::ranges::upper_bound(course.time, t) - course.time.begin()) - 1;
}

}  // namespace

double MonotoneCubic::at(double t) const {
  if (!(t > time.front())) return value.front();
  if (!(t < time.back())) return value.back();
  const std::size_t n = interval_of(*this, t);
  const Cubic c = cubic_of(*this, n);
  const double x = (t - time[n]) / c.width;
  return c.v0 + x * (c.r0 + x * (c.c2 + x * c.c3));
}

double MonotoneCubic::rate_at(double t) const {
  if (!(t > time.front()) || !(t < time.back())) return 0;
  const std::size_t n = interval_of(*this, t);
  const Cubic c = cubic_of(*this, n);
  return rate_of(c, (t - time[n]) / c.width);
}

double MonotoneCubic::largest_rate() const {
  double largest = 0;
  for (std::size_t n = 0; n + 1 < time.size(); ++n) {
    const Cubic c = cubic_of(*this, n);
    const double middle = c.c3 != 0 ? std::clamp(-c.c2 / (3 * c.c3), 0.0, 1.0) : 0;
    for (const double x : {0.0, middle, 1.0}) largest = std::max(largest, std::abs(rate_of(c, x)));
  }
  return largest;
}

MonotoneCubic monotone_cubic(std::vector<double> time, std::vector<double> value) {
  std::vector<double> rate(time.size(), 0);
  for (std::size_t n = 1; n + 1 < time.size(); ++n) {
    const double h0 = time[n] - time[n - 1], h1 = time[n + 1] - time[n], s0 = (value[n] - value[n - 1]) / h0,
                 s1 = (value[n + 1] - value[n]) / h1;
    if (!(s0 * s1 > 0)) continue;
    const double w0 = 2 * h1 + h0, w1 = h1 + 2 * h0;
    rate[n] = (w0 + w1) / (w0 / s0 + w1 / s1);
  }
  return {std::move(time), std::move(value), std::move(rate)};
}

}  // namespace fiberchain::dem
