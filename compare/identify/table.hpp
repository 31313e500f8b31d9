#pragma once

#include <string>

#include "compare/identify/identify.hpp"
#include "dem/record/table.hpp"

namespace fiberchain::compare {

/// A row a quantity, in SI: value and the ends of its interval.
dem::Table identification_table(const Identification& found);

/// A row a sample: time, displacement, the fit, what it leaves.
dem::Table identified_record_table(const RingDownRecord& record, const Identification& found);

/// Modes, noise, doubts and warnings, as paragraphs of Markdown.
std::string identification_notes(const Identification& found);

}  // namespace fiberchain::compare
