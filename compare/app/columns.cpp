#include "compare/columns.hpp"

#include "compare/app/commands.hpp"
#include "compare/json.hpp"
#include "compare/markdown.hpp"
#include "compare/table.hpp"

namespace fiberchain::app {

int run_columns(const ColumnsOptions& options, Context& context) {
  compare::Table table({"column", "kind", "unit", "meaning"});
  for (const compare::Column& column : compare::all_columns()) {
    table.append({{"column", std::string(column.name)},
                  {"kind", std::string(to_string(column.kind))},
                  {"unit", std::string(column.unit)},
                  {"meaning", std::string(column.meaning)}});
  }
  context.out << (options.json ? compare::to_text(to_json(table, context.provenance)) : to_markdown(table));
  return kSuccess;
}

}  // namespace fiberchain::app
