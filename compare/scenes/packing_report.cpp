#include "compare/scenes/packing_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {
namespace {

std::vector<double> column(const dem::Table& log, std::string_view name) {
  std::vector<double> values;
  for (std::size_t row = 0; row < log.rows().size(); ++row) values.push_back(log.number(row, name));
  return values;
}

/// A line through what is finite: a run that blew up may end in what is not.
void add_line(Figure& figure, std::string_view label, const std::vector<double>& x,
              const std::vector<double>& y) {
  Series line{std::string(label), {}, {}, Mark::line};
  for (std::size_t n = 0; n < x.size(); ++n) {
    if (std::isfinite(y[n])) line.add(x[n], y[n]);
  }
  if (!line.x.empty()) figure.series.push_back(std::move(line));
}

std::string status_of(const dem::PackingEndState& end) {
  if (!end.failure.empty()) return end.failure;
  if (end.next_batch > 0) return fmt::format("finished; no room for batches from {} on", end.next_batch + 1);
  return end.finished() ? "finished" : "stopped";
}

}  // namespace

dem::Table packing_run_table(const dem::PackingJob& job, const dem::PackingEndState& end) {
  return table_of({{"fibers", end.fibers},
                   {"spheres", end.spheres},
                   {"seed", static_cast<std::int64_t>(job.scene.filling.seed)},
                   {"time_step", end.step},
                   {"step_set_by", job.scene.step ? std::string("scene") : std::string(end.choice.set_by)},
                   {"steps", end.last.step},
                   {"simulated_time", end.last.time},
                   {"contacts", end.last.contacts},
                   {"coordination", dem::known(end.coordination)},
                   {"height", end.last.height},
                   {"bending_mean", end.last.bending_mean},
                   {"overlap_mean", end.last.overlap_mean},
                   {"overlap_peak", end.last.overlap_peak},
                   {"kinetic_energy", end.last.energy.kinetic},
                   {"run_time", dem::known(end.run_time)},
                   {"status", status_of(end)}});
}

std::vector<std::pair<std::string, Figure>> packing_run_figures(const dem::PackingJob& job,
                                                                const dem::Table& log) {
  const std::vector<double> time = column(log, "simulated_time");
  Figure bending{"Mean bending angle per bond", {"time (s)"}, {"angle (rad)"}, {}};
  add_line(bending, "", time, column(log, "bending_mean"));
  Figure energy{"Energy", {"time (s)"}, {"energy (J)"}, {}};
  const auto add_energy = [&](const dem::EnergyMechanism& term) {
    const std::vector<double> values = column(log, term.column);
    const bool nothing = std::ranges::all_of(values, [](double v) { return v == 0; });
    if (!nothing) add_line(energy, term.label, time, values);
  };
  for (const dem::EnergyMechanism& term : dem::energy_mechanisms) {
    if (job.scene.account_energy || term.role == dem::EnergyRole::stored) add_energy(term);
  }
  if (job.scene.account_energy) add_energy(dem::energy_total);
  std::vector<std::pair<std::string, Figure>> figures;
  if (!bending.series.empty()) figures.emplace_back("-bending", std::move(bending));
  if (!energy.series.empty()) figures.emplace_back("-energy", std::move(energy));
  return figures;
}

}  // namespace fiberchain::compare
