#include "dem/lammps/rank_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dem/simd/lane_count.hpp"

namespace fiberchain::dem::mpi {
namespace {

/// Gap of the inner pairs over the skin: over the radius as in Contacts.
constexpr double inner_skin = 0.18;

const TravellingContact* contact_with(const std::vector<TravellingContact>& contacts, std::int64_t partner) {
  const auto found = std::ranges::find(contacts, static_cast<double>(partner), &TravellingContact::partner);
  return found == contacts.end() ? nullptr : &*found;
}

SavedContact saved(const double* history) {
  SavedContact contact{.key = {sphere_primitive(0), sphere_primitive(0)}};
  std::copy_n(history, contact_history_size, contact.history);
  return contact;
}

TravellingContact travelling(std::int64_t partner, const double* history) {
  TravellingContact contact{static_cast<double>(partner), {}};
  std::copy_n(history, contact_history_size, contact.history);
  return contact;
}

}  // namespace

RankContacts::RankContacts(const Plan& plan, InstructionSet set)
    : plan_(plan),
      law_(law_of(plan.domain.contacts)),
      kernel_(law_.kernel({plan.contact_kinds == 1, false, plan.rolls, false}, set)),
      walls_(plan.domain.walls),
      records_(walls_.size()),
      wall_loads_(6 * walls_.size(), 0.0),
      wall_paths_(walls_.size(), 0.0),
      near_(walls_.size()) {
  for (const Wall& wall : walls_) shapes_.push_back(shape_index(law_, wall));
}

void RankContacts::each(const UseContact& use) const {
  const auto history = [&](std::int32_t number) {
    return histories_.rows.data() + static_cast<std::ptrdiff_t>(number) * contact_history_size;
  };
  for (std::int32_t p = 0; p < pairs_; ++p) {
    if (contact_[p] != 0) use(first_[p], second_[p], history(contact_[p]));
  }
  for (std::size_t w = 0; w < near_.size(); ++w) {
    for (std::size_t n = 0; n < near_[w].count; ++n) {
      if (near_[w].contact[n] != 0)
        use(near_[w].slots[n], -1 - static_cast<std::int64_t>(w), history(near_[w].contact[n]));
    }
  }
}

void RankContacts::unlist(Rows& rows, int own, const std::function<std::int64_t(int)>& number) {
  if (!listed_) return;
  for (int i = 0; i < own; ++i) rows.contacts[i].clear();
  each([&](std::int32_t first, std::int64_t second, const double* history) {
    if (second < 0) {
      rows.contacts[first].push_back(travelling(second, history));
      return;
    }
    rows.contacts[first].push_back(travelling(number(static_cast<int>(second)), history));
    if (second >= own) return;  // its own rank has it, too
    TravellingContact other = travelling(number(first), history);
    law_.exchange_bodies(other.history);
    rows.contacts[second].push_back(other);
  });
  listed_ = false;
}

void RankContacts::list(Rows& rows, int own, int all, const std::vector<SlotPair>& pairs, double time,
                        const std::function<std::int64_t(int)>& number) {
  histories_.reset();
  const auto begin_from = [&](int slot, std::int64_t partner) -> std::int32_t {
    const TravellingContact* contact = contact_with(rows.contacts[slot], partner);
    if (contact == nullptr) return 0;
    histories_.reserve(1);
    const std::int32_t at = histories_.take();
    histories_.put(at, saved(contact->history));
    return at;
  };
  pairs_ = static_cast<std::int32_t>(pairs.size());
  const std::size_t padded = whole_vectors(pairs.size(), kernel_.width);
  first_.assign(padded, all), second_.assign(padded, all + 1), contact_.assign(padded, 0);
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    first_[p] = pairs[p].first, second_[p] = pairs[p].second;
    if (!rows.contacts[pairs[p].first].empty())
      contact_[p] = begin_from(pairs[p].first, number(pairs[p].second));
  }
  std::fill(wall_paths_.begin(), wall_paths_.end(), 0.0);
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    WallNeighbors& near = near_[w];
    near.slots.clear(), near.contact.clear();
    const WallShape shape = walls_[w].shape.moved(pose_at(walls_[w], time));
    for (int i = 0; i < own; ++i) {
      const double* x = rows.position_of(i);
      const Vec<double, 3> place{x[0], x[1], x[2]};
      if (shape.nearest(place).distance >= x[radius_offset] + plan_.skin + plan_.law_reach) continue;
      near.slots.push_back(i);
      near.contact.push_back(rows.contacts[i].empty() ? 0 : begin_from(i, -1 - static_cast<std::int64_t>(w)));
    }
    near.count = near.slots.size();
    near.slots.resize(whole_vectors(near.count, kernel_.width), all + 2);
    near.contact.resize(near.slots.size(), 0);
  }
  for (int i = 0; i < own; ++i) rows.contacts[i].clear();
  inner_.stale = true;
  listed_ = true;
}

double RankContacts::inner_cutoff() const { return plan_.law_reach + inner_skin * plan_.skin; }

void RankContacts::add_path(double path) {
  inner_.displacement_since += 2 * path;
  inner_.stale = inner_.stale || !(inner_.displacement_since < (1 - 1e-9) * inner_skin * plan_.skin);
}

ContactView RankContacts::view(Rows& rows) {
  ContactView view{};
  view.position_radius = rows.position_radius.data();
  view.velocity_spin = rows.velocity_spin.data();
  view.kind = rows.kind.data();
  view.radius = plan_.groups.front().radius;
  view.first = first_.data();
  view.second = second_.data();
  view.contact = contact_.data();
  view.histories = histories_.rows.data();
  view.work = histories_.work.data();
  view.parameters = plan_.pair_parameters.data();
  view.kinds = plan_.contact_kinds;
  view.step = plan_.step;
  view.reach = plan_.law_reach;
  return view;
}

