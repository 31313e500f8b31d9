#pragma once

#include <nlohmann/json.hpp>

#include "dem/record/provenance.hpp"
#include "dem/record/table.hpp"

namespace fiberchain::dem {

/// {"provenance": {...}, "rows": [{column: value, ...}, ...]}; missing and non-finite numbers are null.
nlohmann::ordered_json to_json(const Table& table, const Provenance& provenance);

/// The JSON value as text, two spaces deep, with a final newline; bytes that are no UTF-8 are replaced.
std::string to_text(const nlohmann::ordered_json& value);

}  // namespace fiberchain::dem
