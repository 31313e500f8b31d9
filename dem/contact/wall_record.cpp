#include "dem/contact/wall_record.hpp"

#include <algorithm>
#include <cmath>

namespace fiberchain::dem {
namespace {

/// A kick of the mass with the loads of its middle: m (v+ - v-) = dt (F - c (v- + v+) / 2).
void kick(WallDrive& drive, double load, double step) {
  const double half_drag = 0.5 * step * drive.damping / drive.mass;
  drive.speed = ((1 - half_drag) * drive.speed + step / drive.mass * (drive.force + load)) / (1 + half_drag);
}

}  // namespace

void add_times(WallLoad& sum, double factor, const WallLoad& more) {
  sum.force = sum.force + factor * more.force;
  sum.moment = sum.moment + factor * more.moment;
}

void end_step(Wall& wall, WallRecord& record, const WallLoad& now, double time, double step) {
  record.now = now;
  const WallVelocity before = velocity_at(wall, time - 0.5 * step);
  if (wall.motion.drive && is_active(wall, time))
    kick(*wall.motion.drive, dot(now.force, wall.motion.drive->axis), step);
  const WallVelocity after = velocity_at(wall, time + 0.5 * step);
  add_times(record.impulse, step, now);
  record.force_peak = std::max(record.force_peak, norm(now.force));
  record.moment_peak = std::max(record.moment_peak, norm(now.moment));
  record.power =
      -0.5 * (dot(now.force, before.velocity + after.velocity) + dot(now.moment, before.spin + after.spin));
  record.work += step * record.power;
}

void move_driven(std::vector<Wall>& walls, double step) {
  for (Wall& wall : walls) {
    if (wall.motion.drive) wall.motion.drive->shift += step * wall.motion.drive->speed;
  }
}

std::vector<double> record_numbers(const std::vector<WallRecord>& records, const std::vector<Wall>& walls) {
  std::vector<double> all;
  for (std::size_t w = 0; w < records.size(); ++w) {
    const WallRecord& r = records[w];
    for (const auto& v : {r.now.force, r.now.moment, r.impulse.force, r.impulse.moment})
      all.insert(all.end(), v.c, v.c + 3);
    const std::optional<WallDrive>& drive = walls[w].motion.drive;
    all.insert(all.end(), {r.force_peak, r.moment_peak, r.interval_begin, r.work, r.power,
                           drive ? drive->shift : 0, drive ? drive->speed : 0});
  }
  return all;
}

void set_record_numbers(const double* from, std::vector<WallRecord>& records, std::vector<Wall>& walls) {
  for (std::size_t w = 0; w < records.size(); ++w, from += wall_record_size) {
    WallRecord& r = records[w];
    const double* vector = from;
    for (Vec<double, 3>* v : {&r.now.force, &r.now.moment, &r.impulse.force, &r.impulse.moment})
      std::copy_n(vector, 3, v->c), vector += 3;
    r.force_peak = vector[0], r.moment_peak = vector[1], r.interval_begin = vector[2];
    r.work = vector[3], r.power = vector[4];
    if (std::optional<WallDrive>& drive = walls[w].motion.drive)
      drive->shift = vector[5], drive->speed = vector[6];
  }
}

}  // namespace fiberchain::dem
