#include "dem/assembly/contact_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dem/assembly/contact_parameters.hpp"
#include "dem/contact/lanes/tables.hpp"

namespace fiberchain::dem {
namespace {

/// Fixed, so that sums are the same for any number of threads.
constexpr int kStripes = 16;

/// Gap up to which a pair is listed, in radii: wide lists are read every step, narrow ones made often.
constexpr double kSkin = 0.35;

std::int32_t whole_vectors(std::size_t count, int width) {
  return static_cast<std::int32_t>((count + width - 1) / width * width);
}

void add_times(ContactBook<double>& sum, double factor, const ContactBook<double>& more) {
  sum.normal_dashpot += factor * more.normal_dashpot;
  sum.sliding += factor * more.sliding;
  sum.rolling += factor * more.rolling;
}

bool before(const KeptContact& x, const KeptContact& y) {
  return std::pair(x.first, x.second) < std::pair(y.first, y.second);
}

}  // namespace

ContactSet::ContactSet(const Surroundings& surroundings, const AssemblyOptions& options, double step)
    : surroundings_(surroundings), booked_(options.book_energy), instruction_set_(options.instruction_set), step_(step), stripes_(kStripes) {
  for (Stripe& stripe : stripes_) {
    stripe.walls.resize(surroundings.walls.size());
    stripe.memory.booked = booked_;
    for (NearWall& near : stripe.walls) near.memory.booked = booked_;
  }
}

int ContactSet::kind_of(const ContactBody& body) {
  const auto found = std::ranges::find(bodies_, body);
  if (found == bodies_.end()) {
    bodies_.push_back(body);
    return static_cast<int>(bodies_.size()) - 1;
  }
  return static_cast<int>(found - bodies_.begin());
}

void ContactSet::add(const Fiber& fiber, int count) {
  const int kind = kind_of(sphere_body(fiber)), n = fiber.aspect_ratio + 1;
  std::int32_t number = fiber_.empty() ? 0 : fiber_.back() + 1;
  for (int f = 0; f < count; ++f, ++number) {
    fiber_.insert(fiber_.end(), n, number);
    radius_.insert(radius_.end(), n, bodies_[kind].radius);
  }
  kind_of_sphere_.resize(fiber_.size() - static_cast<std::size_t>(n) * count);
  kind_of_sphere_.resize(fiber_.size(), kind);
}

void ContactSet::pad(SphereRows& rows) {
  pair_parameters_.clear();
  wall_parameters_.clear();
  const ContactBody wall = wall_body(surroundings_);
  for (const ContactBody& body : bodies_) {
    for (const ContactBody& other : bodies_) {
      pair_parameters_.push_back(contact_parameters(body, other, surroundings_.contacts, step_));
    }
    wall_parameters_.push_back(contact_parameters(body, wall, surroundings_.contacts, step_));
  }
  skin_ = kSkin * *std::ranges::min_element(radius_);
  const bool periodic = std::ranges::any_of(surroundings_.period.c, [](double p) { return p > 0; });
  kernel_ = &contact_kernel({bodies_.size() == 1, periodic, surroundings_.contacts.rolling_friction > 0, booked_},
                            instruction_set_);
  const std::int64_t n = spheres();
  stripe_begin_.clear();
  for (int k = 0; k <= kStripes; ++k) stripe_begin_.push_back(static_cast<std::int32_t>(n * k / kStripes));
  // two of no size far from each other, one that no wall is near to
  double* behind = rows.position.data() + n * position_numbers;
  for (int c = 0; c < 3; ++c) {
    const double period = surroundings_.period[c];
    behind[position_numbers + c] = period > 0 ? 0.5 * period : 1e6 * radius_[0];
  }
  behind[2 * position_numbers + 3] = -std::numeric_limits<double>::max();
  kind_of_sphere_.resize(n + SphereRows::pads, 0);
}

void ContactMemory::reset(std::size_t size) {
  touched.assign(size, 0);
  if (rows.size() < size * memory_numbers + row_overhang) rows = LaneArray(2 * size * memory_numbers + row_overhang);
  if (booked && work.size() < size * work_numbers) work = LaneArray(2 * size * work_numbers);
}

KeptContact ContactMemory::at(std::size_t i, std::int64_t first, std::int64_t second) const {
  const double* n = rows.data() + i * memory_numbers;
  KeptContact contact{first, second, {n[0], n[1], n[2]}, n[3], n[4]};
  if (booked) std::copy_n(work.data() + i * work_numbers, work_numbers, contact.work);
  return contact;
}

void ContactMemory::put(std::size_t i, const KeptContact& c) {
  double* n = rows.data() + i * memory_numbers;
  for (int k = 0; k < 3; ++k) n[k] = c.spring[k];
  n[3] = c.overlap, n[4] = c.opening;
  if (booked) std::copy_n(c.work, work_numbers, work.data() + i * work_numbers);
  touched[i] = 1;
}

void ContactSet::list_pairs(const SphereRows& rows, double time, Team& team) {
  std::vector<Vec<double, 3>> places(spheres());
  team.each(kStripes, [&](int k, int) {
    for (std::int32_t i = stripe_begin_[k]; i < stripe_begin_[k + 1]; ++i) places[i] = rows.place(i);
  });
  list_pairs(std::move(places), time, team);
}

void ContactSet::list_pairs(std::vector<Vec<double, 3>> positions, double time, Team& team) {
  const std::vector<KeptContact> contacts = listed_at_.empty() ? std::vector<KeptContact>{} : kept();
  listed_at_ = std::move(positions);
  listed_time_ = time;
  const CloseSearch search({listed_at_, radius_, fiber_, surroundings_.period}, skin_, *kernel_);
  pairs_.resize(kStripes);
  team.each(kStripes, [&](int k, int) {
    pairs_[k] = search.pairs(stripe_begin_[k], stripe_begin_[k + 1]);
    fill_stripe(k);
    list_walls(k);
    remember(k, contacts);
  });
}

void ContactSet::fill_stripe(int k) {
  Stripe& stripe = stripes_[k];
  const auto dummy = static_cast<std::int32_t>(spheres());
  const std::vector<ClosePair>& pairs = pairs_[k];
  const std::int32_t padded = whole_vectors(pairs.size(), kernel_->width);
  stripe.first.assign(padded, dummy);
  stripe.second.assign(padded, dummy + 1);
  stripe.touching.resize(padded);
  std::size_t leaving = 0;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    stripe.first[p] = pairs[p].first;
    stripe.second[p] = pairs[p].second;
    leaving += pairs[p].second >= stripe_begin_[k + 1];
  }
  stripe.deferred.resize(leaving);
  stripe.for_stripe.resize(kStripes);
  stripe.memory.reset(padded);
}

