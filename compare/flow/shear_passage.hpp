#pragma once

// A small even bend of a fiber that turns through the direction of greatest compression in simple shear, 45
// degrees against the flow. There the fiber turns with the vorticity, and what is left of the flow is planar
// extension at half the rate.
namespace fiberchain::compare {

struct ShearPassage {
  int spheres = 20;
  double number = 400;  ///< 3 pi mu rate L^4/(E I) with the shear rate
  double bend = 1e-5;   ///< at the start, over the length of the bonds
  double tolerance = 1e-11;
  double poisson_ratio = 0.3;
};

/// d ln(amplitude)/dt over the shear rate as the fiber passes 45 degrees. It starts 0.35 rad before: what is
/// no first mode has decayed by then. Throws dem::Diverged when it cannot be followed.
double growth_at_passage(const ShearPassage& asked);

/// The number at which the bend neither grows nor decays there, by bisection between `low` and `high`.
/// Throws InputError if it does not decay at `low` and grow at `high`.
double passage_threshold(int spheres, double low, double high, double width);

}  // namespace fiberchain::compare
