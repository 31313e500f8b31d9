#include "compare/study/published.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "compare/study/errors.hpp"
#include "dem/record/build_info.hpp"
#include "dem/record/csv.hpp"

namespace fiberchain::compare {
namespace {

namespace fs = std::filesystem;

void check_unique(const std::vector<PublishedValue>& values, const PublishedValue& next,
                  const std::string& where) {
  if (next.id.empty()) throw InputError(where + ": column id is empty");
  if (std::ranges::find(values, next.id, &PublishedValue::id) != values.end()) {
    throw InputError(fmt::format("{}: column id: '{}' comes twice", where, next.id));
  }
}

void read_into(std::vector<PublishedValue>& values, const fs::path& file) {
  const dem::CsvDocument document = dem::read_csv(file);
  const dem::Table& table = document.table;
  for (const char* column :
       {"id", "feature", "quantity", "value", "unit", "source", "page_or_figure", "statement"}) {
    if (std::ranges::find(table.columns(), column) == table.columns().end()) {
      throw InputError(fmt::format("{}: column {} is missing", file.string(), column));
    }
  }
  for (std::size_t row = 0; row < table.rows().size(); ++row) {
    const auto text = [&](const char* column) { return table.text(row, column); };
    PublishedValue next{text("id"),   text("feature"), text("quantity"),       table.number(row, "value"),
                        text("unit"), text("source"),  text("page_or_figure"), text("statement")};
    check_unique(values, next, fmt::format("{}:{}", file.string(), document.lines[row]));
    values.push_back(std::move(next));
  }
}

}  // namespace

fs::path find_data_directory(const std::optional<fs::path>& asked) {
  const char* environment = std::getenv("FIBERCHAIN_DATA");
  std::error_code error;
  std::vector<fs::path> places;
  if (asked) {
    places = {*asked};
  } else if (environment && *environment) {
    places = {environment};
  } else {
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    places = {program.parent_path() / dem::kInstalledData, dem::kSourceData};
  }
  for (const fs::path& place : places) {
    if (fs::is_directory(place / "published", error)) return place;
  }
  std::string tried;
  for (const fs::path& place : places)
    tried += (tried.empty() ? "" : " or ") + place.lexically_normal().string();
  throw InputError("no directory 'published' with the published values in " + tried);
}

std::vector<PublishedValue> read_published(const fs::path& file) {
  std::vector<PublishedValue> values;
  read_into(values, file);
  return values;
}

std::vector<PublishedValue> read_all_published(const fs::path& data_directory) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(data_directory / "published")) {
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  }
  if (files.empty()) throw InputError(data_directory.string() + "/published holds no .csv file");
  std::ranges::sort(files);
  std::vector<PublishedValue> values;
  for (const fs::path& file : files) read_into(values, file);
  return values;
}

const PublishedValue& find_published(const std::vector<PublishedValue>& values, std::string_view id) {
  const auto found = std::ranges::find(values, id, &PublishedValue::id);
  if (found == values.end()) throw InputError(fmt::format("no published value has the id '{}'", id));
  return *found;
}

}  // namespace fiberchain::compare
