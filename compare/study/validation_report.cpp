#include "compare/study/validation_report.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "compare/study/errors.hpp"

namespace fiberchain::compare {

MatrixRow judged(MatrixRow row) {
  const bool within = std::abs(row.measured - row.expected) <= row.tolerance;
  row.verdict = within ? Verdict::holds : Verdict::fails;
  return row;
}

MatrixRow disputed(MatrixRow row) {
  if (row.reference_kind != ReferenceKind::published || row.evidence.empty()) {
    throw dem::TableError("row '" + row.id +
                          "': only a published claim can be disputed, and only with evidence");
  }
  row.verdict = Verdict::disputed;
  return row;
}

dem::Table to_table(const std::vector<MatrixRow>& rows) {
  dem::Table table({"id", "feature", "reference_kind", "expected", "measured", "difference", "tolerance",
                    "unit", "verdict", "source", "evidence"});
  std::set<std::string> ids;
  for (const MatrixRow& row : rows) {
    if (!ids.insert(row.id).second) throw dem::TableError("row '" + row.id + "' comes twice");
    table.append({{"id", row.id},
                  {"feature", row.feature},
                  {"reference_kind", to_string(row.reference_kind)},
                  {"expected", row.expected},
                  {"measured", row.measured},
                  {"difference", row.measured - row.expected},
                  {"tolerance", row.tolerance},
                  {"unit", row.unit},
                  {"verdict", to_string(row.verdict)},
                  {"source", row.source},
                  {"evidence", row.evidence}});
  }
  return table;
}

bool all_hold(const std::vector<MatrixRow>& rows) {
  return std::ranges::none_of(rows, [](const MatrixRow& row) { return row.verdict == Verdict::fails; });
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
