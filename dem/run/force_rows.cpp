#include "dem/run/force_rows.hpp"

#include <string>
#include <utility>

namespace fiberchain::dem {
namespace {

/// visit(column) for all of them, in their order.
template <class Visit>
void each_column(const ForceColumns& columns, const Visit& visit) {
  for (const std::string_view name : {std::string_view("step"), std::string_view("simulated_time")})
    visit(name);
  visit(columns.number), visit(columns.name);
  for (const std::string_view name : columns.own) visit(name);
  for (const std::string_view name : columns.force) visit(name);
  for (const std::string_view name : columns.moment) visit(name);
  visit(columns.force_peak), visit(columns.moment_peak), visit(columns.work);
  for (const std::string_view name : columns.center) visit(name);
}

}  // namespace

Table force_table(const ForceColumns& columns) {
  std::vector<std::string> names;
  each_column(columns, [&](std::string_view name) { names.emplace_back(name); });
  return Table(names);
}

void append_force_row(Table& table, const ForceColumns& columns, const Assembly& assembly, std::size_t number,
                      const std::string& name, std::vector<Cell> own, const WallSample& sample) {
  std::vector<Cell> cells{assembly.steps(), assembly.time(), static_cast<std::int64_t>(number), name};
  for (Cell& cell : own) cells.push_back(std::move(cell));
  const auto add = [&](const Vec<double, 3>& v) { cells.insert(cells.end(), {v[0], v[1], v[2]}); };
  add(sample.mean.force), add(sample.mean.moment);
  cells.insert(cells.end(), {sample.force_peak, sample.moment_peak, sample.work});
  add(sample.center);
  NamedRow row;
  each_column(columns, [&](std::string_view column) { row.emplace_back(column, cells[row.size()]); });
  table.append(row);
}

}  // namespace fiberchain::dem
