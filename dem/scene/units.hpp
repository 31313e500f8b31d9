#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

struct ut_system;

namespace fiberchain::dem {

/// A text that is no number, or a unit that is unknown or of another dimension.
struct UnitError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// The units of UDUNITS-2: SI with its prefixes, and all that converts to it by a factor. All share one
/// database, which the first one loads (some 10 ms).
class Units {
 public:
  /// @throws UnitError if it is not installed
  Units();

  /// Value in the SI unit `si` of a quantity as typed: "2 mm", "2.6e6 Pa"; a bare number is in `si`.
  /// @throws UnitError saying what is wrong and what is allowed
  double to_si(std::string_view text, std::string_view si) const;

 private:
  double factor(std::string_view unit, std::string_view si) const;

  const ut_system* system_;
};

}  // namespace fiberchain::dem
