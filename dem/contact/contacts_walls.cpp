#include <algorithm>
#include <cmath>

#include "dem/contact/contacts.hpp"

// Walls as they move, and what contacts do to them.
namespace fiberchain::dem {
namespace {

/// Of what is no farther than `reach` from where a wall turns [m].
double displacement_between(const WallPose& before, const WallPose& now, double reach) {
  const double shifted = norm(now.shift - before.shift);
  if (!now.turned || reach == 0) return shifted;
  // the chord of the angle between both
  return shifted + 2 * norm((conjugate(before.turn) * now.turn).v) * reach;
}

}  // namespace

void Contacts::end_forces(double time) {
  for (std::size_t w = 0; w < domain_.walls.size(); ++w) {
    WallLoad now;
    for (Part& part : parts_) {
      add_times(now, 1, part.wall_loads[w]);
      records_[w].work += part.wall_brought[w];
      part.wall_brought[w] = 0;
    }
    end_step(domain_.walls[w], records_[w], now, time, step_);
  }
}

void Contacts::move_walls() { move_driven(domain_.walls, step_); }

void Contacts::count_from(std::size_t w, const Vec<double, 3>& offset) {
  Wall& wall = domain_.walls[w];
  wall.shape = wall.shape.moved({.shift = offset});
  if (wall.motion.about) wall.motion.about->point = wall.motion.about->point + offset;
  const auto recount = [&](WallPose& pose) {
    pose.center = pose.center + offset;
    pose.shift = pose.shift - offset;
  };
  recount(reference_poses_[w]);
  if (!mesh_poses_.empty()) recount(mesh_poses_[w]);
}

void Contacts::set_wall_velocity(std::size_t w, const Vec<double, 3>& velocity, double time) {
  Vec<double, 3>& before = domain_.walls[w].velocity;
  count_from(w, time * (before - velocity));
  before = velocity;
}

void Contacts::shift_wall(std::size_t w, const Vec<double, 3>& by) { count_from(w, by); }

bool Contacts::is_listed_elsewhere(std::size_t w, double time) const {
  const double displacement = wall_displacement(w, time);
  // walls at rest are not looked at any more
  return is_at_rest(domain_.walls[w]) ? displacement > 0 : displacement > 0.5 * skin_;
}

void Contacts::begin_wall_interval(double time) {
  for (WallRecord& record : records_) {
    record.impulse = {};
    add_times(record.impulse, 0.5 * step_, record.now);
    record.force_peak = norm(record.now.force);
    record.moment_peak = norm(record.now.moment);
    record.interval_begin = time;
  }
}

std::vector<WallSample> Contacts::wall_samples(double time) const {
  std::vector<WallSample> all;
  for (std::size_t w = 0; w < records_.size(); ++w) {
    const WallRecord& record = records_[w];
    const double interval = time - record.interval_begin;
    WallLoad mean = record.now;
    if (interval > 0.5 * step_) {
      mean = {};
      add_times(mean, 1 / interval, record.impulse);
      add_times(mean, -0.5 * step_ / interval, record.now);
    }
    all.push_back({mean, record.force_peak, record.moment_peak, record.work - 0.5 * step_ * record.power,
                   pose_at(domain_.walls[w], time).center_now()});
  }
  return all;
}

double Contacts::wall_work() const {
  if (!accounted_) return 0;
  double sum = 0;
  for (const WallRecord& record : records_) sum += record.work - 0.5 * step_ * record.power;
  return sum;
}

double Contacts::wall_displacement(std::size_t w, double time) const {
  return displacement_between(reference_poses_[w], pose_at(domain_.walls[w], time), turn_reach_[w]);
}

bool Contacts::walls_moved_far(double time) const {
  for (std::size_t w = 0; w < domain_.walls.size(); ++w) {
    const Wall& wall = domain_.walls[w];
    if (is_at_rest(wall) || time >= wall.active_until) continue;
    if (wall_displacement(w, time) > 0.5 * skin_) return true;
  }
  return false;
}

double Contacts::fastest_wall(double time) const {
  double fastest = 0;
  for (std::size_t w = 0; w < domain_.walls.size(); ++w) {
    const Wall& wall = domain_.walls[w];
    if (is_at_rest(wall) || !is_active(wall, time)) continue;
    const WallVelocity now = velocity_at(wall, time);
    fastest = std::max(fastest, norm(now.velocity) + norm(now.spin) * turn_reach_[w]);
  }
  return fastest;
}

void Contacts::measure_turn_reach() {
  turn_reach_.assign(domain_.walls.size(), 0);
  for (std::size_t w = 0; w < domain_.walls.size(); ++w) {
    if (!turns_visibly(domain_.walls[w])) continue;
    const Vec<double, 3> center = reference_poses_[w].center_now(),
                         axis = domain_.walls[w].motion.about->axis;
    for (const Vec<double, 3>& place : neighbors_.reference_positions())
      turn_reach_[w] = std::max(turn_reach_[w], norm(cross(place - center, axis)));
  }
}

std::vector<double> Contacts::wall_records() const { return record_numbers(records_, domain_.walls); }

void Contacts::set_wall_records(const double* from) { set_record_numbers(from, records_, domain_.walls); }

void Contacts::add_mesh_ways(double time) {
  for (const std::size_t w : mesh_walls_) {
    const WallPose now = pose_at(domain_.walls[w], time);
    // spheres have gone no farther from where they were listed than the skin
    const double reach = turn_reach_[w] > 0 ? turn_reach_[w] + skin_ : 0;
    mesh_ways_[w] += displacement_between(mesh_poses_[w], now, reach);
    mesh_poses_[w] = now;
  }
}

void Contacts::keep_wall_poses(double time) {
  reference_poses_.clear(), reference_shifts_.clear();
  for (const Wall& wall : domain_.walls) {
    reference_poses_.push_back(pose_at(wall, time));
    reference_shifts_.push_back(wall.motion.drive ? wall.motion.drive->shift : 0);
  }
  if (mesh_walls_.empty()) return;
  mesh_poses_ = reference_poses_;
  mesh_ways_.resize(domain_.walls.size(), 0);
}

void Contacts::set_drive_shifts(const std::vector<double>& shifts) {
  for (std::size_t w = 0; w < shifts.size(); ++w) {
    if (std::optional<WallDrive>& drive = domain_.walls[w].motion.drive) drive->shift = shifts[w];
  }
}

}  // namespace fiberchain::dem
