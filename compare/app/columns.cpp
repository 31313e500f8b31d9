#include "dem/record/columns.hpp"

#include "compare/app/commands.hpp"
#include "compare/app/options.hpp"
#include "compare/study/json.hpp"
#include "compare/study/markdown.hpp"
#include "dem/record/table.hpp"

namespace fiberchain::app {
namespace {

int run_columns(const Arguments& arguments, Context& context) {
  dem::Table table({"column", "kind", "unit", "meaning"});
  for (const dem::Column& column : dem::all_columns()) {
    table.append({{"column", std::string(column.name)},
                  {"kind", std::string(to_string(column.kind))},
                  {"unit", std::string(column.unit)},
                  {"meaning", std::string(column.meaning)}});
  }
  const bool json = arguments.has("--json");
  context.out << (json ? dem::to_text(dem::to_json(table, context.provenance)) : dem::to_markdown(table));
  return kSuccess;
}

}  // namespace

Command columns_command() {
  return {.name = "columns",
          .description = "list every column of the tables: type, unit, meaning",
          .footer = "Example:\n  fiberchain columns --json",
          .options = {json_option()},
          .run = &run_columns};
}

}  // namespace fiberchain::app
