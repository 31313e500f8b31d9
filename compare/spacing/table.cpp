#include "compare/spacing/study.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {
namespace {

dem::NamedRow spacing_row(const SpacingPoint& p) {
  const SpacingCase& c = p.asked;
  return {{"bond", std::string(dem::name(c.bond))},
          {"aspect_ratio", std::int64_t{c.aspect_ratio}},
          {"poisson_ratio", c.poisson_ratio},
          {"load", c.load},
          {"spacing", c.spacing},
          {"bonds", std::int64_t{p.bonds}},
          {"departure_distance", p.distance},
          {"departure_distance_unstretched", p.distance_unstretched},
          {"frequency_error", p.frequency_error},
          {"damping_over_bond_damping", p.damping_ratio},
          {"damping_law_error", p.damping_law_error},
          {"stable_step_gain", p.stable_step},
          {"status", p.status}};
}

dem::NamedRow fewest_row(const FewestBonds& f) {
  const bool statics = f.goal == SpacingGoal::statics, found = f.bonds > 0;
  const auto known = [&](double value) { return found ? dem::Cell(value) : dem::Cell(dem::Missing{}); };
  return {{"aspect_ratio", std::int64_t{f.aspect_ratio}},
          {"spacing_goal", std::string(statics ? "free end" : "first frequency")},
          {"load", statics ? dem::Cell(f.load) : dem::Cell(dem::Missing{})},
          {"touching_error", f.touching},
          {"wanted_error", f.wanted},
          {"bonds", found ? dem::Cell(std::int64_t{f.bonds}) : dem::Cell(dem::Missing{})},
          {"spaced_error", known(f.error)},
          {"times_fewer", known(f.times_fewer)},
          {"stable_step_gain", known(f.longest_step)}};
}

}  // namespace

dem::Table spacing_table(const std::vector<SpacingPoint>& points) {
  return tabulate(points, [](const SpacingPoint& point) { return spacing_row(point); });
}

dem::Table fewest_bonds_table(const SpacingSweep& sweep, const Jobs& jobs) {
  struct Asked {
    int aspect_ratio;
    SpacingGoal goal;
    double load, wanted;
  };
  std::vector<Asked> asked;
  for (const int aspect_ratio : sweep.aspect_ratio) {
    for (const double wanted : {0.0, 1e-3, 1e-4}) {
      for (const double load : sweep.load)
        asked.push_back({aspect_ratio, SpacingGoal::statics, load, wanted});
      asked.push_back({aspect_ratio, SpacingGoal::first_mode, 0, wanted});
    }
  }
  std::vector<FewestBonds> found(asked.size());
  jobs.run(asked.size(), [&](std::size_t i) {
    const Asked& a = asked[i];
    found[i] = fewest_bonds(a.aspect_ratio, sweep.poisson_ratio.front(), a.goal, a.load, a.wanted);
  });
  return tabulate(found, [](const FewestBonds& one) { return fewest_row(one); });
}

}  // namespace fiberchain::compare
