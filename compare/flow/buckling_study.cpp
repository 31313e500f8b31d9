#include <fmt/format.h>
#include <cmath>
#include <limits>

#include "compare/flow/buckling.hpp"
#include "compare/study/tabulate.hpp"
#include "reference/compressed_chain.hpp"
#include "reference/filament_buckling.hpp"

namespace fiberchain::compare {
namespace {

constexpr int kSpheres[] = {10, 20, 40};
constexpr double kNumbers[] = {60, 100, 115, 135, 200, 400, 800};
constexpr int kDrawn = 20;  ///< spheres of the chain in the figures

struct Growth {
  BucklingCase asked;
  BucklingRun run = {};
  double chain = 0, filament = 0;  ///< growth over rate by the references
};

std::vector<Growth> growths(const OrbitOptions& options) {
  std::vector<Growth> all;
  for (const int N : kSpheres) {
    for (const double number : kNumbers) all.push_back({.asked = {.spheres = N, .number = number}});
  }
  options.jobs.run(all.size(), [&](std::size_t i) {
    Growth& g = all[i];
    g.run = run_buckling(g.asked);
    g.chain =
        reference::chain_growth_mode({g.asked.spheres, g.asked.poisson_ratio}, g.asked.number, 1).growth;
    g.filament = reference::growth_rates(g.asked.number, 1)[0];
  });
  return all;
}

dem::Table growth_table(const std::vector<Growth>& growths) {
  return tabulate(growths, [&](const Growth& g) -> dem::NamedRow {
    return {{"aspect_ratio", std::int64_t{g.asked.spheres - 1}},
            {"spheres", std::int64_t{g.asked.spheres}},
            {"elasto_viscous", g.asked.number},
            {"growth", g.run.growth},
            {"growth_chain", g.chain},
            {"growth_filament", g.filament},
            {"growth_error", g.run.growth - g.chain}};
  });
}

dem::Table threshold_table(const OrbitOptions& options) {
  dem::Table table({"aspect_ratio", "spheres", "threshold_below", "threshold_above", "threshold_chain",
                    "threshold_inextensible", "threshold_filament"});
  std::vector<Threshold> found(std::size(kSpheres));
  options.jobs.run(found.size(),
                   [&](std::size_t i) { found[i] = buckling_threshold_of(kSpheres[i], 100, 150, 0.02); });
  for (std::size_t i = 0; i < found.size(); ++i) {
    const int N = kSpheres[i];
    table.append({{"aspect_ratio", std::int64_t{N - 1}},
                  {"spheres", std::int64_t{N}},
                  {"threshold_below", found[i].below},
                  {"threshold_above", found[i].above},
                  {"threshold_chain", reference::chain_buckling_threshold({N, 0.3}, 1)},
                  {"threshold_inextensible",
                   reference::chain_buckling_threshold({N, 0.3, std::numeric_limits<double>::infinity()}, 1)},
                  {"threshold_filament", reference::buckling_threshold(1)}});
  }
  return table;
}

Figure amplitude_figure(const std::vector<Growth>& growths) {
  Figure figure{"A small bend of 20 spheres in compression: chain and its linearization",
                {"rate times time"},
                {"amplitude over that at the start", true},
                {}};
  figure.legend_title = "3πμε{/:Italic L}^4/{/:Italic EI}";
  figure.ordered = true;
  int color = 0;
  for (const Growth& g : growths) {
    if (g.asked.spheres != kDrawn || g.asked.number == 800) continue;
    Series chain{fmt::format("{:g}", g.asked.number), {}, {}, Mark::points, Dash::solid, color};
    Series linear{"", {}, {}, Mark::line, Dash::solid, color++};
    const std::size_t from = g.run.time.size() / 3;
    for (std::size_t i = 0; i < g.run.time.size(); i += 3) {
      chain.add(g.run.time[i], g.run.amplitude[i]);
      linear.add(g.run.time[i],
                 g.run.amplitude[from] * std::exp(g.chain * (g.run.time[i] - g.run.time[from])));
    }
    figure.series.push_back(std::move(linear));
    figure.series.push_back(std::move(chain));
  }
  return figure;
}

/// From a small bend to a large one.
Figure shapes_figure() {
  const BucklingCase c{.spheres = 40, .number = 400, .bend = 0.002, .duration = 3, .tolerance = 1e-8};
  const BucklingRun run = run_buckling(c, 7);
  Figure figure{
      "40 spheres buckle under compression along {/:Italic x}, 3πμε{/:Italic L}^4/{/:Italic EI} "
      "= 400",
      {"{/:Italic x}/{/:Italic L}"},
      {"{/:Italic y}/{/:Italic L}"},
      {}};
  figure.equal_axes = figure.ordered = true;
  figure.legend_title = "rate times time";
  for (const FlowShape& shape : run.shapes) {
    Series s{fmt::format("{:.1f}", shape.time), {}, {}, Mark::line_and_points};
    for (const Triple& at : shape.spheres) s.add(at[0], at[1]);
    figure.series.push_back(std::move(s));
  }
  return figure;
}

}  // namespace

FlowStudy buckling_study(const OrbitOptions& options) {
  const std::vector<Growth> all = growths(options);
  return {.table = growth_table(all),
          .figures = {{"shear-buckling", amplitude_figure(all)}, {"shear-buckling-shapes", shapes_figure()}},
          .more_tables = {{"shear-threshold", threshold_table(options)}}};
}

}  // namespace fiberchain::compare
