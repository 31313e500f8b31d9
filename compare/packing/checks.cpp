#include "compare/packing/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/packing/study.hpp"

namespace fiberchain::compare {
namespace {

const std::string kFeature = "packing";

/// The groups that the statements are about; null where the runs have none.
struct Groups {
  std::vector<SeedGroup> all;
  const SeedGroup *least = nullptr, *most = nullptr, *friction = nullptr, *stiff = nullptr,
                  *half_step = nullptr;
};

bool finished(const SeedGroup& group) {
  return std::ranges::all_of(group.runs, [](const PackingRun* r) { return r->status == "finished"; });
}

void assign(Groups& groups, const SeedGroup& group) {
  const PackingCase& c = group.asked;
  const double damping = c.bond_damping;
  if (c.stiffness != 1) {
    groups.stiff = &group;
  } else if (c.step_ratio != 1) {
    groups.half_step = &group;
  } else if (c.rolling_friction > 0) {
    if (!groups.friction || c.rolling_friction < groups.friction->asked.rolling_friction)
      groups.friction = &group;
  } else {
    if (!groups.least || damping < groups.least->asked.bond_damping) groups.least = &group;
    if (!groups.most || damping > groups.most->asked.bond_damping) groups.most = &group;
  }
}

Groups groups_of(const std::vector<PackingRun>& runs) {
  Groups groups{.all = seed_groups(runs)};
  for (const SeedGroup& group : groups.all) {
    if (finished(group)) assign(groups, group);
  }
  return groups;
}

bool peaks_first(const PackingRun* run) {
  const BendingParts p = bending_parts(run->history);
  return p.peak_time > 0 && p.peak_time < p.trough_time && p.unrest < 0.2;
}

/// Rises, falls, rises less than it fell, and stays: in that order in every run, by so much in their mean.
bool goes_as_fig_12(const SeedGroup& group) {
  const BendingSpread s = bending_spread(group);
  const double fall = s.peak.mean - s.trough.mean, second_rise = s.plateau.mean - s.trough.mean;
  return std::ranges::all_of(group.runs, peaks_first) && fall > 0.3 * s.peak.mean &&
         second_rise > 0.02 * s.plateau.mean && second_rise < 0.5 * fall;
}

std::string parts_text(const BendingSpread& s) {
  return fmt::format("peak {:.4f} +- {:.4f}, trough {:.4f} +- {:.4f}, plateau {:.5f} +- {:.5f} rad",
                     s.peak.mean, s.peak.deviation, s.trough.mean, s.trough.deviation, s.plateau.mean,
                     s.plateau.deviation);
}

std::string setting_text(const SeedGroup& group) {
  return fmt::format("{} fibers on {:g} x {:g} m, {} seeds", group.asked.fibers, group.asked.side,
                     group.asked.side, group.runs.size());
}

MatrixRow course_row(const ValidationInput& in, const Groups& g) {
  return published_row(
      in, "paper-fig12-course", goes_as_fig_12(*g.least) ? 1 : 0, 0,
      fmt::format("{}, xi_b = {:g}: {} (mean and standard deviation of the seeds)", setting_text(*g.least),
                  g.least->asked.bond_damping, parts_text(bending_spread(*g.least))));
}

/// Holds if the part of Fig 12 falls by more than the seeds' 95 % interval; else disputed, for the reason
/// given.
MatrixRow damping_row(const ValidationInput& in, const Groups& g, const char* id, double BendingParts::*part,
                      const char* reason) {
  const Spread change = paired_difference(*g.most, *g.least, part);
  const std::string measured = fmt::format(
      "{}, xi_b from {:g} to {:g}, seed by seed: changes by {:+.5f} +- {:.5f} rad (95 % interval), from "
      "{:+.5f} to "
      "{:+.5f}",
      setting_text(*g.least), g.least->asked.bond_damping, g.most->asked.bond_damping, change.mean,
      half_width(change), change.least, change.most);
  if (change.mean + half_width(change) < 0) return published_row(in, id, 1, 0, measured);
  return disputed_row(in, id, 0, measured + ". " + reason);
}

std::vector<MatrixRow> damping_rows_of(const ValidationInput& in, const Groups& g) {
  return {damping_row(in, g, "paper-fig12-damping-peak", &BendingParts::peak,
                      "Less than the seeds differ: a fiber's own damping is only of the order of 0.01 xi_b"),
          damping_row(in, g, "paper-fig12-damping", &BendingParts::plateau,
                      "Less than the seeds differ. At rest a dashpot carries nothing: the angle there is "
                      "that of the weight on "
                      "the springs, in whatever arrangement the fibers came to")};
}

MatrixRow friction_row(const ValidationInput& in, const Groups& g) {
  const BendingSpread base = bending_spread(*g.least), bonds = bending_spread(*g.most),
                      friction = bending_spread(*g.friction);
  return published_row(
      in, "paper-fig12-friction", friction.plateau.mean / bonds.plateau.mean, 0.2,
      fmt::format("plateau at xi_b = {:g}, xi_r = {:g} over that at xi_b = {:g}, xi_r = 0; peaks {:.4f} and "
                  "{:.4f} rad, {:.4f} "
                  "without either ({}). Both change little, so that each acts about as the other",
                  g.friction->asked.bond_damping, g.friction->asked.rolling_friction,
                  g.most->asked.bond_damping, friction.peak.mean, bonds.peak.mean, base.peak.mean,
                  setting_text(*g.friction)));
}

/// Mean height of the spheres when expanded over that when densest, less 1; 0 if the bed does not expand.
double expansion(const PackingRun& run) {
  const auto densest = find_stage(run.history, PackingStage::densest),
             expanded = find_stage(run.history, PackingStage::expanded);
  if (!densest || !expanded) return 0;
  return run.history[*expanded].mean_height / run.history[*densest].mean_height - 1;
}

Spread spread_over(const SeedGroup& group, double (*of)(const PackingRun&)) {
  std::vector<double> values;
  for (const PackingRun* run : group.runs) values.push_back(of(*run));
  return spread_of(values);
}

double fraction_at_rest(const PackingRun& run) { return run.history.back().solid_fraction; }

/// Holds if the flexible fibers of every seed spring back by more than half as much again as the stiff ones of any.
MatrixRow rods_row(const ValidationInput& in, const Groups& g) {
  const Spread flexible = spread_over(*g.least, expansion), rigid = spread_over(*g.stiff, expansion);
  return published_row(
      in, "paper-fig11-rods", flexible.least > 1.5 * rigid.most ? 1 : 0, 0,
      fmt::format(
          "{}: after its densest the mean height of the spheres rises by {:.1f} to {:.1f} %, by {:.1f} to {:.1f} % where E is {:g} "
          "times as large (bending there {:.5f} rad at rest); solid fraction at rest {:.3f} and {:.3f}",
          setting_text(*g.least), 100 * flexible.least, 100 * flexible.most, 100 * rigid.least, 100 * rigid.most,
          g.stiff->asked.stiffness, bending_spread(*g.stiff).plateau.mean, spread_over(*g.least, fraction_at_rest).mean,
          spread_over(*g.stiff, fraction_at_rest).mean));
}

MatrixRow step_row(const Groups& g) {
  const Spread seeds = bending_spread(*g.least).plateau, halved = bending_spread(*g.half_step).plateau;
  return method_row(
      "packing-half-step", kFeature, 0, (halved.mean - seeds.mean) / seeds.mean,
      2 * seeds.deviation / seeds.mean, "the same packings at half the step",
      fmt::format(
          "relative change of Fig 12's plateau, mean of {} seeds; the tolerance is twice the standard "
          "deviation of one run over the seeds. A packing is chaotic: every step length gives another "
          "one of the same statistics",
          g.least->runs.size()));
}

MatrixRow energy_row(const PackingRun& booked) {
  return exact_row(
      "packing-energy", kFeature, 0, energy_drift(booked), 1e-3, "energy is kept",
      fmt::format(
          "largest departure of stored and taken energy from that at the start, over what the fall gives, {} "
          "fibers",
          booked.asked.fibers));
}

std::vector<MatrixRow> joined(std::vector<MatrixRow> first, const std::vector<MatrixRow>& rest) {
  first.insert(first.end(), rest.begin(), rest.end());
  return first;
}

}  // namespace

std::vector<MatrixRow> packing_statements(const ValidationInput& in, const std::vector<PackingRun>& runs) {
  const Groups g = groups_of(runs);
  std::vector<MatrixRow> rows;
  if (g.least) rows.push_back(course_row(in, g));
  if (g.least && g.least != g.most) rows = joined(std::move(rows), damping_rows_of(in, g));
  if (g.friction && g.least && g.least != g.most) rows.push_back(friction_row(in, g));
  if (g.stiff && g.least) rows.push_back(rods_row(in, g));
  if (g.half_step && g.least && g.least->runs.size() > 1) rows.push_back(step_row(g));
  for (const PackingRun& run : runs) {
    if (!run.asked.booked || run.status != "finished") continue;
    rows.push_back(energy_row(run));
    break;
  }
  return rows;
}

std::vector<PackingCase> row_cases() {
  const PackingCase plain{
      .bond_damping = 0.1, .fibers = 100, .side = 0.05, .duration = 0.3, .periodic = true};
  std::vector<PackingCase> cases;
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    PackingCase c = plain;
    c.seed = seed;
    cases.push_back(c);
    const auto add = [&](double PackingCase::*what, double value) {
      cases.push_back(c);
      cases.back().*what = value;
    };
    add(&PackingCase::bond_damping, 5);
    add(&PackingCase::rolling_friction, 1);
    add(&PackingCase::stiffness, 20);
    add(&PackingCase::step_ratio, 0.5);
  }
  cases.front().booked = true;
  return cases;
}

std::vector<MatrixRow> packing_rows(const ValidationInput& input) {
  return packing_statements(input, run_packings(row_cases(), {.samples = 60}, input.jobs));
}

}  // namespace fiberchain::compare
