#include "compare/packing/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "compare/packing/study.hpp"
#include "compare/study/errors.hpp"

namespace fiberchain::compare {
namespace {

/// Groups that the statements are about, null where the runs have none, and a finished run with its energies.
struct Groups {
  std::vector<SeedGroup> all;
  const SeedGroup *least = nullptr, *most = nullptr, *friction = nullptr, *stiff = nullptr,
                  *half_step = nullptr;
  const PackingRun* accounted = nullptr;
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
  const auto accounted = std::ranges::find_if(
      runs, [](const PackingRun& r) { return r.asked.accounted && r.status == "finished"; });
  if (accounted != runs.end()) groups.accounted = &*accounted;
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

std::string setting_text(const SeedGroup& group) {
  return fmt::format("{} fibers on {:g} x {:g} m, {} seeds", group.asked.fibers, group.asked.side,
                     group.asked.side, group.runs.size());
}

/// Nothing where the runs do not tell.
using Answer = std::optional<Measured>;

Answer course(const Groups& g) {
  if (!g.least) return {};
  const BendingSpread s = bending_spread(*g.least);
  return Measured{goes_as_fig_12(*g.least) ? 1.0 : 0.0,
                  {setting_text(*g.least), g.least->asked.bond_damping, s.peak.mean, s.peak.deviation,
                   s.trough.mean, s.trough.deviation, s.plateau.mean, s.plateau.deviation}};
}

bool has_two_dampings(const Groups& g) { return g.least && g.least != g.most; }

/// 1 if the part of Fig 12 falls by more than the seeds' 95 % interval from the least to the largest xi_b.
template <double BendingParts::*part>
Answer fall_by_damping(const Groups& g) {
  if (!has_two_dampings(g)) return {};
  const Spread change = paired_difference(*g.most, *g.least, part);
  return Measured{change.mean + half_width(change) < 0 ? 1.0 : 0.0,
                  {setting_text(*g.least), g.least->asked.bond_damping, g.most->asked.bond_damping,
                   change.mean, half_width(change), change.least, change.most}};
}

Answer friction_over_damping(const Groups& g) {
  if (!g.friction || !has_two_dampings(g)) return {};
  const BendingSpread base = bending_spread(*g.least), bonds = bending_spread(*g.most),
                      friction = bending_spread(*g.friction);
  return Measured{
      friction.plateau.mean / bonds.plateau.mean,
      {g.friction->asked.bond_damping, g.friction->asked.rolling_friction, g.most->asked.bond_damping,
       friction.peak.mean, bonds.peak.mean, base.peak.mean, setting_text(*g.friction)}};
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

/// 1 if the flexible fibers of every seed spring back by more than half as much again as the stiff ones of
/// any.
Answer rods(const Groups& g) {
  if (!g.stiff || !g.least) return {};
  const Spread flexible = spread_over(*g.least, expansion), rigid = spread_over(*g.stiff, expansion);
  return Measured{
      flexible.least > 1.5 * rigid.most ? 1.0 : 0.0,
      {setting_text(*g.least), 100 * flexible.least, 100 * flexible.most, 100 * rigid.least, 100 * rigid.most,
       g.stiff->asked.stiffness, bending_spread(*g.stiff).plateau.mean,
       spread_over(*g.least, fraction_at_rest).mean, spread_over(*g.stiff, fraction_at_rest).mean}};
}

Answer half_step(const Groups& g) {
  if (!g.half_step || !g.least || g.least->runs.size() < 2) return {};
  const Spread seeds = bending_spread(*g.least).plateau, halved = bending_spread(*g.half_step).plateau;
  return Measured{.value = (halved.mean - seeds.mean) / seeds.mean,
                  .evidence = {static_cast<int>(g.least->runs.size())},
                  .spread = seeds.deviation / seeds.mean};
}

Answer energy(const Groups& g) {
  if (!g.accounted) return {};
  return Measured{energy_drift(*g.accounted), {g.accounted->asked.fibers}};
}

struct Statement {
  const char* id;
  Answer (*measure)(const Groups&);
};
constexpr Statement kStatements[] = {{"paper-fig12-course", course},
                                     {"paper-fig12-damping-peak", fall_by_damping<&BendingParts::peak>},
                                     {"paper-fig12-damping", fall_by_damping<&BendingParts::plateau>},
                                     {"paper-fig12-friction", friction_over_damping},
                                     {"paper-fig11-rods", rods},
                                     {"packing-half-step", half_step},
                                     {"packing-energy", energy}};

/// All statements by the small packings.
/// @throws InputError naming a statement whose packings did not finish
std::vector<Measured> small_packings(const ValidationInput& in) {
  const std::vector<PackingRun> runs = run_packings(row_cases(), {.samples = 60}, in.jobs);
  const Groups groups = groups_of(runs);
  std::vector<Measured> found;
  for (const Statement& statement : kStatements) {
    Answer answer = statement.measure(groups);
    if (!answer) throw InputError(fmt::format("the packings for '{}' did not finish", statement.id));
    found.push_back(std::move(*answer));
  }
  return found;
}

}  // namespace

std::vector<ValidationRow> packing_statements(const ValidationInput& in,
                                              const std::vector<PackingRun>& runs) {
  const Groups groups = groups_of(runs);
  std::vector<ValidationRow> rows;
  for (const Statement& statement : kStatements) {
    if (const Answer answer = statement.measure(groups)) {
      rows.push_back(row_of(find_claim(in.claims, statement.id), *answer));
    }
  }
  return rows;
}

const Checks& packing_checks() {
  static const Checks checks = [] {
    Check all{{}, small_packings};
    for (const Statement& statement : kStatements) all.ids.emplace_back(statement.id);
    return Checks{all};
  }();
  return checks;
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
  cases.front().accounted = true;
  return cases;
}

}  // namespace fiberchain::compare
