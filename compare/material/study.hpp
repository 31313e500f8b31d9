#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "compare/figures/figure.hpp"
#include "compare/material/damped_packing.hpp"
#include "compare/material/points.hpp"
#include "dem/record/table.hpp"

// The damping that materials have, as tables and figures.
namespace fiberchain::compare {

struct MaterialPlan {
  int aspect_ratio = 20;
  int modes = 5;
  int diameters = 49;  ///< from 1 um to 10 mm
  DampedPackingPlan packing{};
};

/// A part of the study.
struct MaterialPart {
  dem::Table table;
  std::vector<std::pair<std::string, dem::Table>> more_tables = {};  ///< by the name of their files
  std::vector<std::pair<std::string, Figure>> figures = {};
  int failed = 0;  ///< runs
};

/// zeta against mode and frequency of the three fibers.
MaterialPart mode_part(const MaterialPlan& plan, const Jobs& jobs);
/// Two modes ring down together, viscous against flat.
MaterialPart two_mode_part(const MaterialPlan& plan, const Jobs& jobs);
/// Energy lost in a cycle of bending, loops drawn.
MaterialPart cycle_part(const MaterialPlan& plan, const Jobs& jobs);
/// zeta_1 of metal wires against their diameter.
MaterialPart wire_part(const MaterialPlan& plan, const Jobs& jobs);
/// A packing of fibers damped in three ways.
MaterialPart packing_part(const MaterialPlan& plan, const Jobs& jobs);

/// Loss factors of the fibers at a frequency over the first, for figures: zeta = tan delta/2.
ThreeFibers study_fibers(int aspect_ratio);

// Figures.
Figure mode_figure(const ThreeFibers& fibers, const std::vector<ModePoint>& points);
Figure two_mode_figure(const std::vector<TwoModes>& runs);
Figure cycle_figure(const ThreeFibers& fibers, const std::vector<CyclePoint>& points);
Figure loop_figure(const dem::Fiber& flat, const dem::Fiber& viscous, double frequency);
Figure wire_figure(const std::vector<WirePoint>& points);
Figure damped_packing_figure(const std::vector<PackingRun>& runs);

}  // namespace fiberchain::compare
