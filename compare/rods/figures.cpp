#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "compare/rods/study.hpp"

namespace fiberchain::compare {
namespace {

/// What the figure of a loaded rod shows.
struct LoadFigure {
  std::string_view benchmark;
  std::string title, load, value;
  double most;  ///< load
  double sign = 1;
};

/// Points of chains of so many bonds, a series of each bond law: `add` puts a setting's, which has the bond,
/// into it.
template <class Add>
void add_chains(Figure& figure, RodSetting setting, int bonds, const Add& add) {
  setting.bonds = bonds;
  for (const auto bond : {dem::BondModel::paper, dem::BondModel::corrected}) {
    Series chain{fmt::format("chain of {} bonds, {}", bonds, dem::name(bond)), {}, {}, Mark::points};
    setting.bond = bond;
    add(setting, chain);
    figure.series.push_back(std::move(chain));
  }
}

/// The number shown against the load: rod as a line, chains of 20 bonds as points.
Figure load_figure(const LoadFigure& what) {
  const RodBenchmark& one = rod_benchmark(what.benchmark);
  Figure figure{what.title, {what.load}, {what.value}, {}};
  RodSetting setting{.bond = dem::BondModel::corrected, .bonds = 80, .poisson_ratio = 0.17};
  Series rod{"rod", {}, {}, Mark::line};
  constexpr int rod_points = 28, chain_points = 14;
  for (int i = 1; i <= rod_points; ++i) {
    setting.load = what.most * i / rod_points;
    rod.add(setting.load, what.sign * one.rod(setting).at(one.shown));
  }
  figure.series.push_back(rod);
  add_chains(figure, setting, 20, [&](RodSetting at, Series& chain) {
    for (int i = 1; i <= chain_points; ++i) {
      at.load = what.most * i / chain_points;
      chain.add(at.load, what.sign * one.chain(at).at(one.shown));
    }
  });
  return figure;
}

Figure column_figure() {
  const RodBenchmark& one = rod_benchmark("column-beyond");
  Figure figure{"A hinged column beyond its critical load",
                {"height of the middle over {/:Italic L}"},
                {"{/:Italic P L}^2/{/:Italic EI}"},
                {}};
  RodSetting setting{.bond = dem::BondModel::corrected, .bonds = 80, .poisson_ratio = 0.17};
  const double critical = rod_benchmark("column-hinged").rod(setting).front();
  Series rod{"rod", {0, 0}, {0.8 * critical, critical}, Mark::line};
  for (int i = 3; i <= 30; ++i) {
    setting.load = critical + (20 - critical) * i * i / 900;
    rod.add(one.rod(setting).front(), setting.load);
  }
  figure.series.push_back(rod);
  add_chains(figure, setting, 20, [&](RodSetting at, Series& chain) {
    for (int i = 0; i < 12; ++i) {
      at.load = 10.3 + 0.85 * i;
      chain.add(one.chain(at).front(), at.load);
    }
  });
  return figure;
}

Figure lees_figure() {
  Figure figure{
      "Lee's frame", {"way of the loaded point over {/:Italic L}"}, {"{/:Italic P L}^2/{/:Italic EI}"}, {}};
  const RodSetting setting{.bond = dem::BondModel::corrected, .bonds = 40, .poisson_ratio = 0.17};
  const LeesPath rod = lees_path_of_rod(setting, 0.39);
  figure.series.push_back({"rod", rod.down, rod.load, Mark::line});
  add_chains(figure, setting, 40, [](const RodSetting& at, Series& series) {
    const LeesPath chain = lees_path_of_chain(at, 0.39);
    for (std::size_t i = 0; i < chain.down.size(); i += 3) series.add(chain.down[i], chain.load[i]);
  });
  return figure;
}

/// Critical turn of the ring or moment of the frame against Poisson's ratio.
Figure critical_figure(std::string_view benchmark, std::string title, std::string value,
                       const std::function<double(double)>& unit) {
  const RodBenchmark& one = rod_benchmark(benchmark);
  Figure figure{std::move(title), {"Poisson's ratio ν"}, {std::move(value)}, {}};
  RodSetting setting{.bond = dem::BondModel::corrected, .bonds = 40};
  for (const auto bond : {dem::BondModel::paper, dem::BondModel::corrected}) {
    const bool paper = bond == dem::BondModel::paper;
    Series rod{paper ? "rod that shears" : "rod", {}, {}, Mark::line, paper ? Dash::dashed : Dash::solid};
    setting.bond = bond;
    for (int i = 0; i <= 10; ++i) {
      setting.poisson_ratio = 0.05 * i;
      rod.add(setting.poisson_ratio, one.rod(setting).front() / unit(setting.poisson_ratio));
    }
    figure.series.push_back(rod);
  }
  add_chains(figure, setting, 40, [&](RodSetting at, Series& chain) {
    for (int i = 0; i <= 5; ++i) {
      at.poisson_ratio = 0.1 * i;
      chain.add(at.poisson_ratio, one.chain(at).front() / unit(at.poisson_ratio));
    }
  });
  return figure;
}

/// Errors of all benchmarks with one bond.
Figure order_figure(dem::BondModel bond, const Jobs& jobs) {
  RodSweep sweep;
  sweep.aspect_ratio = {10, 20, 40};
  sweep.bond = {bond};
  const std::vector<RodPoint> points = rod_points(cases(sweep), {.jobs = jobs});
  Figure figure{fmt::format("Distance of chains from their rods, {} bond", dem::name(bond)),
                {"number of bonds {/:Italic r_f}", true},
                {"distance from the rod", true},
                {}};
  for (const RodPoint& p : points) {
    if (!has_converged(p)) continue;
    if (figure.series.empty() || figure.series.back().label != p.asked.benchmark)
      figure.series.push_back({p.asked.benchmark, {}, {}});
    figure.series.back().add(p.asked.setting.bonds, p.error);
    if (p.asked.setting.bonds == 40) figure.series.back().add(80, p.error_doubled);
  }
  return figure;
}

}  // namespace

std::vector<std::pair<std::string, Figure>> rod_figures(const Jobs& jobs) {
  using std::numbers::pi;
  const std::string force = "{/:Italic P L}^2/{/:Italic EI}", line = "{/:Italic w L}^3/{/:Italic EI}",
                    moment = "{/:Italic M L}/{/:Italic EI}";
  const LoadFigure loaded[] = {
      {"ring", "An end moment bends a rod to a ring", moment, "{/:Italic y} of the middle over {/:Italic L}",
       2 * pi},
      {"helix", "A wrench bends a rod to a helix", "factor of the wrench",
       "{/:Italic z} of the end over {/:Italic L}", 3},
      {"bend", "The 45 degree bend", force, "{/:Italic z} of the end over {/:Italic L}", 4.441},
      {"weight", "A cantilever under its weight", line, "drop of the end over {/:Italic L}", 25, -1},
      {"follower", "A force that follows the end", force, "{/:Italic y} of the end over {/:Italic L}", 20},
      {"pressure", "A pressure that follows the rod", line, "{/:Italic y} of the end over {/:Italic L}", 20},
      {"l-frame", "An L frame in space", "factor of the force", "{/:Italic z} of the end over {/:Italic L}",
       3}};
  std::vector<std::pair<std::string, Figure>> figures(std::size(loaded) + 6);
  jobs.run(std::size(loaded), [&](std::size_t i) {
    figures[i] = {fmt::format("rods-{}", loaded[i].benchmark), load_figure(loaded[i])};
  });
  auto at = figures.begin() + std::size(loaded);
  *at++ = {"rods-column", column_figure()};
  *at++ = {"rods-lees-frame", lees_figure()};
  *at++ = {"rods-twisted-ring",
           critical_figure("twisted-ring", "Turn at which a twisted ring leaves its plane",
                           "turn over 2π√3 {/:Italic EI}/{/:Italic GJ}", michell_turn)};
  *at++ = {"rods-right-angle-frame",
           critical_figure("right-angle-frame", "End moment at which a right-angle frame leaves its plane",
                           moment, [](double) { return 1.0; })};
  *at++ = {"rods-order-paper", order_figure(dem::BondModel::paper, jobs)};
  *at++ = {"rods-order-corrected", order_figure(dem::BondModel::corrected, jobs)};
  return figures;
}

}  // namespace fiberchain::compare
