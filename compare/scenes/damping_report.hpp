#pragma once

#include <string>
#include <vector>

#include "dem/record/table.hpp"
#include "dem/scene/scene.hpp"

// What is said of the branches that a scene's material damping has become.
namespace fiberchain::compare {

/// Memory of a bond's branches [bytes].
double branch_bytes(const dem::Fiber& fiber, dem::BondForm form, dem::Dimension dimension);

/// "stretch 4, shear 4, twist 4, bend 7"
std::string branches_in_words(const dem::Fiber& fiber);

/// Columns branches, loss_ripple, relaxed_modulus and branch_memory; none of a fiber without branches.
dem::NamedRow damping_cells(const dem::Fiber& fiber, const dem::DampingSummary& damping, dem::BondForm form,
                            dem::Dimension dimension);

/// A line a fiber with branches, for the log.
std::vector<std::string> damping_lines(const dem::Scene& scene);

}  // namespace fiberchain::compare
