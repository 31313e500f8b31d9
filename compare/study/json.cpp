#include "compare/study/json.hpp"

namespace fiberchain::dem {
namespace {

using nlohmann::ordered_json;

ordered_json value_of(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* integer = std::get_if<std::int64_t>(&cell)) return *integer;
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  return nullptr;
}

}  // namespace

ordered_json to_json(const Table& table, const Provenance& provenance) {
  ordered_json document = {{"provenance", ordered_json::object()}, {"rows", ordered_json::array()}};
  for (const auto& [key, value] : entries(provenance)) document["provenance"][key] = value;
  for (const auto& row : table.rows()) {
    ordered_json object = ordered_json::object();
    for (std::size_t i = 0; i < row.size(); ++i) object[table.columns()[i]] = value_of(row[i]);
    document["rows"].push_back(std::move(object));
  }
  return document;
}

std::string to_text(const ordered_json& value) {
  return value.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace fiberchain::dem
