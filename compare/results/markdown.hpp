#pragma once

#include <string>

#include "compare/results/provenance.hpp"
#include "compare/results/table.hpp"

namespace fiberchain::compare {

/// The table as Markdown for people: six significant digits, numbers to the right, "–" where missing.
std::string to_markdown(const Table& table);

/// A document: heading, table, provenance as its footer.
std::string to_markdown(const std::string& heading, const Table& table, const Provenance& provenance);

}  // namespace fiberchain::compare
