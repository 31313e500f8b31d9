#include "reference/errors.hpp"

#include <cmath>
#include <sstream>

namespace fiberchain::reference {
namespace {

std::string number(double value) {
  std::ostringstream text;
  text.precision(12);
  text << value;
  return text.str();
}

std::string invalid_message(std::string_view argument, double value, std::string_view allowed) {
  return std::string(argument) + " is " + number(value) + "; allowed: " + std::string(allowed);
}

}  // namespace

InvalidArgument::InvalidArgument(std::string_view argument, double value, std::string_view allowed)
    : std::runtime_error(invalid_message(argument, value, allowed)) {}

NoConvergence::NoConvergence(const std::string& what) : std::runtime_error("no convergence: " + what) {}

void require_between(std::string_view argument, double value, double lowest, double highest) {
  if (value >= lowest && value <= highest && std::isfinite(value)) return;
  throw InvalidArgument(argument, value, "finite, " + number(lowest) + " to " + number(highest));
}

void require_positive(std::string_view argument, double value) {
  if (value > 0 && std::isfinite(value)) return;
  throw InvalidArgument(argument, value, "finite, greater than 0");
}

void require_positive_or_infinite(std::string_view argument, double value) {
  if (value > 0) return;
  throw InvalidArgument(argument, value, "greater than 0 (infinity: rigid)");
}

}  // namespace fiberchain::reference
