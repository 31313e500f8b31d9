#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/press/press.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {
namespace {

dem::NamedRow asked_press(const PressCase& c) {
  return {{"fibers", std::int64_t{c.fibers}},
          {"aspect_ratio", std::int64_t{c.aspect_ratio}},
          {"press_friction", c.friction},
          {"side", c.side},
          {"press_speed", c.speed},
          {"seed", static_cast<std::int64_t>(c.seed)},
          {"surface", std::string(c.surface && c.surface->smooth ? "smooth" : "spheres")},
          {"spacing", static_cast<double>(c.surface ? c.surface->spacing : 1)}};
}

bool is_finished(const PressRun& run) { return run.status == "finished"; }

/// By which runs differ: seeds, or surfaces where those are compared.
std::string label_of(const PressCase& c) {
  if (!c.surface) return fmt::format("seed {}", c.seed);
  return c.surface->smooth ? fmt::format("smooth, bonds of {} {{/:Italic d}}", c.surface->spacing)
                           : "spheres";
}

std::vector<double> exponents_of(const std::vector<PressRun>& runs) {
  std::vector<double> all;
  for (const PressRun& run : runs) {
    if (is_finished(run)) all.push_back(fit_press(run).exponent);
  }
  return all;
}

}  // namespace

dem::Table press_table(const std::vector<PressRun>& runs) {
  const dem::NamedRow found = {{"press_exponent", 0.0},
                               {"press_stiffness", 0.0},
                               {"initial_fraction", 0.0},
                               {"press_residual", 0.0},
                               {"press_points", std::int64_t{}}};
  const dem::NamedRow rest = {{"press_touched", 0.0}, {"run_time", 0.0}, {"status", std::string()}};
  dem::Table table(names_of(joined(joined(asked_press({}), found), rest)));
  for (const PressRun& run : runs) {
    dem::NamedRow row = asked_press(run.asked);
    if (is_finished(run)) {
      const PressFit fit = fit_press(run);
      row = joined(row, {{"press_exponent", fit.exponent},
                         {"press_stiffness", fit.stiffness},
                         {"initial_fraction", fit.initial_fraction},
                         {"press_residual", fit.residual},
                         {"press_points", std::int64_t{fit.points}}});
    }
    table.append(
        joined(row, {{"press_touched", run.touched}, {"run_time", run.run_time}, {"status", run.status}}));
  }
  return table;
}

dem::Table press_sample_table(const std::vector<PressRun>& runs) {
  dem::Table table(joined(names_of(asked_press({})),
                          std::vector<std::string>{"solid_fraction", "plate_pressure", "floor_pressure"}));
  for (const PressRun& run : runs) {
    for (const PressSample& s : run.samples) {
      table.append(joined(asked_press(run.asked), {{"solid_fraction", s.solid_fraction},
                                                   {"plate_pressure", s.pressure},
                                                   {"floor_pressure", s.floor_pressure}}));
    }
  }
  return table;
}

std::string press_notes(const std::vector<PressRun>& runs) {
  const std::vector<double> exponents = exponents_of(runs);
  if (exponents.empty()) return "";
  const Spread n = spread_of(exponents);
  const std::string interval =
      exponents.size() > 1 ? fmt::format(" +- {:.2g} (95 % interval of the mean)", half_width(n)) : "";
  return fmt::format(
      "p = a (phi^n - phi_0^n), fitted to ln p from the solid fraction on at which the bed carries the "
      "plate: n = {:.3g}{} "
      "over "
      "{} seeds, from {:.3g} to {:.3g}; van Wyk has 3.\n",
      n.mean, interval, exponents.size(), n.least, n.most);
}

Figure press_figure(const std::vector<PressRun>& runs) {
  Figure figure{"Pressure of the plate on a bed of fibers", {"solid fraction", true}, {"p / E", true}, {}};
  double top = 0, at = 0;
  std::vector<std::string> labels;  // a color each
  for (const PressRun& run : runs) {
    const std::string label = label_of(run.asked);
    const auto alike = std::ranges::find(labels, label);
    Series series{alike == labels.end() ? label : "",      {}, {}, Mark::line, Dash::solid,
                  static_cast<int>(alike - labels.begin())};
    if (alike == labels.end()) labels.push_back(label);
    for (const PressSample& s : run.samples) {
      if (s.pressure > 0) series.add(s.solid_fraction, s.pressure / run.youngs_modulus);
    }
    if (!run.samples.empty() && run.samples.back().pressure / run.youngs_modulus > top)
      top = run.samples.back().pressure / run.youngs_modulus, at = run.samples.back().solid_fraction;
    figure.series.push_back(std::move(series));
  }
  Series cube{"slope 3", {}, {}, Mark::line, Dash::dashed, static_cast<int>(labels.size())};
  for (const double part : {0.3, 1.0}) cube.add(part * at, std::pow(part, 3) * top);
  if (top > 0) figure.series.push_back(std::move(cube));
  return figure;
}

}  // namespace fiberchain::compare
