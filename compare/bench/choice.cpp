#include <algorithm>

#include "compare/bench/row.hpp"

namespace fiberchain::compare {
namespace {

bool is_candidate(const PrecisionRow& row, Among among) {
  if (among == Among::all) return true;
  return among == Among::in_time ? row.in_time : row.as_paper;
}

}  // namespace

const PrecisionRow* cheapest(const std::vector<PrecisionRow>& rows, double wanted, Among among) {
  const PrecisionRow* best = nullptr;
  for (auto row = rows.begin(); row != rows.end(); ++row) {
    // a failed row's NaN is neither within nor beyond
    if (!is_candidate(*row, among) || !(row->error <= wanted)) continue;
    const bool lucky = std::any_of(row + 1, rows.end(), [&](const PrecisionRow& finer) {
      return finer.method == row->method && finer.error > wanted;
    });
    if (!lucky && (!best || row->time.least < best->time.least)) best = &*row;
  }
  return best;
}

}  // namespace fiberchain::compare
