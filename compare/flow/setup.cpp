#include "compare/flow/setup.hpp"

#include <cmath>
#include <numbers>

#include "compare/static/case.hpp"

namespace fiberchain::compare {
namespace {

double hydrodynamic_length(const dem::Fiber& fiber) { return fiber.diameter * (fiber.aspect_ratio + 1); }

}  // namespace

dem::Fiber fiber_of_spheres(int spheres, double poisson_ratio) {
  const dem::Fiber fiber = nominal_fiber(spheres - 1, poisson_ratio, dem::BondModel::paper);
  dem::check(fiber);
  return fiber;
}

double elasto_viscous_number(const dem::Fiber& fiber, double viscosity, double rate) {
  return 3 * std::numbers::pi * viscosity * rate * std::pow(hydrodynamic_length(fiber), 4) /
         dem::bending_stiffness(fiber);
}

double viscosity_of(const dem::Fiber& fiber, double elasto_viscous, double rate) {
  return elasto_viscous / elasto_viscous_number(fiber, 1.0, rate);
}

}  // namespace fiberchain::compare
