#include "dem/contact/contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fiberchain::dem {
namespace {

/// Gap up to which a pair is rebuilt, in radii: wide lists are long, narrow ones searched for often.
constexpr double kSkin = 0.6;

void add_times(ContactAccount<double>& sum, double factor, const ContactAccount<double>& more) {
  sum.normal_dashpot += factor * more.normal_dashpot;
  sum.sliding += factor * more.sliding;
  sum.rolling += factor * more.rolling;
}

}  // namespace

Contacts::Contacts(const Domain& domain, const ContactOptions& options, double step)
    : domain_(domain),
      law_(law_of(domain.contacts)),
      periods_(periodic_box(domain.period)),
      accounted_(options.account_energy),
      instruction_set_(options.instruction_set),
      step_(step) {
  check(domain.contacts);
  for (const Wall& wall : domain.walls) shapes_.push_back(shape_index(law_, wall));
}

double Contacts::law_reach(const std::vector<ContactBody>& bodies) const {
  double reach = 0;
  for (const ContactBody& body : bodies) {
    for (const ContactBody& other : bodies)
      reach = std::max(reach, law_.reach(effective_body(body, other), domain_.contacts));
    reach = std::max(reach, law_.reach(effective_body(body, wall_body(domain_)), domain_.contacts));
  }
  return reach;
}

void Contacts::check_periods(const std::vector<FiberGroup>& more) const {
  std::vector<ContactBody> bodies = bodies_;
  for (const FiberGroup& group : more) bodies.push_back(sphere_body(group.chain.fiber));
  const auto [least, largest] = std::ranges::minmax(bodies, {}, &ContactBody::radius);
  dem::check_periods(domain_.period, 2 * largest.radius + kSkin * least.radius + law_reach(bodies));
}

int Contacts::kind_of(const ContactBody& body) {
  const auto found = std::ranges::find(bodies_, body);
  if (found == bodies_.end()) {
    bodies_.push_back(body);
    return static_cast<int>(bodies_.size()) - 1;
  }
  return static_cast<int>(found - bodies_.begin());
}

void Contacts::add(const Fiber& fiber, int count) {
  const int kind = kind_of(sphere_body(fiber)), n = fiber.aspect_ratio + 1;
  std::int32_t number = fiber_.empty() ? 0 : fiber_.back() + 1;
  for (int f = 0; f < count; ++f, ++number) {
    fiber_.insert(fiber_.end(), n, number);
    radius_.insert(radius_.end(), n, bodies_[kind].radius);
  }
  kind_of_sphere_.resize(fiber_.size() - static_cast<std::size_t>(n) * count);
  kind_of_sphere_.resize(fiber_.size(), kind);
}

void Contacts::cut(int parts) {
  Part sum;
  for (const Part& s : parts_) {
    sum.contacts += s.contacts;
    add_times(sum.account, 1, s.account);
    add_times(sum.power, 1, s.power);
    sum.wall_work += s.wall_work;
    sum.wall_power += s.wall_power;
  }
  parts_ = std::vector<Part>(parts);
  for (Part& part : parts_) {
    part.walls.resize(domain_.walls.size());
    part.halo_of_part.resize(parts);
    part.histories.accounted = accounted_;
  }
  Part& first = parts_[0];
  first.contacts = sum.contacts;
  first.account = sum.account, first.power = sum.power;
  first.wall_work = sum.wall_work, first.wall_power = sum.wall_power;
}

void Contacts::pad(SphereStorage& rows) const {
  // two of no size far from each other, one that no wall is near to
  const std::int64_t n = spheres();
  for (int c = 0; c < 3; ++c) {
    const double period = domain_.period[c];
    rows.position_row(n + 1)[c] = period > 0 ? 0.5 * period : 1e6 * radius_[0];
  }
  rows.position_row(n + 2)[radius_offset] = -std::numeric_limits<double>::max();
}

void Contacts::set_parameters() {
  pair_parameters_.clear();
  wall_parameters_.clear();
  const auto append = [&](std::vector<double>& table, const ContactBody& body, const ContactBody& other) {
    table.resize(table.size() + law_.parameters_size);
    law_.parameters(effective_body(body, other), domain_.contacts, step_,
                    &*table.end() - law_.parameters_size);
  };
  for (const ContactBody& body : bodies_) {
    for (const ContactBody& other : bodies_) append(pair_parameters_, body, other);
    append(wall_parameters_, body, wall_body(domain_));
  }
  law_reach_ = law_reach(bodies_);
  skin_ = kSkin * *std::ranges::min_element(radius_);
}

void Contacts::begin(SphereStorage& rows, Partition parts, double time, ThreadPool& pool) {
  const std::vector<SavedContact> contacts = saved();
  set_parameters();
  const bool periodic = std::ranges::any_of(domain_.period.c, [](double p) { return p > 0; });
  kernel_ = &law_.kernel({bodies_.size() == 1, periodic, domain_.contacts.rolling_friction > 0, accounted_},
                         instruction_set_);
  cut(parts.count());
  close_ = NeighborList({radius_, fiber_, domain_.period}, skin_ + law_reach_, std::move(parts), *kernel_);
  kind_of_sphere_.resize(spheres() + SphereStorage::pads, 0);
  pad(rows);
  rebuild_neighbor_list(rows, time, pool);
  restore(contacts);
}

