#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compare/app/context.hpp"
#include "compare/app/options.hpp"
#include "dem/record/table.hpp"

// What a run with --shard has of a study.
namespace fiberchain::app {

/// Numbers of the cases that this run has, ascending from 0; all without --shard. The provenance then says
/// which part it is.
/// @throws compare::InputError if there are fewer cases than shards
std::vector<std::size_t> deal(std::size_t cases, const OutputOptions& output, Context& context);

/// The same by what the cases cost.
std::vector<std::size_t> deal_by_cost(const std::vector<double>& costs, const OutputOptions& output,
                                      Context& context);

/// The items of these numbers.
template <class Item>
std::vector<Item> chosen(const std::vector<Item>& all, const std::vector<std::size_t>& numbers) {
  std::vector<Item> own;
  for (const std::size_t n : numbers) own.push_back(all[n]);
  return own;
}

/// The rows with the number of their case in front (dem::Table column "case", from 1).
/// @param numbers from 0, one for each row
dem::Table with_cases(const dem::Table& table, const std::vector<std::size_t>& numbers);

/// A table that is of one case as a whole.
dem::Table table_of_case(const dem::Table& table, std::size_t number, const OutputOptions& output);

/// The table of these points as `table_of` makes it of a list of them; for a shard made point by point, each
/// row with the number of its point's case. For tables whose rows depend on one point only.
template <class Point, class TableOf>
dem::Table table_by_case(const std::vector<Point>& points, const std::vector<std::size_t>& numbers,
                         const OutputOptions& output, const TableOf& table_of) {
  const dem::Table all = table_of(points);
  if (!output.shard) return all;
  std::vector<std::size_t> of_rows;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t rows = table_of(std::vector<Point>{points[i]}).rows().size();
    of_rows.insert(of_rows.end(), rows, numbers[i]);
  }
  return with_cases(all, of_rows);
}

}  // namespace fiberchain::app
