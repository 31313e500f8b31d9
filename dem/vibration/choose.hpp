#pragma once

#include <string>

#include "dem/vibration/release.hpp"

namespace fiberchain::dem {

/// An integrator, its step, and why.
struct IntegratorChoice {
  Integrator integrator;
  double step_ratio;  ///< dt / t_b
  std::string reason;
};

/// The cheapest integrator of a ring-down that keeps `options.error` in damping and frequency. Errors are
/// those of the schemes on the first mode, w = 2 pi / period, q = (w dt)^2: lagged leapfrog xi_f w dt / 2 + q
/// / 24, solved leapfrog q / 24, implicit q / 6; costs are those of a bond in a step, a chain alone, at
/// measured ratios (choose.cpp). An implicit step turns the free end by 0.02 rad at most; higher modes than
/// the first may be unresolved.
template <int Dim>
IntegratorChoice choose_integrator(const Release<Dim>& release, const ReleaseOptions& options);

}  // namespace fiberchain::dem
