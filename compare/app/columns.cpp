#include "compare/results/columns.hpp"

#include "compare/app/commands.hpp"
#include "compare/app/options.hpp"
#include "compare/results/json.hpp"
#include "compare/results/markdown.hpp"
#include "compare/results/table.hpp"

namespace fiberchain::app {
namespace {

int run(const Arguments& arguments, Context& context) {
  compare::Table table({"column", "kind", "unit", "meaning"});
  for (const compare::Column& column : compare::all_columns()) {
    table.append({{"column", std::string(column.name)},
                  {"kind", std::string(to_string(column.kind))},
                  {"unit", std::string(column.unit)},
                  {"meaning", std::string(column.meaning)}});
  }
  const bool json = arguments.has("--json");
  context.out << (json ? compare::to_text(to_json(table, context.provenance)) : to_markdown(table));
  return kSuccess;
}

}  // namespace

Command columns_command() {
  return {.name = "columns",
          .description = "list every column of the tables: type, unit, meaning",
          .footer = "Example:\n  fiberchain columns --json",
          .options = {json_option()},
          .run = &run};
}

}  // namespace fiberchain::app
