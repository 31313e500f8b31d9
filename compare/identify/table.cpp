#include "compare/identify/table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

namespace fiberchain::compare {

dem::Table identification_table(const Identification& found) {
  dem::Table table({"quantity", "identified", "interval_low", "interval_high", "unit"});
  const auto add = [&](const char* quantity, const Estimate& e, const char* unit) {
    table.append({{"quantity", std::string(quantity)},
                  {"identified", dem::known(e.value)},
                  {"interval_low", dem::known(e.low)},
                  {"interval_high", dem::known(e.high)},
                  {"unit", std::string(unit)}});
  };
  add("frequency", found.frequency, "rad/s");
  const auto hertz = [](double omega) { return omega / (2 * std::numbers::pi); };
  add("frequency_hertz",
      {hertz(found.frequency.value), hertz(found.frequency.low), hertz(found.frequency.high)}, "Hz");
  add("damping_ratio", found.damping_ratio, "1");
  add("log_decrement", found.log_decrement, "1");
  add("loss_factor", found.loss_factor, "1");
  if (found.youngs_modulus) add("youngs_modulus", *found.youngs_modulus, "Pa");
  if (found.bond_damping) add("bond_damping", *found.bond_damping, "1");
  return table;
}

dem::Table identified_record_table(const RingDownRecord& record, const Identification& found) {
  dem::Table table({"record_time", "record_displacement", "fitted", "left"});
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    const double left = found.fit.residuals[i];
    table.append({{"record_time", record.time[i]},
                  {"record_displacement", record.displacement[i]},
                  {"fitted", record.displacement[i] - left},
                  {"left", left}});
  }
  return table;
}

std::string identification_notes(const Identification& found) {
  std::string notes;
  for (const std::string& doubt : found.doubts) notes += "The record cannot tell the " + doubt + ".\n\n";
  if (found.fit.modes.empty()) return notes;
  notes += fmt::format(
      "{:.4g} periods of an amplitude of {:.4g} at the begin; noise {:.3g} ({:.2g} % of it), {} samples.\n",
      found.periods, found.amplitude, found.noise, 100 * found.noise / found.amplitude,
      found.fit.residuals.size());
  const DampedSine& first = found.fit.modes.front();
  for (std::size_t k = 1; k < found.fit.modes.size(); ++k) {
    const DampedSine& mode = found.fit.modes[k];
    notes += fmt::format(
        "\nBeside it a mode at {:.4g} times its frequency (a beam's second: 6.267), damping ratio {:.3g}, "
        "{:.2g} of its amplitude.\n",
        std::hypot(mode.s, mode.w) / std::hypot(first.s, first.w), mode.s / std::hypot(mode.s, mode.w),
        std::hypot(mode.a, mode.b) / found.amplitude);
  }
  for (const std::string& warning : found.warnings) notes += "\nWarning: " + warning + ".\n";
  return notes;
}

}  // namespace fiberchain::compare