void RankContacts::find_near_slots(int all) {
  is_near_.assign(static_cast<std::size_t>(all + Rows::pads), 0);
  for (std::int32_t n = 0; n < inner_.count; ++n) is_near_[inner_.first[n]] = is_near_[inner_.second[n]] = 1;
  for (const WallNeighbors& near : near_) {
    for (std::size_t n = 0; n < near.count; ++n) is_near_[near.slots[n]] = 1;
  }
  near_slots_.clear();
  for (std::int32_t i = 0; i < all; ++i) {
    if (is_near_[i] != 0) near_slots_.push_back(i);
  }
}

void RankContacts::find_loaded(int touching) {
  for (const std::int32_t slot : loaded_) is_loaded_[slot] = 0;
  loaded_.clear();
  const auto add = [&](std::int32_t slot) {
    if (is_loaded_[slot] == 0) loaded_.push_back(slot);
    is_loaded_[slot] = 1;
  };
  for (int n = 0; n < touching; ++n) add(inner_.first[touching_[n]]), add(inner_.second[touching_[n]]);
  for (const WallNeighbors& near : near_) {
    for (std::size_t n = 0; n < near.count; ++n) {
      if (near.contact[n] != 0) add(near.slots[n]);
    }
  }
}

void RankContacts::prune(Rows& rows, int all) {
  loaded_.clear(), is_loaded_.assign(static_cast<std::size_t>(all + Rows::pads), 0);
  // pads: a pair too far apart to touch, and a sphere far from every wall
  for (int n = 0; n < Rows::pads; ++n) std::fill_n(rows.position_of(all + n), position_radius_size, 0.0);
  for (int c = 0; c < 3; ++c) rows.position_of(all + 1)[c] = 1e6 * plan_.largest_radius();
  rows.position_of(all + 2)[radius_offset] = -std::numeric_limits<double>::max();
  std::fill_n(rows.load.data(), static_cast<std::size_t>(all) * load_size, 0.0);
  inner_.prune(view(rows), static_cast<std::int32_t>(first_.size()), inner_cutoff(), kernel_, all);
  const std::size_t touching = static_cast<std::size_t>(inner_.count) + lanes_beyond;
  if (touching_.size() < touching) touching_.resize(touching);
  find_near_slots(all);
}

void RankContacts::touch_walls(const ContactView& contacts, double time, ContactTask& task) {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    double* load = wall_loads_.data() + 6 * w;
    std::fill_n(load, 6, 0.0);
    if (!is_active(walls_[w], time)) continue;
    std::fill_n(task.wall_force, 3, 0.0), std::fill_n(task.wall_moment, 3, 0.0);
    const double* parameters = plan_.wall_parameters.data() +
                               w * static_cast<std::size_t>(plan_.contact_kinds) * law_.parameters_size;
    kernel_.wall(contacts, wall_view_at(walls_[w], shapes_[w], near_[w], parameters, time, plan_.step), task);
    for (int c = 0; c < 3; ++c) load[c] = task.wall_force[c], load[3 + c] = task.wall_moment[c];
  }
}

void RankContacts::work_out(Rows& rows, int all, double time) {
  std::size_t most = static_cast<std::size_t>(inner_.count);
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    most += near_[w].count;
    if (is_active(walls_[w], time)) continue;
    for (std::int32_t& contact : near_[w].contact) {
      if (contact != 0) histories_.give_back(contact), contact = 0;
    }
  }
  histories_.reserve(most);
  for (const std::int32_t slot : loaded_) std::fill_n(rows.load_of(slot), load_size, 0.0);
  const ContactView contacts = view(rows);
  ContactTask task{.inner = inner_.view(),
                   .inner_count = inner_.count,
                   .slots_begin = 0,
                   .slots_end = all + Rows::pads,
                   .loads = rows.load.data(),
                   .touching = touching_.data(),
                   .free = histories_.free.data(),
                   .free_count = histories_.free_count,
                   .halo = nullptr,
                   .halo_count = 0,
                   .contacts = 0,
                   .account = {},
                   .power = {},
                   .wall_force = {},
                   .wall_moment = {},
                   .deepest = deepest_};
  kernel_.pairs(contacts, task);
  const auto touching = static_cast<int>(task.contacts);
  touch_walls(contacts, time, task);
  histories_.free_count = task.free_count;
  deepest_ = task.deepest;
  find_loaded(touching);
}

void RankContacts::end_forces(const std::vector<double>& loads_of_all, double time) {
  const double step = plan_.step;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    Wall& wall = walls_[w];
    const double* load = loads_of_all.data() + 6 * w;
    end_step(wall, records_[w], {{load[0], load[1], load[2]}, {load[3], load[4], load[5]}}, time, step);
    if (is_at_rest(wall)) continue;
    const WallVelocity after = velocity_at(wall, time + 0.5 * step);
    const double turning = turns_visibly(wall) ? norm(after.spin) * (turn_reach_ + plan_.skin) : 0;
    wall_paths_[w] += step * (norm(after.velocity) + turning);
  }
}

void RankContacts::move_walls() { move_driven(walls_, plan_.step); }

/// Spheres may go half of the skin, too, before lists are made anew; one step more is left.
bool RankContacts::walls_moved_far() const {
  return std::ranges::any_of(wall_paths_, [&](double path) { return path > 0.4 * plan_.skin; });
}

std::vector<double> RankContacts::wall_records() const { return record_numbers(records_, walls_); }

void RankContacts::set_wall_records(const std::vector<double>& records) {
  set_record_numbers(records.data(), records_, walls_);
}

}  // namespace fiberchain::dem::mpi