void ContactSet::list_walls(int k) {
  for (std::size_t w = 0; w < surroundings_.walls.size(); ++w) {
    const Wall& wall = surroundings_.walls[w];
    NearWall& near = stripes_[k].walls[w];
    near.slots.clear();
    for (std::int32_t i = stripe_begin_[k]; i < stripe_begin_[k + 1]; ++i) {
      if (gap_to(wall, listed_at_[i], listed_time_) < radius_[i] + skin_) {
        near.slots.push_back(i);
      }
    }
    near.slots.resize(whole_vectors(near.slots.size(), kernel_->width), static_cast<std::int32_t>(spheres() + 2));
    near.memory.reset(near.slots.size());
  }
}

double ContactSet::farthest_moved(const SphereRows& rows, Team& team) const {
  std::vector<double> squared(kStripes, 0);
  team.each(kStripes, [&](int k, int) {
    double farthest = 0;
    for (std::int32_t i = stripe_begin_[k]; i < stripe_begin_[k + 1]; ++i) {
      const Vec<double, 3> moved = rows.place(i) - listed_at_[i];
      farthest = std::max(farthest, dot(moved, moved));
    }
    squared[k] = farthest;
  });
  return std::sqrt(*std::ranges::max_element(squared));
}

bool ContactSet::walls_moved_far(double time) const {
  return std::ranges::any_of(surroundings_.walls, [&](const Wall& wall) {
    return norm(wall.velocity) * (time - listed_time_) > 0.5 * skin_;
  });
}

