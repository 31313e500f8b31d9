#include <fmt/format.h>

#include <cmath>

#include "dem/assembly/assembly_state.hpp"
#include "dem/model/errors.hpp"

// What may be changed between steps.
namespace fiberchain::dem {
namespace {

using V = Vec<double, 3>;

void require_finite(const char* what, const V& v) {
  for (int c = 0; c < 3; ++c) {
    if (!std::isfinite(v[c]))
      throw InvalidInput(
          fmt::format("{} = [{}, {}, {}] is not allowed: it must be finite", what, v[0], v[1], v[2]));
  }
}

std::size_t number_of_wall(const std::vector<Wall>& walls, int wall) {
  if (wall < 0 || wall >= std::ssize(walls))
    throw InvalidInput(
        fmt::format("wall {} is not allowed: there are {}, numbered from 0", wall, walls.size()));
  return static_cast<std::size_t>(wall);
}

/// The neighbor list knows the wall where it stands now, or near enough.
void keep_listed(Assembly::State& s, std::size_t wall) {
  if (s.contacts.is_listed_elsewhere(wall, s.time())) s.rebuild_neighbor_list();
}

}  // namespace

const V& Assembly::gravity() const { return state_->domain.gravity; }

void Assembly::set_gravity(const V& gravity) {
  require_finite("gravity", gravity);
  State& s = *state_;
  // of height, and of velocities, whose half kick to this moment is another one
  const auto stored = [&] { return sum_of(s.sample().energy, EnergyRole::stored); };
  const double before = s.options.account_energy ? stored() : 0;
  s.domain.gravity = gravity;
  for (GroupKind& kind : s.kinds) kind.weight = kind.mass * gravity;
  if (s.options.account_energy) s.inserted += stored() - before;
}

void Assembly::set_wall_velocity(int wall, const V& velocity) {
  require_finite("velocity", velocity);
  State& s = *state_;
  const std::size_t w = number_of_wall(s.contacts.walls(), wall);
  s.contacts.set_wall_velocity(w, velocity, s.time());
  s.domain.walls[w].velocity = velocity;
  keep_listed(s, w);
}

void Assembly::shift_wall(int wall, const V& by) {
  require_finite("shift", by);
  State& s = *state_;
  const std::size_t w = number_of_wall(s.contacts.walls(), wall);
  if (s.options.account_energy)
    throw InvalidInput(
        "a wall cannot be put elsewhere at once where energies are accounted: give it a velocity");
  s.contacts.shift_wall(w, by);
  const Wall& there = s.contacts.walls()[w];
  for (std::int64_t row = 0; is_active(there, s.time()) && row < s.rows.count; ++row) {
    if (gap_to(there, s.rows.position(row), s.time()) > 0) continue;
    s.contacts.shift_wall(w, -by);
    throw InvalidInput(
        fmt::format("wall {} is not allowed there: {} would be behind it", wall, s.place_of(row)));
  }
  keep_listed(s, w);
}

MarchRecord Assembly::record() const {
  return {state_->contacts.deepest(), state_->longest_path, state_->contacts.wall_records()};
}

void Assembly::adopt(const MarchRecord& record) {
  State& s = *state_;
  if (record.walls.size() != s.contacts.wall_records().size())
    throw InvalidInput(fmt::format("{} numbers of walls' records are not allowed: these walls have {}",
                                   record.walls.size(), s.contacts.wall_records().size()));
  s.contacts.set_deepest(record.deepest_overlap);
  s.longest_path = record.longest_path;
  s.contacts.set_wall_records(record.walls.data());
}

}  // namespace fiberchain::dem
