#include "dem/flow/stretch_limit.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

namespace fiberchain::dem {

double bearable_stretching(const Fiber& fiber, const Fluid& fluid) {
  const double half_wave = std::sin(std::numbers::pi / (2 * (fiber.aspect_ratio + 1)));
  return bond_stiffness(fiber).stretch * 4 * half_wave * half_wave / stokes_drag(fluid, fiber).translation;
}

double largest_stretching(const Gradient& gradient) {
  Eigen::Matrix3d A;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) A(r, c) = gradient[r][c];
  }
  const Eigen::Matrix3d D = 0.5 * (A + A.transpose());
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(D, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

std::string stretch_cause(const Fiber& fiber, const Fluid& fluid, double time) {
  return fmt::format("the flow stretches it by up to {:.4g} 1/s, its bonds bear {:.4g} 1/s along the fiber",
                     largest_stretching(gradient_at(fluid.flow, time)), bearable_stretching(fiber, fluid));
}

template <int Dim>
std::string stretch_failure(const Chain<Dim>& chain, const Poses<Dim>& poses, const Fluid& fluid,
                            double time) {
  constexpr double longest = 10;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const double length = norm(poses[i + 1].position - poses[i].position) / bond_length(chain.fiber);
    if (length <= longest) continue;
    return fmt::format(
        "the fiber is torn out: bond {} is {:.3g} times as long as at rest at t = {:.6g} s; likely cause: {}",
        i, length, time, stretch_cause(chain.fiber, fluid, time));
  }
  return {};
}

template std::string stretch_failure<2>(const Chain<2>&, const Poses<2>&, const Fluid&, double);
template std::string stretch_failure<3>(const Chain<3>&, const Poses<3>&, const Fluid&, double);

}  // namespace fiberchain::dem
