#include "compare/study/validation_report.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "compare/study/errors.hpp"
#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {
namespace {

bool within(double measured, double expected, double tolerance) {
  return std::abs(measured - expected) <= tolerance;
}

/// A condition that makes no difference to the claim is none.
Verdict verdict_by_claim(const ValidationRow& row) {
  if (!row.claim->contains(row.measured)) return Verdict::disputed;
  if (row.condition == "-") return Verdict::holds;
  const bool holds_without = row.otherwise && row.claim->contains(row.otherwise->measured);
  return holds_without ? Verdict::holds : Verdict::holds_only_if;
}

std::string yes_or_no(std::optional<bool> value) { return !value ? "-" : *value ? "yes" : "no"; }

}  // namespace

ValidationRow judged(ValidationRow row) {
  const auto& other = row.otherwise;
  row.as_expected = within(row.measured, row.expected, row.tolerance) &&
                    (!other || within(other->measured, other->expected, other->tolerance));
  row.verdict = row.claim ? verdict_by_claim(row) : *row.as_expected ? Verdict::holds : Verdict::fails;
  return row;
}

ValidationRow judged_by_claim(ValidationRow row) {
  if (!row.claim) throw dem::TableError("row '" + row.id + "' has no claim to be judged by");
  row.as_expected.reset();
  row.verdict = verdict_by_claim(row);
  return row;
}

dem::Table to_table(const std::vector<ValidationRow>& rows) {
  std::set<std::string> ids;
  for (const ValidationRow& row : rows)
    if (!ids.insert(row.id).second) throw dem::TableError("row '" + row.id + "' comes twice");
  return tabulate(rows, [&](const ValidationRow& row) -> dem::NamedRow {
    const auto other = [&](double MeasuredOtherwise::*part) {
      return row.otherwise ? dem::Cell{*row.otherwise.*part} : dem::Cell{};
    };
    return {{"id", row.id},
            {"feature", row.feature},
            {"reference_kind", to_string(row.reference_kind)},
            {"quantity", row.quantity},
            {"claim", row.claim ? row.claim->text() : "-"},
            {"expected", row.expected},
            {"measured", row.measured},
            {"difference", row.measured - row.expected},
            {"tolerance", row.tolerance},
            {"unit", row.unit},
            {"as_expected", yes_or_no(row.as_expected)},
            {"verdict", to_string(row.verdict)},
            {"condition", row.condition},
            {"otherwise", other(&MeasuredOtherwise::measured)},
            {"otherwise_expected", other(&MeasuredOtherwise::expected)},
            {"otherwise_tolerance", other(&MeasuredOtherwise::tolerance)},
            {"reading", row.reading},
            {"basis", row.basis},
            {"source", row.source},
            {"evidence", row.evidence}};
  });
}

bool all_as_expected(const std::vector<ValidationRow>& rows) {
  return std::ranges::none_of(rows, [](const ValidationRow& row) { return row.as_expected == false; });
}

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::holds_only_if:
      return "holds only if";
    case Verdict::disputed:
      return "disputed";
    case Verdict::fails:
      return "fails";
  }
  throw dem::TableError("no such verdict");
}

}  // namespace fiberchain::compare
