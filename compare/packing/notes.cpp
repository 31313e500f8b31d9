#include <fmt/format.h>

#include <algorithm>

#include "compare/packing/study.hpp"

namespace fiberchain::compare {
namespace {

std::string stages_note(const PackingRun& run) {
  std::string text = fmt::format("Fig 11, {} fibers, {}:", run.asked.fibers, label_of(run.asked));
  for (const PackingStage stage : kPackingStages) {
    const auto found = find_stage(run.history, stage);
    if (!found) {
      text += fmt::format(" {} never;", name(stage));
      continue;
    }
    const PackingSample& s = run.history[*found];
    text += fmt::format(" {} at {:.3f} s (height {:.1f} mm, solid fraction {:.3f}, bending {:.4f} rad);",
                        name(stage), s.time, 1e3 * s.height, s.solid_fraction, s.bending_angle);
  }
  text.back() = '.';
  return text;
}

std::string energy_note(const PackingRun& run) {
  const dem::EnergyBalance& e = run.history.back().energy;
  const double taken = sum_of(e, dem::EnergyRole::dissipated);
  return fmt::format(
      "Of the energy taken, contacts took {:.1f} % along their normal and {:.1f} % along the surface, bonds "
      "{:.1f} %. The total "
      "stays within {:.2g} of what the fall gave.",
      100 * e.contact_normal / taken, 100 * e.contact_tangential / taken,
      100 * (e.bond_damping + e.bond_friction) / taken, energy_drift(run));
}

std::string spread_note(const std::vector<PackingRun>& runs) {
  std::string text = "Plateau of Fig 12 over the seeds, mean and standard deviation:";
  for (const SeedGroup& group : seed_groups(runs)) {
    if (std::ranges::none_of(group.runs, [](const PackingRun* r) { return r->status == "finished"; }))
      continue;
    const Spread s = bending_spread(group).plateau;
    text += fmt::format(" {:.5f} ± {:.5f} rad ({});", s.mean, s.deviation, label_of(group.asked));
  }
  text.back() = '.';
  return text;
}

}  // namespace

std::string packing_notes(const std::vector<PackingRun>& figure_runs,
                          const std::vector<PackingRun>& spread_runs) {
  std::string text;
  for (const PackingRun& run : figure_runs) {
    if (!run.history.empty() && (run.asked.accounted || run.asked.stiffness != 1))
      text += stages_note(run) + "\n\n";
    if (run.asked.accounted && run.status == "finished") text += energy_note(run) + "\n\n";
  }
  if (!spread_runs.empty()) text += spread_note(spread_runs) + "\n\n";
  return text;
}

}  // namespace fiberchain::compare
