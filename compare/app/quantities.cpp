#include "compare/app/quantities.hpp"

#include <fmt/format.h>

#include "compare/study/errors.hpp"
#include "dem/files/numbers.hpp"

namespace fiberchain::app {

using compare::InputError;

const std::shared_ptr<const dem::Units>& Quantities::units() const {
  if (!units_) units_ = std::make_shared<const dem::Units>();
  return units_;
}

double Quantities::to_si(const std::string& option, const std::string& text, const std::string& si) const {
  if (const auto number = dem::parse_number(text)) return *number;
  try {
    return units()->to_si(text, si);
  } catch (const dem::UnitError& error) {
    throw InputError(fmt::format("{}: '{}' {}", option, text, error.what()));
  }
}

std::optional<double> Quantities::quantity(const std::string& option, const std::string& si) const {
  if (!has(option)) return std::nullopt;
  return to_si(option, arguments_.text(option), si);
}

double Quantities::quantity(const std::string& option, const std::string& si, double usual) const {
  return quantity(option, si).value_or(usual);
}

std::optional<double> Quantities::number(const std::string& option) const {
  if (!has(option)) return std::nullopt;
  if (const auto value = dem::parse_number(arguments_.text(option))) return value;
  throw InputError(fmt::format("{}: '{}' is no number", option, arguments_.text(option)));
}

double Quantities::number(const std::string& option, double usual) const {
  return number(option).value_or(usual);
}

std::optional<dem::FrequencyBand> Quantities::band(const std::string& option) const {
  if (!has(option)) return std::nullopt;
  const std::string text = arguments_.text(option);
  const auto comma = text.find(',');
  if (comma == text.npos)
    throw InputError(fmt::format("{}: '{}' is no band such as '10 Hz,10 kHz'", option, text));
  return dem::FrequencyBand{to_si(option, text.substr(0, comma), "Hz"),
                            to_si(option, text.substr(comma + 1), "Hz")};
}

}  // namespace fiberchain::app
