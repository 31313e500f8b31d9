#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/study/published.hpp"
#include "dem/record/table.hpp"

/// The validation matrix as a reader meets it: every claim with what was measured of it, or that nothing was.
namespace fiberchain::compare {

/// A row, as text; "" where there is nothing.
struct MatrixEntry {
  std::string id, subject, feature, kind, quantity, claim, expected, measured, tolerance, unit;
  std::string verdict;  ///< "not measured" where no table has the row
  std::string condition, otherwise, reading, basis, source, place, statement, evidence;
  bool as_expected = true;  ///< false where a measured value is not
  bool of_paper = false;    ///< claimed by the paper
  int figure = 0;           ///< of the paper, first that its place names; 0: none
};

/// How many rows there are of each kind; `failed`: not as expected, whatever the verdict.
struct MatrixCounts {
  int all = 0, holds = 0, holds_only_if = 0, disputed = 0, failed = 0, not_measured = 0;
};

/// A row for every claim, in their order, from the first table that has its id; behind them rows of the
/// tables that are no claim's.
/// @param tables as `to_table(validation rows)` or read back from validation.csv
std::vector<MatrixEntry> matrix_entries(const std::vector<Claim>& claims,
                                        const std::vector<dem::Table>& tables);

MatrixCounts counts_of(const std::vector<MatrixEntry>& entries);

/// Text of a claim with Greek letters and powers as such: "xi_f at PL^2/EI = 1" becomes "ξ_f at PL²/EI = 1".
std::string in_unicode(const std::string& text);

/// Number of the first figure that a place names, "p. 178, Fig 4; p. 181": 4; 0 if it names none.
int figure_named(const std::string& place);

}  // namespace fiberchain::compare
