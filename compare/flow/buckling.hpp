#pragma once

#include <functional>

#include "compare/flow/study.hpp"

// A straight chain along the axis on which planar extension compresses it: does a small even bend decay or
// grow?
namespace fiberchain::compare {

struct BucklingCase {
  int spheres = 10;
  double number = 200;    ///< 3 pi mu rate L^4/(E I), rate of compression
  double bend = 1e-4;     ///< height of the parabola at the start over the length of the bonds
  double duration = 1.5;  ///< in 1/rate
  double tolerance = 1e-11;
  double poisson_ratio = 0.3;
};

/// Amplitude over time of the part of the deflection along P_2, which no translation or rotation has.
struct BucklingRun {
  std::vector<double> time;       ///< rate times time
  std::vector<double> amplitude;  ///< over that at the start
  double growth;  ///< least squares of ln(amplitude) over the last two thirds of the time, over rate
  std::vector<FlowShape> shapes;  ///< over the length of the bonds
};

/// Starts straight but for the bend, its bonds free of stress: they take up the flow's compression within a
/// hundredth of 1/rate, and higher modes decay. Throws dem::Diverged when it cannot be followed.
BucklingRun run_buckling(const BucklingCase& asked, int shapes = 0);

/// The number at which the bend neither grows nor decays, between one below at which a run decays and one
/// above at which it grows.
struct Threshold {
  double below, above;
  double middle() const { return (below + above) / 2; }
};

/// The part along P_2, which no translation or rotation has, of a deflection across that direction: a sum, no
/// mean.
double even_part(const FlowShape& shape, double across_x, double across_y);

/// By bisection from `low` to `high`. Throws InputError if the bend does not decay at `low` and grow at
/// `high`.
Threshold threshold_between(int spheres, double low, double high, double width,
                            const std::function<bool(double)>& grows);

/// By bisection from `low` to `high`. Throws InputError if the bend does not decay at `low` and grow at
/// `high`.
Threshold buckling_threshold_of(int spheres, double low, double high, double width);

FlowStudy buckling_study(const OrbitOptions& options);

}  // namespace fiberchain::compare
