#include "dem/model/velocity_gradient.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

void require_positive(const char* what, double value) {
  if (!(value > 0) || !std::isfinite(value)) {
    throw InvalidInput(
        fmt::format("{} = {} is not allowed: it must be finite and greater than 0", what, value));
  }
}

Gradient scaled(double factor, const Gradient& gradient) {
  Gradient result = gradient;
  for (auto& row : result.c) {
    for (double& value : row) value *= factor;
  }
  return result;
}

}  // namespace

Gradient gradient_at(const Flow& flow, double time) {
  return flow.at_time ? flow.at_time(time) : flow.gradient;
}

double largest_rate(const Gradient& A) {
  double size = 0;
  for (const auto& row : A.c) {
    for (const double value : row) size = std::isfinite(value) ? std::max(size, std::abs(value)) : INFINITY;
  }
  return size;
}

Gradient simple_shear(double rate) { return {{{0, rate, 0}, {0, 0, 0}, {0, 0, 0}}}; }

Gradient planar_extension(double rate) { return {{{rate, 0, 0}, {0, -rate, 0}, {0, 0, 0}}}; }

Gradient uniaxial_extension(double rate) { return {{{rate, 0, 0}, {0, -rate / 2, 0}, {0, 0, -rate / 2}}}; }

Gradient solid_rotation(double rate) { return {{{0, -rate, 0}, {rate, 0, 0}, {0, 0, 0}}}; }

Flow start_up(const Gradient& gradient, double time) {
  require_positive("start-up time", time);
  return {gradient, [=](double t) { return scaled(-std::expm1(-t / time), gradient); }};
}

Flow oscillation(const Gradient& gradient, double period, double phase) {
  require_positive("period", period);
  return {gradient,
          [=](double t) { return scaled(std::cos(2 * std::numbers::pi * t / period + phase), gradient); }};
}

}  // namespace fiberchain::dem
