#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace fiberchain::reference {

/// An argument outside what a reference solution is defined for. The message names the argument, the
/// value given and the values allowed.
class InvalidArgument : public std::runtime_error {
 public:
  InvalidArgument(std::string_view argument, double value, std::string_view allowed);
};

/// An iteration or an integration that did not reach its tolerance. The message names what was sought.
class NoConvergence : public std::runtime_error {
 public:
  explicit NoConvergence(const std::string& what);
};

/// Throws InvalidArgument unless lowest <= value <= highest; NaN and infinities are refused.
void require_between(std::string_view argument, double value, double lowest, double highest);

/// Throws InvalidArgument unless value is finite and greater than zero.
void require_positive(std::string_view argument, double value);

/// Throws InvalidArgument unless value is greater than zero; plus infinity (rigid) is allowed.
void require_positive_or_infinite(std::string_view argument, double value);

}  // namespace fiberchain::reference