ContactView ContactSet::view(Stripe& stripe, SphereRows& rows) {
  ContactView view{};
  view.position = rows.position.data();
  view.motion = rows.motion.data();
  view.force = rows.load.data();
  view.kind = kind_of_sphere_.data();
  view.first = stripe.first.data();
  view.second = stripe.second.data();
  for (int c = 0; c < 3; ++c) {
    view.period[c] = surroundings_.period[c];
    view.inverse_period[c] = view.period[c] > 0 ? 1 / view.period[c] : 0;
  }
  view.memory = stripe.memory.rows.data();
  view.touched = stripe.memory.touched.data();
  view.work = stripe.memory.work.data();
  view.parameters = pair_parameters_.data();
  view.kinds = static_cast<std::int32_t>(bodies_.size());
  view.step = step_;
  return view;
}

WallView ContactSet::wall_view(int w, NearWall& near, double time) const {
  const Wall& wall = surroundings_.walls[w];
  WallView view{};
  Vec<double, 3> point, direction;
  if (const auto* plane = std::get_if<Plane>(&wall.shape)) {
    point = plane->point, direction = plane->normal;
  } else {
    const auto& cylinder = std::get<Cylinder>(wall.shape);
    point = cylinder.point, direction = cylinder.axis;
    view.cylinder = true;
    view.radius = cylinder.radius;
  }
  for (int c = 0; c < 3; ++c) {
    view.point[c] = point[c] + time * wall.velocity[c];
    view.direction[c] = direction[c];
    view.velocity[c] = wall.velocity[c];
  }
  view.slots = near.slots.data();
  view.begin = 0;
  view.end = static_cast<std::int32_t>(near.slots.size());
  view.memory = near.memory.rows.data();
  view.touched = near.memory.touched.data();
  view.work = near.memory.work.data();
  view.parameters = wall_parameters_.data();
  return view;
}

void ContactSet::work_out(int k, SphereRows& rows, double time) {
  Stripe& stripe = stripes_[k];
  const std::int32_t end = stripe_begin_[k + 1];
  const ContactView contacts = view(stripe, rows);
  ContactTask task{0, static_cast<std::int32_t>(stripe.first.size()), end, stripe.touching.data(), stripe.deferred.data(),
                   0, 0, stripe.book, {}, 0, 0};
  kernel_->pairs(contacts, task);
  for (std::size_t w = 0; w < stripe.walls.size(); ++w) {
    NearWall& near = stripe.walls[w];
    if (near.slots.empty()) continue;
    if (is_there(surroundings_.walls[w], time)) {
      kernel_->wall(contacts, wall_view(static_cast<int>(w), near, time), task);
    } else {
      drop(near, static_cast<int>(w), stripe);
    }
  }
  for (auto& entries : stripe.for_stripe) entries.clear();
  for (std::int32_t n = 0; n < task.deferred_count; ++n) {
    const auto target = std::ranges::upper_bound(stripe_begin_, stripe.deferred[n].slot) - stripe_begin_.begin() - 1;
    stripe.for_stripe[target].push_back(n);
  }
  stripe.contacts = task.contacts;
  stripe.book = task.book, stripe.power = task.power;
  stripe.wall_work += task.wall_work, stripe.wall_power = task.wall_power;
}

void ContactSet::gather_loads(int k, SphereRows& rows) {
  for (int from = 0; from < k; ++from) {
    const Stripe& other = stripes_[from];
    for (const std::int32_t n : other.for_stripe[k]) {
      const DeferredForce& later = other.deferred[n];
      double* load = rows.load.data() + later.slot * load_numbers;
      for (int c = 0; c < 6; ++c) load[c] += later.load[c];
    }
  }
}

