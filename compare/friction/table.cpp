#include "compare/friction/table.hpp"

#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {
namespace {

/// Missing where the fiber is let go with an amplitude.
dem::Cell load_of(const RollingCase& c) { return c.amplitude ? dem::Cell{} : dem::Cell{c.load}; }

dem::NamedRow row_of(const RollingPoint& p) {
  const RollingCase& c = p.asked;
  return {{"aspect_ratio", std::int64_t{c.aspect_ratio}},
          {"poisson_ratio", c.poisson_ratio},
          {"load", load_of(c)},
          {"amplitude", c.amplitude ? dem::Cell{*c.amplitude} : dem::Cell{}},
          {"bond_damping", c.bond_damping},
          {"rolling_friction", c.rolling_friction},
          {"rolling", std::string(dem::name(c.law))},
          {"peaks_first", std::int64_t{c.peaks.first}},
          {"peaks_last", std::int64_t{c.peaks.last}},
          {"fiber_damping_paper", p.damping},
          {"fiber_damping_paper_half_width", p.half_width},
          {"fiber_damping_first", p.first},
          {"fiber_damping_last", p.last},
          {"fiber_damping_modes", p.without},
          {"fiber_damping_as_bond", p.as_bond},
          {"fiber_damping_weak", p.weak},
          {"step_ratio", p.time_step / dem::bond_time_step(rolling_fiber(c))},
          {"steps", static_cast<std::int64_t>(p.steps)},
          {"status", p.status}};
}

template <class Value>
std::vector<std::optional<Value>> or_none(const std::vector<Value>& values) {
  if (values.empty()) return {std::nullopt};
  return {values.begin(), values.end()};
}

}  // namespace

std::vector<RollingCase> cases(const RollingSweep& sweep) {
  std::vector<RollingCase> all;
  const std::vector<double> loads = sweep.amplitude.empty() ? sweep.load : std::vector<double>{1};
  for (const auto law : sweep.law)
    for (const auto& step : or_none(sweep.step_ratio))
      for (const double nu : sweep.poisson_ratio)
        for (const int aspect_ratio : sweep.aspect_ratio)
          for (const double damping : sweep.bond_damping)
            for (const double load : loads)
              for (const auto& amplitude : or_none(sweep.amplitude))
                for (const double friction : sweep.rolling_friction)
                  all.push_back(
                      {aspect_ratio, nu, load, amplitude, damping, friction, law, step, sweep.peaks});
  return all;
}

RollingFigureCases rolling_figure_cases(PeakRange peaks) {
  using dem::Rolling;
  const std::vector<double> friction{0, 0.5, 1, 1.5, 2, 3, 4, 6, 8, 10}, coarse{0, 1, 2, 4, 10},
      lanes{0, 0.5, 1, 2, 4, 6, 8, 10};  // as many as march side by side
  RollingFigureCases figures;
  figures.friction = cases(
      {.aspect_ratio = {10, 20, 30}, .load = {0.3, 1, 3}, .rolling_friction = friction, .peaks = peaks});
  figures.step = cases({.aspect_ratio = {30},
                        .load = {3},
                        .rolling_friction = lanes,
                        .law = {Rolling::explicit_sign, Rolling::set_valued},
                        .step_ratio = {0.1, 0.03, 0.01},
                        .peaks = peaks});
  const std::vector<RollingCase> others = cases({.aspect_ratio = {10, 20, 30},
                                                 .load = {0.3, 1, 3},
                                                 .rolling_friction = coarse,
                                                 .law = {Rolling::explicit_sign, Rolling::set_valued},
                                                 .step_ratio = {0.1, 0.03, 0.01},
                                                 .peaks = peaks});
  for (const RollingCase& c : others) {
    if (c.aspect_ratio < 30 || c.load != 3) figures.step.push_back(c);
  }
  // long fibers at the least step: what it does to the set-valued law shows at r_f = 10, to the sign at one
  // load
  std::erase_if(figures.step, [](const RollingCase& c) {
    return c.aspect_ratio > 10 && *c.step_ratio < 0.02 &&
           (c.law == Rolling::set_valued || (c.aspect_ratio == 30 && c.load != 3));
  });
  figures.amplitude = cases({.aspect_ratio = {10, 30},
                             .amplitude = {0.003, 0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5},
                             .rolling_friction = {0, 1, 4},
                             .peaks = peaks});
  figures.decay =
      cases({.aspect_ratio = {30}, .load = {3}, .rolling_friction = {0, 1, 4, 10}, .peaks = {0, 12}});
  return figures;
}

dem::Table rolling_table(const std::vector<RollingPoint>& points) {
  return tabulate(points, [](const RollingPoint& point) { return row_of(point); });
}

dem::Table rolling_peaks_table(const std::vector<RollingPoint>& points) {
  dem::Table table(
      {"aspect_ratio", "load", "rolling_friction", "rolling", "peak", "peak_height", "peak_time"});
  for (const RollingPoint& p : points) {
    const double t_b = dem::bond_time_step(rolling_fiber(p.asked));
    for (std::size_t j = 0; j < p.peaks.size(); ++j) {
      table.append({{"aspect_ratio", std::int64_t{p.asked.aspect_ratio}},
                    {"load", load_of(p.asked)},
                    {"rolling_friction", p.asked.rolling_friction},
                    {"rolling", std::string(dem::name(p.asked.law))},
                    {"peak", static_cast<std::int64_t>(j)},
                    {"peak_height", p.peaks[j].value},
                    {"peak_time", p.peaks[j].time / t_b}});
    }
  }
  return table;
}

}  // namespace fiberchain::compare
