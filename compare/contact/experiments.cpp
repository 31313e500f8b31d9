#include "compare/contact/experiments.hpp"

#include <fmt/format.h>

#include "compare/study/errors.hpp"
#include "dem/record/csv.hpp"
#include "dem/record/data_directory.hpp"

namespace fiberchain::compare {

ExperimentPoints experiment_points(const std::string& experiment, const std::string& quantity) {
  const dem::DataSearch search = dem::find_data("experiments");
  if (!search.found) throw InputError("no directory 'experiments' with measured points in " + search.tried);
  const std::filesystem::path file = *search.found / "experiments" / "oblique-impact.csv";
  const dem::Table table = dem::read_csv(file).table;
  ExperimentPoints points;
  for (std::size_t row = 0; row < table.rows().size(); ++row) {
    if (table.text(row, "experiment") != experiment || table.text(row, "impact_quantity") != quantity)
      continue;
    points.x.push_back(table.number(row, "abscissa"));
    points.y.push_back(table.number(row, "ordinate"));
  }
  if (points.x.empty())
    throw InputError(fmt::format("{}: no points of {}, {}", file.string(), experiment, quantity));
  return points;
}

}  // namespace fiberchain::compare
