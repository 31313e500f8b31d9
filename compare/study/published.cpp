#include "compare/study/published.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/study/errors.hpp"
#include "dem/record/csv.hpp"
#include "dem/record/data_directory.hpp"

namespace fiberchain::compare {
namespace {

namespace fs = std::filesystem;

template <class Value, std::size_t n>
using Words = std::pair<const char*, Value>[n];

constexpr Words<ReferenceKind, 4> kKinds = {{"exact", ReferenceKind::exact},
                                            {"published", ReferenceKind::published},
                                            {"independent method", ReferenceKind::independent_method},
                                            {"regression", ReferenceKind::regression}};
constexpr Words<ToleranceScale, 3> kScales = {
    {"unit", ToleranceScale::unit}, {"value", ToleranceScale::value}, {"spread", ToleranceScale::spread}};

/// One row of a file, with the place that error messages name.
struct Line {
  const dem::Table& table;
  std::size_t row;
  std::string where;

  const std::string& text(const char* column) const {
    const std::string& cell = table.text(row, column);
    if (cell.empty()) throw InputError(fmt::format("{}: column {} is empty", where, column));
    return cell;
  }

  template <class Value, std::size_t n>
  Value choice(const char* column, const Words<Value, n>& words) const {
    const std::string& cell = text(column);
    for (const auto& [word, value] : words) {
      if (cell == word) return value;
    }
    throw InputError(fmt::format("{}: column {}: '{}' is none of its words", where, column, cell));
  }

  double number(const char* column) const { return table.number(row, column); }

  [[noreturn]] void refuse(const char* column, const std::string& why) const {
    throw InputError(fmt::format("{}: column {} {}", where, column, why));
  }
};

std::optional<ClaimedRange> range_of(const Line& line) {
  const std::string& text = line.text("claim");
  if (text == "-") return std::nullopt;
  try {
    return ClaimedRange(text);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: column claim: {}", line.where, error.what()));
  }
}

std::optional<Otherwise> otherwise_of(const Line& line) {
  const Otherwise found{line.number("otherwise_expected"), line.number("otherwise_tolerance")};
  if (std::isnan(found.value) && std::isnan(found.tolerance)) return std::nullopt;
  return found;
}

Claim read_claim(const Line& line, const std::string& subject) {
  return {.id = line.text("id"),
          .subject = subject,
          .feature = line.text("feature"),
          .kind = line.choice("reference_kind", kKinds),
          .quantity = line.text("quantity"),
          .value = line.number("value"),
          .tolerance = line.number("tolerance"),
          .scale = line.choice("tolerance_scale", kScales),
          .basis = line.text("basis"),
          .range = range_of(line),
          .reading = line.text("reading"),
          .condition = line.text("condition"),
          .otherwise = otherwise_of(line),
          .unit = line.text("unit"),
          .source = line.text("source"),
          .page_or_figure = line.text("page_or_figure"),
          .statement = line.text("statement"),
          .evidence = line.text("evidence")};
}

bool is_tolerance(double value) { return value > 0 && std::isfinite(value); }

/// A row whose verdict could not follow from what is measured, or does not say what it rests on, is refused.
void check_claim(const Claim& claim, const Line& line) {
  if (!is_tolerance(claim.tolerance)) line.refuse("tolerance", "must be above 0 and finite");
  if (claim.range && claim.kind != ReferenceKind::published) {
    line.refuse("claim", "is for published rows only");
  }
  if (claim.range && claim.reading == "-") line.refuse("reading", "must say how the words became the claim");
  if (claim.range && claim.basis == "-") line.refuse("basis", "must say where the expected value is from");
  if (claim.condition != "-" && !claim.range) line.refuse("condition", "is for rows with a claim only");
  if (!claim.otherwise) return;
  if (claim.condition == "-") line.refuse("otherwise_expected", "needs a condition");
  if (!std::isfinite(claim.otherwise->value)) line.refuse("otherwise_expected", "must be a number");
  if (!is_tolerance(claim.otherwise->tolerance)) {
    line.refuse("otherwise_tolerance", "must be above 0 and finite");
  }
}

void read_into(std::vector<Claim>& claims, const fs::path& file) {
  const dem::CsvDocument document = dem::read_csv(file);
  const dem::Table& table = document.table;
  for (const char* column :
       {"id", "feature", "reference_kind", "quantity", "value", "tolerance", "tolerance_scale", "basis",
        "claim", "reading", "condition", "otherwise_expected", "otherwise_tolerance", "unit", "source",
        "page_or_figure", "statement", "evidence"}) {
    if (std::ranges::find(table.columns(), column) == table.columns().end()) {
      throw InputError(fmt::format("{}: column {} is missing", file.string(), column));
    }
  }
  for (std::size_t row = 0; row < table.rows().size(); ++row) {
    const Line line{table, row, fmt::format("{}:{}", file.string(), document.lines[row])};
    Claim claim = read_claim(line, file.stem().string());
    if (std::ranges::find(claims, claim.id, &Claim::id) != claims.end()) {
      throw InputError(fmt::format("{}: column id: '{}' comes twice", line.where, claim.id));
    }
    check_claim(claim, line);
    claims.push_back(std::move(claim));
  }
}

}  // namespace

fs::path find_data_directory(const std::optional<fs::path>& asked) {
  const dem::DataSearch search = dem::find_data("published", asked);
  if (search.found) return *search.found;
  throw InputError("no directory 'published' with the published values in " + search.tried);
}

std::vector<Claim> read_all_published(const fs::path& data_directory) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(data_directory / "published")) {
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  }
  if (files.empty()) throw InputError(data_directory.string() + "/published holds no .csv file");
  std::ranges::sort(files);
  std::vector<Claim> claims;
  for (const fs::path& file : files) read_into(claims, file);
  return claims;
}

const Claim& find_claim(const std::vector<Claim>& claims, std::string_view id) {
  const auto found = std::ranges::find(claims, id, &Claim::id);
  if (found == claims.end()) throw InputError(fmt::format("no claim in data/published has the id '{}'", id));
  return *found;
}

std::string to_string(ReferenceKind kind) {
  return std::ranges::find(kKinds, kind, &std::pair<const char*, ReferenceKind>::second)->first;
}

}  // namespace fiberchain::compare
