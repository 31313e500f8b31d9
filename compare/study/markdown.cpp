#include "compare/study/markdown.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "dem/record/columns.hpp"

namespace fiberchain::dem {
namespace {

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '|') safe += '\\';
    safe += c == '\n' ? ' ' : c;
  }
  return safe;
}

std::string readable(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return escaped(*text);
  if (const auto* integer = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *integer);
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{:.6g}", *number);
  return "–";
}

using Grid = std::vector<std::vector<std::string>>;

Grid readable(const Table& table) {
  Grid grid = {table.columns()};
  for (const auto& row : table.rows()) {
    auto& cells = grid.emplace_back();
    for (const Cell& cell : row) cells.push_back(readable(cell));
  }
  return grid;
}

std::size_t width_of(const std::string& text) {
  const auto is_start = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  return static_cast<std::size_t>(std::ranges::count_if(text, is_start));
}

std::vector<std::size_t> widths_of(const Grid& grid) {
  std::vector<std::size_t> widths(grid.front().size(), 3);
  for (const auto& cells : grid) {
    for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], width_of(cells[i]));
  }
  return widths;
}

}  // namespace

std::string to_markdown(const Table& table) {
  Grid grid = readable(table);
  const auto widths = widths_of(grid);
  std::vector<std::string> rule;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const bool is_text = find_column(table.columns()[i]).kind == CellKind::text;
    rule.push_back(std::string(widths[i] - 1, '-') + (is_text ? '-' : ':'));
    for (auto& cells : grid) {
      const std::string space(widths[i] - width_of(cells[i]), ' ');
      cells[i] = is_text ? cells[i] + space : space + cells[i];
    }
  }
  grid.insert(grid.begin() + 1, rule);
  std::string text;
  for (const auto& cells : grid) text += fmt::format("| {} |\n", fmt::join(cells, " | "));
  return text;
}

std::string to_markdown(const std::string& heading, const Table& table, const Provenance& provenance) {
  std::string text = fmt::format("# {}\n\n{}\n", heading, to_markdown(table));
  for (const auto& [key, value] : entries(provenance)) text += fmt::format("- {}: `{}`\n", key, value);
  return text;
}

}  // namespace fiberchain::dem
