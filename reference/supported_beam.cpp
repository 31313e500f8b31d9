#include "reference/supported_beam.hpp"

#include <algorithm>
#include <cmath>

#include "reference/errors.hpp"

namespace fiberchain::reference {
namespace {

/// Macaulay's bracket <x - a>^n.
double bracket(double x, double a, int n) { return x > a ? std::pow(x - a, n) : 0.0; }

void check(const SupportedBeam& beam) {
  require_between("points", beam.points, 2, 1e6);
  require_positive("spacing", beam.spacing);
  require_positive("load", beam.load);
  require_positive("bending stiffness", beam.bending);
  require_positive_or_infinite("shear stiffness", beam.shear);
  require_between("right support", beam.right, 1, beam.points - 1);
  require_between("left support", beam.left, 0, beam.right - 1);
}

}  // namespace

BeamOnSupports beam_on_supports(const SupportedBeam& beam) {
  check(beam);
  const double l = beam.spacing, a = beam.left * l, b = beam.right * l, weight = beam.points * beam.load;
  // moments about the supports
  const double middle = (beam.points - 1) * l / 2;
  const double right = weight * (middle - a) / (b - a), left = weight - right;

  const auto raw = [&](double x) {
    double bent = 0, sheared = 0;
    const auto add = [&](double force, double at) {
      bent += force * bracket(x, at, 3) / 6;
      sheared -= force * bracket(x, at, 1);
    };
    for (int i = 0; i < beam.points; ++i) add(beam.load, i * l);
    add(-left, a);
    add(-right, b);
    return bent / beam.bending + sheared / beam.shear;
  };
  const double at_a = raw(a), slope = (raw(b) - at_a) / (b - a);
  BeamOnSupports result{left, right, {}};
  for (int i = 0; i < beam.points; ++i) result.deflection.push_back(raw(i * l) - at_a - slope * (i * l - a));
  return result;
}

}  // namespace fiberchain::reference
