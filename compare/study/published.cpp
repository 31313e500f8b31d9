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

template <class Value, std::size_t n>
using Words = std::pair<const char*, Value>[n];

constexpr Words<ReferenceKind, 4> kKinds = {{"exact", ReferenceKind::exact},
                                            {"published", ReferenceKind::published},
                                            {"independent method", ReferenceKind::independent_method},
                                            {"regression", ReferenceKind::regression}};
constexpr Words<ToleranceScale, 3> kScales = {
    {"unit", ToleranceScale::unit}, {"value", ToleranceScale::value}, {"spread", ToleranceScale::spread}};
constexpr Words<VerdictRule, 3> kRules = {{"must hold", VerdictRule::must_hold},
                                          {"disputed", VerdictRule::disputed},
                                          {"either", VerdictRule::either}};

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
};

Claim read_claim(const Line& line, const std::string& subject) {
  return {.id = line.text("id"),
          .subject = subject,
          .feature = line.text("feature"),
          .kind = line.choice("reference_kind", kKinds),
          .quantity = line.text("quantity"),
          .value = line.table.number(line.row, "value"),
          .tolerance = line.table.number(line.row, "tolerance"),
          .scale = line.choice("tolerance_scale", kScales),
          .rule = line.choice("rule", kRules),
          .unit = line.text("unit"),
          .source = line.text("source"),
          .page_or_figure = line.text("page_or_figure"),
          .statement = line.text("statement"),
          .evidence = line.text("evidence"),
          .dispute = line.text("dispute")};
}

void check_claim(const Claim& claim, const std::string& where) {
  if (claim.rule != VerdictRule::must_hold && claim.kind != ReferenceKind::published) {
    throw InputError(fmt::format("{}: column rule: only a published claim can be disputed", where));
  }
  if (claim.rule != VerdictRule::disputed && !(claim.tolerance >= 0)) {
    throw InputError(fmt::format("{}: column tolerance must be at least 0", where));
  }
}

void read_into(std::vector<Claim>& claims, const fs::path& file) {
  const dem::CsvDocument document = dem::read_csv(file);
  const dem::Table& table = document.table;
  for (const char* column :
       {"id", "feature", "reference_kind", "quantity", "value", "tolerance", "tolerance_scale", "rule",
        "unit", "source", "page_or_figure", "statement", "evidence", "dispute"}) {
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
    check_claim(claim, line.where);
    claims.push_back(std::move(claim));
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

std::vector<Claim> read_published(const fs::path& file) {
  std::vector<Claim> claims;
  read_into(claims, file);
  return claims;
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
