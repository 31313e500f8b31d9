#pragma once

#include <functional>

namespace fiberchain::compare {

/// K'(high)/K'(low) that causality wants of a loss factor tan delta(omega), which must go as omega at low
/// frequencies and fall at high ones, angular frequencies [rad/s]: Kramers and Kronig's relation for
/// ln K, phase delta, as
///   ln|K(w)/K(0)| = (2/pi) int (delta(w e^u) - delta(w) e^u)/(1 - e^2u) du.
double causal_rise(const std::function<double(double)>& loss_factor, double low, double high);

}  // namespace fiberchain::compare
