#pragma once

#include <vector>

#include "dem/math/vec.hpp"
#include "dem/model/domain.hpp"

namespace fiberchain::dem {

/// What contacts do to a wall.
struct WallLoad {
  Vec<double, 3> force{};   ///< [N]
  Vec<double, 3> moment{};  ///< about the center of its pose [N m]
};

/// Of a wall over the steps.
struct WallRecord {
  WallLoad now;                ///< at the last forces
  WallLoad impulse;            ///< since the interval began, with the whole kick of now [N s], [N m s]
  double force_peak = 0;       ///< size of the largest force in the interval, both ends included [N]
  double moment_peak = 0;      ///< likewise [N m]
  double interval_begin = 0;   ///< [s]
  double work = 0, power = 0;  ///< done on what it touches since the start, with the kick of now [J]; now [W]
};

/// Of a wall, or of a grip, in an interval that ends now.
struct WallSample {
  WallLoad mean;          ///< impulse over the time
  double force_peak;      ///< size of the largest force at any step [N]
  double moment_peak;     ///< likewise [N m]
  double work;            ///< done on fibers since the start [J]
  Vec<double, 3> center;  ///< about which moments are [m]
};

void add_times(WallLoad& sum, double factor, const WallLoad& more);

/// The loads of a step at `time` [s] enter the record, and kick a driven wall.
void end_step(Wall& wall, WallRecord& record, const WallLoad& now, double time, double step);

/// Driven walls go on by a step [s].
void move_driven(std::vector<Wall>& walls, double step);

/// Numbers of one wall's record in a file; the last two are shift and speed of its drive.
inline constexpr int wall_record_size = 19;

std::vector<double> record_numbers(const std::vector<WallRecord>& records, const std::vector<Wall>& walls);
/// `from` has wall_record_size numbers a wall.
void set_record_numbers(const double* from, std::vector<WallRecord>& records, std::vector<Wall>& walls);

}  // namespace fiberchain::dem
