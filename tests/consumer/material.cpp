#include "compare/calibration/calibration.hpp"

using namespace fiberchain;

double bond_damping_of(double loss_factor, int aspect_ratio) {
  const dem::Fiber fiber{dem::isotropic_material(2.6e6, 0.3, 1100), 1e-3, aspect_ratio};
  const double wanted = compare::to_damping_ratio(compare::DampingMeasure::loss_factor, loss_factor);
  return compare::calibrate({fiber}, wanted).fiber.bond_damping;
}
