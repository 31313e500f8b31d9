#pragma once

#include <string>
#include <vector>

#include "compare/calibration/material.hpp"
#include "dem/record/table.hpp"
#include "dem/scene/read_material.hpp"

namespace fiberchain::compare {

/// One row: what to set, in SI.
dem::Table material_answer_table(const MaterialAnswer& answer, const std::string& material);

/// A row a mode; nothing where nothing damps.
dem::Table material_modes_table(const MaterialAnswer& answer);

/// A row a branch.
dem::Table branches_table(const dem::MaxwellBranches& branches);

/// A row a line for LAMMPS and LIGGGHTS; the step in seconds.
dem::Table codes_table(const dem::Fiber& fiber, double time_step);
std::string codes_notes(const dem::Table& codes);

/// What the tables mean, in words, with them, as Markdown.
std::string material_answer_notes(const MaterialAnswer& answer, const std::optional<dem::MaterialData>& data);

/// A row a material.
dem::Table materials_table(const std::vector<dem::MaterialData>& materials);

}  // namespace fiberchain::compare
