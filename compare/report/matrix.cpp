#include "compare/report/matrix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string_view>

namespace fiberchain::compare {
namespace {

constexpr const char* kPaper = "Nan Wang & Tang 2015";

// Words that are a letter in claims: whole words only, with a subscript or without.
constexpr std::array<std::pair<std::string_view, std::string_view>, 16> kLetters = {{{"xi", "ξ"},
                                                                                     {"nu", "ν"},
                                                                                     {"mu", "μ"},
                                                                                     {"pi", "π"},
                                                                                     {"omega", "ω"},
                                                                                     {"beta", "β"},
                                                                                     {"zeta", "ζ"},
                                                                                     {"eta", "η"},
                                                                                     {"theta", "θ"},
                                                                                     {"rho", "ρ"},
                                                                                     {"gamma", "γ"},
                                                                                     {"Delta", "Δ"},
                                                                                     {"Lambda", "Λ"},
                                                                                     {"lambda", "λ"},
                                                                                     {"kappa", "κ"},
                                                                                     {"Phi", "Φ"}}};
constexpr std::array<std::string_view, 10> kPowers = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::string_view letter_of(std::string_view word) {
  const auto found = std::ranges::find(kLetters, word, &std::pair<std::string_view, std::string_view>::first);
  return found == kLetters.end() ? word : found->second;
}

/// The digits behind a "^", at `at`, as a power; `at` is behind them then.
std::string power_of(const std::string& text, std::size_t& at) {
  std::size_t digits = at + 1;
  std::string power;
  if (digits < text.size() && text[digits] == '-') power = "⁻", ++digits;
  const std::size_t first = digits;
  while (digits < text.size() && is_digit(text[digits]))
    power += kPowers[static_cast<std::size_t>(text[digits++] - '0')];
  if (digits == first || (digits < text.size() && text[digits] == '.')) return text.substr(at++, 1);
  at = digits;
  return power;
}

std::string number_text(double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : ""; }

/// A dash stands for nothing in tables.
std::string without_dash(const std::string& text) { return text == "-" ? "" : text; }

/// What is known of a row without a run.
MatrixEntry entry_of(const Claim& claim) {
  MatrixEntry entry;
  entry.id = claim.id;
  entry.subject = claim.subject;
  entry.feature = claim.feature;
  entry.kind = to_string(claim.kind);
  entry.quantity = claim.quantity;
  entry.claim = claim.range ? claim.range->text() : "";
  entry.expected = number_text(claim.value);
  entry.tolerance = claim.scale == ToleranceScale::unit ? number_text(claim.tolerance) : "";
  entry.unit = claim.unit == "1" ? "" : claim.unit;
  entry.verdict = "not measured";
  entry.condition = without_dash(claim.condition);
  entry.reading = without_dash(claim.reading);
  entry.basis = without_dash(claim.basis);
  entry.source = claim.source;
  entry.place = without_dash(claim.page_or_figure);
  entry.statement = without_dash(claim.statement);
  entry.of_paper = claim.source == kPaper;
  entry.figure = entry.of_paper ? figure_named(claim.page_or_figure) : 0;
  return entry;
}

/// The same of a measured row that is no claim's (of an earlier version of the data).
MatrixEntry entry_of(const dem::Table& table, std::size_t row) {
  MatrixEntry entry;
  const auto text = [&](const char* column) { return without_dash(table.text(row, column)); };
  entry.id = text("id");
  entry.feature = text("feature");
  entry.kind = text("reference_kind");
  entry.quantity = text("quantity");
  entry.claim = text("claim");
  entry.unit = table.text(row, "unit") == "1" ? "" : text("unit");
  entry.condition = text("condition");
  entry.reading = text("reading");
  entry.basis = text("basis");
  entry.source = text("source");
  return entry;
}

void add_measured(MatrixEntry& entry, const dem::Table& table, std::size_t row) {
  entry.expected = number_text(table.number(row, "expected"));
  entry.measured = number_text(table.number(row, "measured"));
  entry.tolerance = number_text(table.number(row, "tolerance"));
  entry.otherwise = number_text(table.number(row, "otherwise"));
  entry.verdict = table.text(row, "verdict");
  entry.as_expected = table.text(row, "as_expected") != "no";
  entry.evidence = without_dash(table.text(row, "evidence"));
}

/// All that is written here so; the source's words stay as they are.
MatrixEntry in_unicode(MatrixEntry entry) {
  for (std::string MatrixEntry::*text :
       {&MatrixEntry::quantity, &MatrixEntry::claim, &MatrixEntry::unit, &MatrixEntry::condition,
        &MatrixEntry::reading, &MatrixEntry::basis, &MatrixEntry::evidence})
    entry.*text = compare::in_unicode(entry.*text);
  return entry;
}

struct RowOf {
  const dem::Table* table;
  std::size_t row;
};

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

}  // namespace

std::string in_unicode(const std::string& text) {
  std::string found;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '^') {
      found += power_of(text, at);
    } else if (is_letter(text[at])) {
      std::size_t end = at;
      while (end < text.size() && is_letter(text[end])) ++end;
      found += letter_of(std::string_view(text).substr(at, end - at));
      at = end;
    } else {
      found += text[at++];
    }
  }
  replace_all(found, ">=", "≥");
  replace_all(found, "<=", "≤");
  return found;
}

int figure_named(const std::string& place) {
  const std::size_t found = place.find("Fig ");
  return found == std::string::npos ? 0 : std::atoi(place.c_str() + found + 4);
}

std::vector<MatrixEntry> matrix_entries(const std::vector<Claim>& claims,
                                        const std::vector<dem::Table>& tables) {
  std::vector<std::string> order;
  std::map<std::string, RowOf> rows;
  for (const dem::Table& table : tables)
    for (std::size_t row = 0; row < table.rows().size(); ++row)
      if (rows.emplace(table.text(row, "id"), RowOf{&table, row}).second)
        order.push_back(table.text(row, "id"));
  std::vector<MatrixEntry> entries;
  for (const Claim& claim : claims) {
    MatrixEntry entry = entry_of(claim);
    if (const auto found = rows.find(claim.id); found != rows.end())
      add_measured(entry, *found->second.table, found->second.row);
    entries.push_back(in_unicode(std::move(entry)));
  }
  for (const std::string& id : order) {
    if (std::ranges::find(claims, id, &Claim::id) != claims.end()) continue;
    MatrixEntry entry = entry_of(*rows.at(id).table, rows.at(id).row);
    add_measured(entry, *rows.at(id).table, rows.at(id).row);
    entries.push_back(in_unicode(std::move(entry)));
  }
  return entries;
}

MatrixCounts counts_of(const std::vector<MatrixEntry>& entries) {
  const auto count = [&](const char* verdict) {
    return static_cast<int>(std::ranges::count(entries, verdict, &MatrixEntry::verdict));
  };
  return {.all = static_cast<int>(entries.size()),
          .holds = count("holds"),
          .holds_only_if = count("holds only if"),
          .disputed = count("disputed"),
          .failed = static_cast<int>(std::ranges::count(entries, false, &MatrixEntry::as_expected)),
          .not_measured = count("not measured")};
}

}  // namespace fiberchain::compare