std::size_t Contacts::may_begin(const Part& part) const {
  std::size_t sum = part.near.count;
  for (const WallNeighbors& near : part.walls) sum += near.count;
  return sum;
}

ContactView Contacts::view(Part& part, const SphereStorage& rows) {
  ContactView view{};
  view.position_radius = rows.position_radius.data();
  view.motions = rows.motions.data();
  view.kind = kind_of_sphere_.data();
  view.radius = radius_[0];
  view.first = part.pairs.first.data();
  view.second = part.pairs.second.data();
  view.periods = periods_;
  view.contact = part.pairs.contact.data();
  view.histories = part.histories.rows.data();
  view.work = part.histories.work.data();
  view.parameters = pair_parameters_.data();
  view.kinds = static_cast<std::int32_t>(bodies_.size());
  view.step = step_;
  view.reach = law_reach_;
  return view;
}

WallView Contacts::wall_view(int w, WallNeighbors& near, double time) const {
  const Wall& wall = domain_.walls[w];
  WallView view{};
  wall.shape.numbers(time * wall.velocity, view.shape);
  for (int c = 0; c < 3; ++c) view.velocity[c] = wall.velocity[c];
  view.slots = near.slots.data();
  view.count = static_cast<std::int32_t>(near.slots.size());
  view.contact = near.contact.data();
  view.parameters = wall_parameters_.data();
  return view;
}

void Contacts::work_out(int k, const SphereStorage& rows, double time, LoadRange loads) {
  Part& part = parts_[k];
  const std::int32_t begin = parts().begin(k), end = parts().end(k);
  if (part.near.stale) prune(part, end, rows);
  for (std::size_t w = 0; w < part.walls.size(); ++w) {
    if (!is_active(domain_.walls[w], time)) drop(part.walls[w], static_cast<int>(w), part);
  }
  part.histories.reserve(may_begin(part));
  const double time_before = (std::round(time / step_) - 1) * step_;  // to the bit, as the step before had it
  const ContactView contacts = view(part, rows);
  ContactTask task{part.near.view(),
                   part.near.count,
                   begin,
                   end,
                   loads.rows,
                   part.touching.data(),
                   part.histories.free.data(),
                   part.histories.free_count,
                   part.halo.data(),
                   0,
                   0,
                   part.account,
                   {},
                   0,
                   0,
                   part.deepest};
  kernel_->pairs(contacts, task);
  for (std::size_t w = 0; w < part.walls.size(); ++w) {
    if (!is_active(domain_.walls[w], time)) continue;
    kernel_->walls[shapes_[w]](contacts, wall_view(static_cast<int>(w), part.walls[w], time), task);
    if (accounted_ && time > 0 && !is_active(domain_.walls[w], time_before))
      task.wall_work += brought_by(part.walls[w], part);
  }
  part.histories.free_count = task.free_count;
  for (int target = k; target <= reach_.last(k); ++target) part.halo_of_part[target].clear();
  for (std::int32_t n = 0; n < task.halo_count; ++n) {
    const int target = parts().of(part.halo[n].slot);
    part.halo_of_part[target].push_back(n);
  }
  part.contacts = task.contacts;
  part.deepest = task.deepest;
  part.account = task.account, part.power = task.power;
  part.wall_work += task.wall_work, part.wall_power = task.wall_power;
}

void Contacts::add_displacements(const std::vector<double>& paths) {
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    InnerPairList& soon = parts_[k].near;
    const auto first = paths.begin() + static_cast<std::ptrdiff_t>(k);
    soon.displacement_since +=
        *first + *std::max_element(first, paths.begin() + reach_.last(static_cast<int>(k)) + 1);
    soon.stale = soon.stale || !(soon.displacement_since < (1 - 1e-9) * (inner_cutoff() - law_reach_));
  }
}

void Contacts::work_out(const SphereStorage& rows, double time, ForceBuffers& loads, ThreadPool& pool) {
  pool.each(parts().count(), [&](int k, int thread) { work_out(k, rows, time, loads.take(k, thread)); });
  pool.each(parts().count(), [&](int k, int) { reduce_halo_forces(k, loads.of(k)); });
}

void Contacts::reduce_halo_forces(int k, LoadRange loads) {
  for (int from = reach_.first_dependency(k); from < k; ++from) {
    if (reach_.last(from) < k) continue;
    const Part& other = parts_[from];
    for (const std::int32_t n : other.halo_of_part[k]) {
      const HaloForce& later = other.halo[n];
      double* load = loads.rows + (later.slot - loads.first) * load_size;
      for (int c = 0; c < 6; ++c) load[c] += later.load[c];
    }
  }
}

double Contacts::deepest() const { return std::ranges::max_element(parts_, {}, &Part::deepest)->deepest; }

std::int64_t Contacts::touching() const {
  std::int64_t sum = 0;
  for (const Part& part : parts_) sum += part.contacts;
  return sum;
}

