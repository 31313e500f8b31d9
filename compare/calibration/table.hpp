#pragma once

#include <optional>
#include <string>

#include "compare/calibration/calibration.hpp"
#include "dem/record/table.hpp"

namespace fiberchain::compare {

/// An answer with what was asked: a target or, the other way round, nothing.
struct CalibrationAnswer {
  CalibrationCase asked;
  std::optional<double> target;  ///< xi_f
  Calibration found;
  std::optional<Verification> run = std::nullopt;
};

/// A row per answer.
dem::Table calibration_table(const std::vector<CalibrationAnswer>& answers);

/// What the expected error consists of, in words, as paragraphs of Markdown.
std::string calibration_notes(const CalibrationAnswer& answer);

}  // namespace fiberchain::compare
