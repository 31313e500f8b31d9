#pragma once

#include <limits>
#include <string>
#include <string_view>

namespace fiberchain::compare {

/// Values for which a published sentence is true, as a row of data/published states it: "0.235..0.245" (ends
/// included), "< 3.3", "<= 3.3", "> 0", ">= 1", or "not 0.95..1.05" (everything else).
class ClaimedRange {
 public:
  /// Throws InputError saying what is allowed for another text, or a range without inside or outside.
  explicit ClaimedRange(std::string_view text);

  /// Whether the sentence is true of the value; never of a NaN.
  bool contains(double value) const;

  /// Whether all values from `low` to `high` are on one side of it.
  bool decides(double low, double high) const;

  const std::string& text() const { return text_; }

 private:
  std::string text_;
  double low_ = -std::numeric_limits<double>::infinity(), high_ = -low_;
  bool low_open_ = false, high_open_ = false, complement_ = false;
};

}  // namespace fiberchain::compare
