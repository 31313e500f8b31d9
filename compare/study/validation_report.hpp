#pragma once

#include <string>
#include <vector>

#include "compare/study/published.hpp"
#include "dem/record/table.hpp"

/// The validation matrix: a row per claim, held against what is measured here.
namespace fiberchain::compare {

enum class Verdict {
  holds,     ///< |measured - expected| is within the tolerance
  disputed,  ///< published, found wrong here; the evidence says why
  fails      ///< must hold and does not
};

struct ValidationRow {
  std::string id;       ///< unique
  std::string feature;  ///< what is tested
  ReferenceKind reference_kind;
  double expected;   ///< value of the reference, in `unit`
  double measured;   ///< value found here
  double tolerance;  ///< largest |measured - expected| at which the row holds
  std::string unit;  ///< "1" where dimensionless
  Verdict verdict;
  std::string source;    ///< where the expected value comes from: publication and page, or derivation
  std::string evidence;  ///< how it was measured; why, if disputed
};

/// The row with its verdict set by the tolerance: holds or fails, and fails for a NaN.
ValidationRow judged(ValidationRow row);

/// The row as disputed, whatever the difference.
/// @throws TableError unless it is a published one and has evidence
ValidationRow disputed(ValidationRow row);

/// The rows as a table.
/// @throws TableError if an id comes twice
dem::Table to_table(const std::vector<ValidationRow>& rows);

/// Whether no row fails.
bool all_hold(const std::vector<ValidationRow>& rows);

std::string to_string(Verdict verdict);

}  // namespace fiberchain::compare