std::int64_t ContactSet::touching() const {
  std::int64_t sum = 0;
  for (const Stripe& stripe : stripes_) sum += stripe.contacts;
  return sum;
}

ContactBook<double> ContactSet::taken() const {
  const double half = 0.5 * step_;
  ContactBook<double> sum{};
  for (const Stripe& s : stripes_) {
    add_times(sum, 1, s.book);
    add_times(sum, -half, s.power);
  }
  return sum;
}

double ContactSet::wall_work() const {
  double sum = 0;
  for (const Stripe& s : stripes_) sum += s.wall_work - 0.5 * step_ * s.wall_power;
  return sum;
}

void ContactSet::begin_books() {
  const double half = 0.5 * step_;
  for (Stripe& s : stripes_) {
    add_times(s.book, -half, s.power);
    s.wall_work -= half * s.wall_power;
  }
}

double ContactSet::energy_of(const KeptContact& c) const {
  const int kind = kind_of_sphere_[c.first];
  const ContactParameters<double>& p =
      c.second < 0 ? wall_parameters_[kind] : pair_parameters_[kind * bodies_.size() + kind_of_sphere_[c.second]];
  const double root = std::sqrt(c.overlap);
  double energy = 0.4 * p.normal * c.overlap * c.overlap * root;
  for (const double spring : c.spring) {
    if (p.tangential > 0) energy += 0.5 * spring * spring / (p.tangential * root);
  }
  return energy;
}

double ContactSet::stored_energy() const {
  double sum = 0;
  for (const KeptContact& c : kept()) sum += energy_of(c);
  return sum;
}

void ContactSet::drop(NearWall& near, int wall, Stripe& stripe) const {
  for (std::size_t n = 0; n < near.slots.size() && booked_; ++n) {
    if (near.memory.touched[n] != 0) stripe.wall_work -= energy_of(near.memory.at(n, near.slots[n], -1 - wall));
  }
  near.memory.reset(near.slots.size());
}

std::vector<double> ContactSet::sums() const {
  std::vector<double> all;
  for (const Stripe& s : stripes_) {
    all.insert(all.end(), {static_cast<double>(s.contacts), s.book.normal_dashpot, s.book.sliding, s.book.rolling, s.wall_work,
                           s.power.normal_dashpot, s.power.sliding, s.power.rolling, s.wall_power});
  }
  return all;
}

void ContactSet::set_sums(const double* from) {
  for (Stripe& s : stripes_) {
    s.contacts = static_cast<std::int64_t>(from[0]);
    s.book = {from[1], from[2], from[3]};
    s.wall_work = from[4];
    s.power = {from[5], from[6], from[7]};
    s.wall_power = from[8];
    from += sums_a_stripe;
  }
}

std::vector<ContactState> ContactSet::states(const SphereRows& rows, double time) const {
  std::vector<ContactState> all;
  const auto at = [](const LaneArray& numbers, std::int64_t i) {
    return Vec<double, 3>{numbers.data()[i], numbers.data()[i + 1], numbers.data()[i + 2]};
  };
  for (const KeptContact& c : kept()) {
    const Vec<double, 3> x = at(rows.position, c.first * position_numbers);
    const Vec<double, 3> v = at(rows.motion, c.first * motion_numbers), w = at(rows.motion, c.first * motion_numbers + 3);
    const int kind = kind_of_sphere_[c.first];
    Vec<double, 3> other_velocity{}, other_spin{};
    TouchingPair<double> pair{};
    double arm, other_arm = 0;
    const ContactParameters<double>* p = &wall_parameters_[kind];
    if (c.second < 0) {
      const Wall& wall = surroundings_.walls[-1 - c.second];
      pair.normal = direction_to(wall, x, time);
      arm = gap_to(wall, x, time);
      other_velocity = wall.velocity;
    } else {
      Vec<double, 3> r = at(rows.position, c.second * position_numbers) - x;
      for (int k = 0; k < 3; ++k) {
        const double period = surroundings_.period[k];
        if (period > 0) r[k] -= period * std::nearbyint(r[k] / period);
      }
      pair.normal = (1 / norm(r)) * r;
      arm = norm(r) * radius_[c.first] / (radius_[c.first] + radius_[c.second]);
      other_arm = norm(r) - arm;
      other_velocity = at(rows.motion, c.second * motion_numbers);
      other_spin = at(rows.motion, c.second * motion_numbers + 3);
      p = &pair_parameters_[kind * bodies_.size() + kind_of_sphere_[c.second]];
    }
    pair.overlap = c.overlap;
    pair.velocity = other_velocity - v - cross(arm * w + other_arm * other_spin, pair.normal);
    pair.spin = other_spin - w;
    ContactHistory<double> history{{c.spring[0], c.spring[1], c.spring[2]}, c.overlap, c.opening};
    const ContactAction<double> action = contact_action(*p, pair, 0.0, history);
    all.push_back({c.first, c.second, c.overlap, x + arm * pair.normal, action.force});
  }
  return all;
}

