#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/study/published.hpp"
#include "dem/record/table.hpp"

/// The validation matrix: a row per claim, held against what is measured here.
namespace fiberchain::compare {

enum class Verdict {
  holds,          ///< what is measured is within the claim
  holds_only_if,  ///< only under the row's condition, which the source does not name
  disputed,       ///< it is not
  fails           ///< a row without a published claim is not as expected
};

/// The same quantity where the row's condition does not hold.
struct MeasuredOtherwise {
  double expected, measured, tolerance;
};

struct ValidationRow {
  std::string id;       ///< unique
  std::string feature;  ///< what is tested
  ReferenceKind reference_kind;
  std::string quantity;
  double expected;   ///< here, in `unit`
  double measured;   ///< value found here
  double tolerance;  ///< largest |measured - expected| at which the row is as expected
  std::string unit;  ///< "1" where dimensionless
  std::optional<ClaimedRange> claim;
  std::string condition;  ///< "-" where the claim is measured as the source states it
  std::optional<MeasuredOtherwise> otherwise;
  std::optional<bool> as_expected;  ///< none: nothing is expected of these runs
  Verdict verdict;
  std::string reading;   ///< how the source's words became the claim; "-" without one
  std::string basis;     ///< where the expected value is from; "-": from the source
  std::string source;    ///< publication, page and words, or derivation
  std::string evidence;  ///< how it was measured
};

/// The row with what follows from its numbers: whether it is as expected on both sides of the condition, and
/// its verdict. A claim is judged by the measured values alone; a row without one holds if it is as expected.
/// A NaN is neither expected nor within a claim.
ValidationRow judged(ValidationRow row);

/// The row of a published claim judged by its claim alone, for runs of which nothing is expected.
/// @throws dem::TableError for a row without a claim
ValidationRow judged_by_claim(ValidationRow row);

/// The rows as a table.
/// @throws TableError if an id comes twice
dem::Table to_table(const std::vector<ValidationRow>& rows);

/// Whether every row is as expected.
bool all_as_expected(const std::vector<ValidationRow>& rows);

std::string to_string(Verdict verdict);

}  // namespace fiberchain::compare
