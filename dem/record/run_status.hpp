#pragma once

#include <chrono>
#include <cstdint>
#include <ostream>
#include <string>

namespace fiberchain::dem {

/// Where a run of many steps stands.
struct RunStatus {
  std::int64_t step;
  double time;  ///< simulated [s]
  std::int64_t contacts;
  double kinetic_energy;  ///< [J]
  double height;          ///< of the packing [m]
  double step_rate;       ///< [1/s]
  double time_left;       ///< until the last step, by the clock [s]; NaN while nobody knows
};

/// The rate of steps since this was made: of this session, not of those it resumed.
class Pace {
 public:
  /// @param done steps done before
  Pace(std::int64_t done, std::int64_t total) : done_(done), total_(total) {}

  double step_rate(std::int64_t step) const;  ///< [1/s]; NaN before the first step
  double time_left(std::int64_t step) const;  ///< [s]

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::int64_t done_, total_;
};

/// One line for people: "step 1200 of 20000, t = 0.0048 s, 5321 contacts, ...".
std::string status_line(const RunStatus& status, std::int64_t steps);

/// The same in less than so many columns: what matters least is left out.
std::string status_line(const RunStatus& status, std::int64_t steps, std::size_t columns);

/// Rewrites one line of a terminal; writes nothing where nobody watches.
class StatusDisplay {
 public:
  StatusDisplay(std::ostream& stream, bool watched) : stream_(stream), watched_(watched) {}
  StatusDisplay(const StatusDisplay&) = delete;
  StatusDisplay& operator=(const StatusDisplay&) = delete;
  ~StatusDisplay();

  /// Shows the line if the last is a third of a second old, or this is the last.
  void show(const RunStatus& status, std::int64_t steps);

 private:
  std::ostream& stream_;
  bool watched_;
  std::size_t shown_ = 0;  ///< length of the line there is
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace fiberchain::dem
