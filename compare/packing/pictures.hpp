#pragma once

#include <vector>

#include "compare/packing/case.hpp"
#include "dem/record/output.hpp"
#include "dem/record/provenance.hpp"

namespace fiberchain::compare {

/// Fig 11: fig-11-a.png to fig-11-d.png, the stages of a run whose places were kept, fibers colored by
/// vertical speed on one scale. A stage that did not come has no picture.
/// @throws FigureError as draw() does
std::vector<dem::OutputFile> stage_pictures(const PackingRun& run, int threads,
                                            const dem::Provenance& provenance);

}  // namespace fiberchain::compare
