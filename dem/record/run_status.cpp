#include "dem/record/run_status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dem/record/progress.hpp"

namespace fiberchain::dem {
namespace {

/// "42 s", "3:07 min", "1:05 h".
std::string duration(double seconds) {
  if (!std::isfinite(seconds)) return "unknown";
  const auto whole = static_cast<std::int64_t>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

}  // namespace

double Pace::step_rate(std::int64_t step) const {
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
  if (step <= done_ || passed.count() <= 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(step - done_) / passed.count();
}

double Pace::time_left(std::int64_t step) const {
  return static_cast<double>(total_ - step) / step_rate(step);
}

std::string status_line(const RunStatus& status, std::int64_t steps) {
  std::string line =
      fmt::format("step {} of {}, t = {:.4g} s, {} contacts, kinetic energy {:.3g} J, height {:.3g} m",
                  status.step, steps, status.time, status.contacts, status.kinetic_energy, status.height);
  if (std::isfinite(status.step_rate)) line += fmt::format(", {:.0f} steps/s", status.step_rate);
  if (std::isfinite(status.time_left)) line += fmt::format(", {} left", duration(status.time_left));
  return line;
}

std::string status_line(const RunStatus& status, std::int64_t steps, std::size_t columns) {
  std::string line = status_line(status, steps);
  if (line.size() < columns) return line;
  line = fmt::format("step {} of {}", status.step, steps);
  const auto add = [&](bool known, const std::string& part) {
    if (known && line.size() + part.size() < columns) line += part;
  };
  add(std::isfinite(status.time_left), fmt::format(", {} left", duration(status.time_left)));
  add(true, fmt::format(", t = {:.4g} s", status.time));
  add(true, fmt::format(", {} contacts", status.contacts));
  add(true, fmt::format(", height {:.3g} m", status.height));
  add(std::isfinite(status.step_rate), fmt::format(", {:.0f} steps/s", status.step_rate));
  return line.substr(0, columns - 1);
}

StatusDisplay::~StatusDisplay() {
  if (shown_ > 0) stream_ << std::endl;
}

void StatusDisplay::show(const RunStatus& status, std::int64_t steps) {
  const auto now = std::chrono::steady_clock::now();
  const bool due = shown_ == 0 || status.step >= steps || now - last_ > std::chrono::milliseconds(333);
  if (!watched_ || !due) return;
  const std::string line = status_line(status, steps, terminal_width());
  stream_ << '\r' << line << std::string(shown_ - std::min(shown_, line.size()), ' ') << std::flush;
  shown_ = line.size();
  last_ = now;
}

}  // namespace fiberchain::dem
