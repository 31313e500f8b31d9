#pragma once

#include <memory>
#include <optional>
#include <string>

#include "compare/app/command.hpp"
#include "dem/material/frequency_band.hpp"
#include "dem/scene/units.hpp"

namespace fiberchain::app {

/// Numbers and quantities with units that were typed. The database of units is read once, and only where a
/// unit is typed. Throws InputError.
class Quantities {
 public:
  explicit Quantities(const Arguments& arguments) : arguments_(arguments) {}

  bool has(const std::string& option) const { return arguments_.has(option); }

  /// A quantity with its unit, or a bare number in the SI unit.
  double quantity(const std::string& option, const std::string& si, double usual) const;
  std::optional<double> quantity(const std::string& option, const std::string& si) const;
  double number(const std::string& option, double usual) const;
  std::optional<double> number(const std::string& option) const;

  /// "10 Hz,10 kHz"
  std::optional<dem::FrequencyBand> band(const std::string& option) const;

  const std::shared_ptr<const dem::Units>& units() const;

 private:
  double to_si(const std::string& option, const std::string& text, const std::string& si) const;

  const Arguments& arguments_;
  mutable std::shared_ptr<const dem::Units> units_;
};

}  // namespace fiberchain::app
