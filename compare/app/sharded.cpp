#include "compare/app/sharded.hpp"

#include <fmt/format.h>

#include <numeric>

#include "compare/study/errors.hpp"
#include "compare/study/merge.hpp"
#include "compare/study/tabulate.hpp"

namespace fiberchain::app {
namespace {

void be_shard(const std::vector<std::size_t>& own, std::size_t cases, const compare::Shard& shard,
              Context& context) {
  if (own.empty())
    throw compare::InputError(
        fmt::format("--shard: no case is left for {}: there are {}", to_string(shard), cases));
  context.provenance.shard = compare::shard_words(shard, cases);
  context.log->info("shard {}: {} of {} cases", to_string(shard), own.size(), cases);
}

}  // namespace

std::vector<std::size_t> deal(std::size_t cases, const OutputOptions& output, Context& context) {
  const std::vector<std::size_t> own = compare::dealt(output.shard.value_or(compare::Shard{}), cases);
  if (output.shard) be_shard(own, cases, *output.shard, context);
  return own;
}

std::vector<std::size_t> deal_by_cost(const std::vector<double>& costs, const OutputOptions& output,
                                      Context& context) {
  const std::vector<std::size_t> own = compare::dealt_by_cost(output.shard.value_or(compare::Shard{}), costs);
  if (output.shard) be_shard(own, costs.size(), *output.shard, context);
  return own;
}

dem::Table with_cases(const dem::Table& table, const std::vector<std::size_t>& numbers) {
  dem::Table numbered(
      compare::joined(std::vector<std::string>{std::string(compare::case_column)}, table.columns()));
  if (numbers.size() != table.rows().size())
    throw dem::TableError(fmt::format("{} case numbers for {} rows", numbers.size(), table.rows().size()));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    dem::NamedRow row{{compare::case_column, static_cast<std::int64_t>(numbers[i] + 1)}};
    for (std::size_t j = 0; j < table.columns().size(); ++j)
      row.emplace_back(table.columns()[j], table.rows()[i][j]);
    numbered.append(row);
  }
  return numbered;
}

dem::Table table_of_case(const dem::Table& table, std::size_t number, const OutputOptions& output) {
  if (!output.shard) return table;
  return with_cases(table, std::vector<std::size_t>(table.rows().size(), number));
}

}  // namespace fiberchain::app