std::vector<KeptContact> ContactSet::kept_in(int k) const {
  const Stripe& stripe = stripes_[k];
  std::vector<KeptContact> own;
  for (std::size_t p = 0; p < pairs_[k].size(); ++p) {
    if (stripe.memory.touched[p] != 0) own.push_back(stripe.memory.at(p, stripe.first[p], stripe.second[p]));
  }
  for (std::size_t w = 0; w < stripe.walls.size(); ++w) {
    const NearWall& near = stripe.walls[w];
    for (std::size_t n = 0; n < near.slots.size() && near.slots[n] < spheres(); ++n) {
      if (near.memory.touched[n] != 0) own.push_back(near.memory.at(n, near.slots[n], -1 - static_cast<std::int64_t>(w)));
    }
  }
  std::ranges::sort(own, before);
  return own;
}

std::vector<KeptContact> ContactSet::kept() const {
  std::vector<std::vector<KeptContact>> of_stripes(kStripes);
  for (int k = 0; k < kStripes; ++k) of_stripes[k] = kept_in(k);
  std::vector<KeptContact> all;
  for (const auto& own : of_stripes) all.insert(all.end(), own.begin(), own.end());
  return all;
}

void ContactSet::forget() {
  for (Stripe& stripe : stripes_) {
    stripe.memory.reset(stripe.first.size());
    for (NearWall& near : stripe.walls) near.memory.reset(near.slots.size());
  }
}

/// Both the contacts and the pairs are in order.
void ContactSet::remember(int k, const std::vector<KeptContact>& contacts) {
  Stripe& stripe = stripes_[k];
  const auto pairs = static_cast<std::size_t>(pairs_[k].size());
  std::size_t p = 0;
  std::vector<std::size_t> at_wall(stripe.walls.size(), 0);
  const auto first_of = [](const KeptContact& c) { return c.first; };
  auto contact = std::ranges::lower_bound(contacts, stripe_begin_[k], {}, first_of);
  for (; contact != contacts.end() && contact->first < stripe_begin_[k + 1]; ++contact) {
    if (contact->second >= 0) {
      while (p < pairs && std::pair<std::int64_t, std::int64_t>(stripe.first[p], stripe.second[p]) <
                              std::pair(contact->first, contact->second)) {
        ++p;
      }
      if (p < pairs && stripe.first[p] == contact->first && stripe.second[p] == contact->second) stripe.memory.put(p, *contact);
    } else {
      const auto wall = static_cast<std::size_t>(-1 - contact->second);
      NearWall& near = stripe.walls[wall];
      std::size_t& n = at_wall[wall];
      while (n < near.slots.size() && near.slots[n] < contact->first) ++n;
      if (n < near.slots.size() && near.slots[n] == contact->first) near.memory.put(n, *contact);
    }
  }
}

void ContactSet::remember(const std::vector<KeptContact>& contacts) {
  for (int k = 0; k < kStripes; ++k) remember(k, contacts);
}

}  // namespace fiberchain::dem
