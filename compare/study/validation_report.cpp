#include "compare/study/validation_report.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "compare/study/errors.hpp"
#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {

ValidationRow judged(ValidationRow row) {
  const bool within = std::abs(row.measured - row.expected) <= row.tolerance;
  row.verdict = within ? Verdict::holds : Verdict::fails;
  return row;
}

ValidationRow disputed(ValidationRow row) {
  if (row.reference_kind != ReferenceKind::published || row.evidence.empty()) {
    throw dem::TableError("row '" + row.id +
                          "': only a published claim can be disputed, and only with evidence");
  }
  row.verdict = Verdict::disputed;
  return row;
}

dem::Table to_table(const std::vector<ValidationRow>& rows) {
  std::set<std::string> ids;
  for (const ValidationRow& row : rows)
    if (!ids.insert(row.id).second) throw dem::TableError("row '" + row.id + "' comes twice");
  return tabulate(rows, [&](const ValidationRow& row) -> dem::NamedRow {
    return {{"id", row.id},
            {"feature", row.feature},
            {"reference_kind", to_string(row.reference_kind)},
            {"expected", row.expected},
            {"measured", row.measured},
            {"difference", row.measured - row.expected},
            {"tolerance", row.tolerance},
            {"unit", row.unit},
            {"verdict", to_string(row.verdict)},
            {"source", row.source},
            {"evidence", row.evidence}};
  });
}

bool all_hold(const std::vector<ValidationRow>& rows) {
  return std::ranges::none_of(rows, [](const ValidationRow& row) { return row.verdict == Verdict::fails; });
}

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::disputed:
      return "disputed";
    case Verdict::fails:
      return "fails";
  }
  throw dem::TableError("no such verdict");
}

}  // namespace fiberchain::compare
