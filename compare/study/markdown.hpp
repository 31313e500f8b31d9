#pragma once

#include <string>

#include "dem/record/provenance.hpp"
#include "dem/record/table.hpp"

namespace fiberchain::dem {

/// The table as Markdown for people: six significant digits, numbers to the right, "–" where missing.
std::string to_markdown(const Table& table);

/// A document: heading, table, provenance as its footer.
std::string to_markdown(const std::string& heading, const Table& table, const Provenance& provenance);

}  // namespace fiberchain::dem
