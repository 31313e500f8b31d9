#include "compare/bench/feature_costs.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <optional>

#include "compare/measure/linear_chain_of.hpp"
#include "compare/measure/ring_down_release.hpp"
#include "compare/static/case.hpp"
#include "compare/study/tabulate.hpp"
#include "dem/equilibrium/dynamic_relaxation.hpp"
#include "dem/equilibrium/newton.hpp"

namespace fiberchain::compare {
namespace {

using dem::BondForm;
using dem::InstructionSet;
using dem::Physics;

/// A feature that a physics may have, and the same physics without it.
struct Feature {
  const char* skipped;
  void (*remove)(Physics&);
};

constexpr Feature features[] = {
    {"planar instead of spatial", [](Physics& p) { p.dimension = 2; }},
    {"no bond damping", [](Physics& p) { p.damped = false; }},
    {"bonds lagged instead of solved in the step", [](Physics& p) { p.solved = dem::Solved::nothing; }},
    {"no rolling friction", [](Physics& p) { p.rolling = dem::Rolling::none; }},
    {"no fluid", [](Physics& p) { p.fluid = false; }},
    {"no Maxwell branches (5 in bending)", [](Physics& p) { p.branches = false; }},
    {"no drag", [](Physics& p) { p.settling_damping = false; }},
    {"straight at rest instead of curved", [](Physics& p) { p.curved = false; }},
    {"increments instead of total strain", [](Physics& p) { p.form = BondForm::incremental; }},
};

const KernelTime* find(const std::vector<KernelTime>& times, const Physics& physics, InstructionSet set) {
  const auto found =
      std::ranges::find_if(times, [&](const KernelTime& t) { return t.physics == physics && t.set == set; });
  return found == times.end() ? nullptr : &*found;
}

/// Two ways to one answer.
struct Ways {
  std::string skipped, scene;
  std::function<void()> with, without;
};

std::vector<Ways> equilibrium_ways() {
  const auto fiber = nominal_fiber(10, 0.3, dem::BondModel::paper);
  std::vector<Ways> ways;
  for (const BondForm form : {BondForm::total, BondForm::incremental}) {
    dem::Load<2> end{10, {0, dem::load_force(fiber, 1)}, {}};
    const dem::RelaxCase<2> job{dem::straight_chain<2>(fiber), {{{0}, {end}}}};
    dem::RelaxOptions march;
    march.form = form;
    march.residual = 1e-6;
    ways.push_back({"equilibrium instead of marching",
                    fmt::format("planar {}, r_f = 10, PL^2/EI = 1", dem::name(form)),
                    [=] { dem::relax_to_equilibrium<2>({job}, march); },
                    [=] { dem::solve_equilibrium(job.chain, job.loading[0]); }});
  }
  return ways;
}

Ways eigenvalue_ways() {
  dem::Fiber fiber = nominal_fiber(10, 0.3, dem::BondModel::paper);
  fiber.bond_damping = 1;
  const dem::Release<2> release =
      mode_release(fiber, reference::first_bending_mode(linear_chain_of(fiber)), 1e-3, 2.2);
  return {"eigenvalue instead of marching", "planar incremental damped, r_f = 10, two periods",
          [=] { dem::ring_down<2>({release}); },
          [=] { reference::first_bending_mode(linear_chain_of(fiber)); }};
}

}  // namespace

std::vector<FeatureCostRow> kernel_feature_costs(const std::vector<KernelTime>& times) {
  const InstructionSet best = dem::best_instruction_set();
  std::vector<FeatureCostRow> rows;
  for (const Feature& feature : features) {
    for (const Physics& physics : dem::built_physics) {
      Physics left = physics;
      feature.remove(left);
      const KernelTime *with = find(times, physics, best), *without = find(times, left, best);
      if (left == physics || !with || !without) continue;
      rows.push_back({feature.skipped, text(left), with->ensemble, without->ensemble});
    }
  }
  for (const KernelTime& scalar : times) {
    const KernelTime* wide = find(times, scalar.physics, best);
    if (scalar.set != InstructionSet::scalar || !wide) continue;
    rows.push_back({fmt::format("{} chains at a time instead of one", wide->lanes), text(scalar.physics),
                    scalar.ensemble, wide->ensemble});
  }
  return rows;
}

std::vector<FeatureCostRow> answer_costs(const BenchOptions& options) {
  std::vector<Ways> ways = equilibrium_ways();
  ways.push_back(eigenvalue_ways());
  std::vector<std::function<void()>> runs;
  for (const Ways& way : ways) {
    runs.push_back(way.with);
    runs.push_back(way.without);
  }
  const auto timings =
      time_in_turns(runs, options.quick ? TimingBudget{0.02, 3, 9} : TimingBudget{0.3, 7, 40});
  std::vector<FeatureCostRow> rows;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    rows.push_back({ways[i].skipped, ways[i].scene, timings[2 * i].least, timings[2 * i + 1].least});
  }
  return rows;
}

dem::Table feature_cost_table(const std::vector<FeatureCostRow>& rows) {
  return tabulate(rows, [&](const FeatureCostRow& row) -> dem::NamedRow {
    return {{"skipped", row.skipped},
            {"scene", row.scene},
            {"time_with", row.with},
            {"time_without", row.without},
            {"saving", row.saving()}};
  });
}

dem::Table feature_cost_summary(const std::vector<FeatureCostRow>& rows) {
  dem::Table table({"skipped", "scenes", "saving_least", "saving", "saving_largest"});
  std::vector<std::string> names;
  for (const FeatureCostRow& row : rows) {
    if (std::ranges::find(names, row.skipped) == names.end()) names.push_back(row.skipped);
  }
  for (const std::string& name : names) {
    std::vector<double> savings;
    for (const FeatureCostRow& row : rows)
      if (row.skipped == name) savings.push_back(row.saving());
    std::ranges::sort(savings);
    const std::size_t n = savings.size();
    table.append({{"skipped", name},
                  {"scenes", static_cast<std::int64_t>(n)},
                  {"saving_least", savings.front()},
                  {"saving", (savings[(n - 1) / 2] + savings[n / 2]) / 2},
                  {"saving_largest", savings.back()}});
  }
  return table;
}

}  // namespace fiberchain::compare