ContactAccount<double> Contacts::dissipated() const {
  const double half = 0.5 * step_;
  ContactAccount<double> sum{};
  for (const Part& s : parts_) {
    add_times(sum, 1, s.account);
    add_times(sum, -half, s.power);
  }
  return sum;
}

double Contacts::wall_work() const {
  double sum = 0;
  for (const Part& s : parts_) sum += s.wall_work - 0.5 * step_ * s.wall_power;
  return sum;
}

void Contacts::begin_accounts() {
  const double half = 0.5 * step_;
  for (Part& s : parts_) {
    add_times(s.account, -half, s.power);
    s.wall_work -= half * s.wall_power;
  }
}

const double* Contacts::parameters_of(const SavedContact& c) const {
  const std::size_t kind = kind_of_sphere_[c.key.first.number], size = law_.parameters_size;
  if (is_facet(c.key.second)) return wall_parameters_.data() + kind * size;
  return pair_parameters_.data() + (kind * bodies_.size() + kind_of_sphere_[c.key.second.number]) * size;
}

double Contacts::energy_of(const SavedContact& c) const {
  return law_.stored_energy(parameters_of(c), c.history);
}

double Contacts::stored_energy() const {
  double sum = 0;
  for (const SavedContact& c : saved()) sum += energy_of(c);
  return sum;
}

double Contacts::closing_power(const SavedContact& c) const {
  return law_.closing_power(parameters_of(c), c.history);
}

double Contacts::brought_by(const WallNeighbors& near, const Part& part) const {
  double energy = 0;
  for (std::size_t n = 0; n < near.count; ++n) {
    if (near.contact[n] == 0) continue;
    const SavedContact contact =
        part.histories.at(near.contact[n], {sphere_primitive(near.slots[n]), facet_primitive(0)});
    // tangential springs of the first step come out of the motion
    energy +=
        law_.normal_energy(parameters_of(contact), contact.history) - 0.5 * step_ * closing_power(contact);
  }
  return energy;
}

void Contacts::drop(WallNeighbors& near, int wall, Part& part) const {
  for (std::size_t n = 0; n < near.count; ++n) {
    if (near.contact[n] == 0) continue;
    if (accounted_) {
      const SavedContact contact =
          part.histories.at(near.contact[n], {sphere_primitive(near.slots[n]), facet_primitive(wall)});
      part.wall_work -= energy_of(contact) + 0.5 * step_ * closing_power(contact);
    }
    part.histories.give_back(near.contact[n]);
    near.contact[n] = 0;
  }
}

std::vector<double> Contacts::accumulators() const {
  std::vector<double> all;
  for (const Part& s : parts_) {
    all.insert(all.end(), {static_cast<double>(s.contacts), s.account.normal_dashpot, s.account.sliding,
                           s.account.rolling, s.wall_work, s.power.normal_dashpot, s.power.sliding,
                           s.power.rolling, s.wall_power});
  }
  return all;
}

void Contacts::set_accumulators(const double* from) {
  for (Part& s : parts_) {
    s.contacts = static_cast<std::int64_t>(from[0]);
    s.account = {from[1], from[2], from[3]};
    s.wall_work = from[4];
    s.power = {from[5], from[6], from[7]};
    s.wall_power = from[8];
    from += accumulators_per_part;
  }
}

TouchingPair<double> Contacts::pair_at(const SavedContact& c, const SphereStorage& rows, double time,
                                       double& arm) const {
  const std::int64_t first = c.key.first.number, second = c.key.second.number;
  const Vec<double, 3> x = rows.position(first), v = rows.velocity(first), w = rows.spin(first);
  Vec<double, 3> other_velocity{}, other_spin{};
  TouchingPair<double> pair{};
  double other_arm = 0;
  if (is_facet(c.key.second)) {
    const Wall& wall = domain_.walls[second];
    pair.normal = direction_to(wall, x, time);
    arm = gap_to(wall, x, time);
    other_velocity = wall.velocity;
  } else {
    const Vec<double, 3> r = nearest_image(periods_, rows.position(second) - x);
    pair.normal = (1 / norm(r)) * r;
    arm = norm(r) * radius_[first] / (radius_[first] + radius_[second]);
    other_arm = norm(r) - arm;
    other_velocity = rows.velocity(second);
    other_spin = rows.spin(second);
  }
  pair.overlap = law_.overlap(c.history);
  pair.velocity = other_velocity - v - cross(arm * w + other_arm * other_spin, pair.normal);
  pair.spin = other_spin - w;
  return pair;
}

std::vector<ContactState> Contacts::states(const SphereStorage& rows, double time) const {
  std::vector<ContactState> all;
  for (const SavedContact& c : saved()) {
    double arm;
    const TouchingPair<double> pair = pair_at(c, rows, time, arm);
    const ContactAction<double> action = law_.act(parameters_of(c), pair, c.history);
    all.push_back({c.key, pair.overlap, rows.position(c.key.first.number) + arm * pair.normal, action.force});
  }
  return all;
}

}  // namespace fiberchain::dem
