#include "dem/model/fluid.hpp"

#include <fmt/format.h>
#include <cmath>
#include <numbers>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

void check_trace(const Gradient& A) {
  const double trace = A[0][0] + A[1][1] + A[2][2];
  if (std::abs(trace) > 1e-12 * largest_rate(A)) {
    throw InvalidInput(
        fmt::format("gradient: a trace of {:g} 1/s is not allowed: an incompressible fluid has 0", trace));
  }
}

void check_plane(const Gradient& A) {
  if (A[0][2] == 0 && A[1][2] == 0 && A[2][0] == 0 && A[2][1] == 0) return;
  throw InvalidInput("gradient: a planar fiber needs 0 at xz, yz, zx and zy, or it would leave the plane");
}

}  // namespace

template <int Dim>
void check(const Fluid& fluid) {
  if (!(fluid.viscosity > 0) || !std::isfinite(fluid.viscosity)) {
    throw InvalidInput(
        fmt::format("viscosity = {} is not allowed: it must be finite and greater than 0", fluid.viscosity));
  }
  const Gradient A = gradient_at(fluid.flow, 0);
  if (!std::isfinite(largest_rate(A))) throw InvalidInput("gradient: every value must be finite");
  if (!fluid.compressible) check_trace(fluid.flow.gradient), check_trace(A);
  if (Dim == 2) check_plane(fluid.flow.gradient), check_plane(A);
}

StokesDrag stokes_drag(const Fluid& fluid, const Fiber& fiber) {
  if (fiber.spacing != 1) {
    throw InvalidInput(fmt::format(
        "spacing = {} is not allowed in a fluid: its drag is that of spheres that touch", fiber.spacing));
  }
  const double R = sphere_radius(fiber);
  return {6 * std::numbers::pi * fluid.viscosity * R, 8 * std::numbers::pi * fluid.viscosity * R * R * R};
}

template void check<2>(const Fluid&);
template void check<3>(const Fluid&);

}  // namespace fiberchain::dem
