#include "dem/assembly/contact_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dem/assembly/contact_parameters.hpp"
#include "dem/contact/lanes/tables.hpp"

namespace fiberchain::dem {
namespace {

/// Gap up to which a pair is listed, in radii: wide lists are long, narrow ones searched for often.
constexpr double kSkin = 0.6;

void add_times(ContactBook<double>& sum, double factor, const ContactBook<double>& more) {
  sum.normal_dashpot += factor * more.normal_dashpot;
  sum.sliding += factor * more.sliding;
  sum.rolling += factor * more.rolling;
}

}  // namespace

ContactSet::ContactSet(const Surroundings& surroundings, const AssemblyOptions& options, double step)
    : surroundings_(surroundings),
      periods_(periods_of(surroundings.period)),
      booked_(options.book_energy),
      instruction_set_(options.instruction_set),
      step_(step) {}

void ContactSet::check_periods(const std::vector<FiberGroup>& more) const {
  std::vector<double> radius;
  for (const ContactBody& body : bodies_) radius.push_back(body.radius);
  for (const FiberGroup& group : more) radius.push_back(sphere_radius(group.chain.fiber));
  const auto [least, largest] = std::ranges::minmax(radius);
  dem::check_periods(surroundings_.period, 2 * largest + kSkin * least);
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

void ContactSet::cut(int stripes) {
  Stripe sum;
  for (const Stripe& s : stripes_) {
    sum.contacts += s.contacts;
    add_times(sum.book, 1, s.book);
    add_times(sum.power, 1, s.power);
    sum.wall_work += s.wall_work;
    sum.wall_power += s.wall_power;
  }
  stripes_ = std::vector<Stripe>(stripes);
  for (Stripe& stripe : stripes_) {
    stripe.walls.resize(surroundings_.walls.size());
    stripe.for_stripe.resize(stripes);
    stripe.memory.booked = booked_;
  }
  Stripe& first = stripes_[0];
  first.contacts = sum.contacts;
  first.book = sum.book, first.power = sum.power;
  first.wall_work = sum.wall_work, first.wall_power = sum.wall_power;
}

void ContactSet::pad(SphereRows& rows) const {
  // two of no size far from each other, one that no wall is near to
  const std::int64_t n = spheres();
  for (int c = 0; c < 3; ++c) {
    const double period = surroundings_.period[c];
    rows.place_row(n + 1)[c] = period > 0 ? 0.5 * period : 1e6 * radius_[0];
  }
  rows.place_row(n + 2)[place_radius] = -std::numeric_limits<double>::max();
}

void ContactSet::set_parameters() {
  pair_parameters_.clear();
  wall_parameters_.clear();
  const ContactBody wall = wall_body(surroundings_);
  for (const ContactBody& body : bodies_) {
    for (const ContactBody& other : bodies_) {
      pair_parameters_.push_back(contact_parameters(body, other, surroundings_.contacts, step_));
    }
    wall_parameters_.push_back(contact_parameters(body, wall, surroundings_.contacts, step_));
  }
}

void ContactSet::begin(SphereRows& rows, Stripes stripes, double time, Team& team) {
  const std::vector<KeptContact> contacts = kept();
  set_parameters();
  const bool periodic = std::ranges::any_of(surroundings_.period.c, [](double p) { return p > 0; });
  kernel_ = &contact_kernel({bodies_.size() == 1, periodic, surroundings_.contacts.rolling_friction > 0, booked_},
                            instruction_set_);
  cut(stripes.count());
  close_ = CloseList({radius_, fiber_, surroundings_.period}, kSkin * *std::ranges::min_element(radius_), std::move(stripes), *kernel_);
  kind_of_sphere_.resize(spheres() + SphereRows::pads, 0);
  pad(rows);
  list_pairs(rows, time, team);
  remember(contacts);
}

std::size_t ContactSet::may_begin(const Stripe& stripe) const {
  std::size_t sum = stripe.near.count;
  for (const NearWall& near : stripe.walls) sum += near.count;
  return sum;
}

ContactView ContactSet::view(Stripe& stripe, const SphereRows& rows) {
  ContactView view{};
  view.places = rows.places.data();
  view.motions = rows.motions.data();
  view.kind = kind_of_sphere_.data();
  view.radius = radius_[0];
  view.first = stripe.pairs.first.data();
  view.second = stripe.pairs.second.data();
  view.periods = periods_;
  view.contact = stripe.pairs.contact.data();
  view.memory = stripe.memory.rows.data();
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
  view.count = static_cast<std::int32_t>(near.slots.size());
  view.contact = near.contact.data();
  view.parameters = wall_parameters_.data();
  return view;
}

void ContactSet::work_out(int k, const SphereRows& rows, double time, LoadRange loads) {
  Stripe& stripe = stripes_[k];
  const std::int32_t begin = stripes().begin(k), end = stripes().end(k);
  if (stripe.near.is_old) choose_near(stripe, end, rows);
  for (std::size_t w = 0; w < stripe.walls.size(); ++w) {
    if (!is_there(surroundings_.walls[w], time)) drop(stripe.walls[w], static_cast<int>(w), stripe);
  }
  stripe.memory.make_room(may_begin(stripe));
  const double time_before = (std::round(time / step_) - 1) * step_;  // to the bit, as the step before had it
  const ContactView contacts = view(stripe, rows);
  ContactTask task{stripe.near.view(), stripe.near.count, begin, end, loads.rows, stripe.touching.data(), stripe.memory.free.data(),
                   stripe.memory.free_count, stripe.deferred.data(), 0, 0, stripe.book, {}, 0, 0};
  kernel_->pairs(contacts, task);
  for (std::size_t w = 0; w < stripe.walls.size(); ++w) {
    if (!is_there(surroundings_.walls[w], time)) continue;
    kernel_->wall(contacts, wall_view(static_cast<int>(w), stripe.walls[w], time), task);
    if (booked_ && time > 0 && !is_there(surroundings_.walls[w], time_before)) task.wall_work += brought_by(stripe.walls[w], stripe);
  }
  stripe.memory.free_count = task.free_count;
  for (int target = k; target <= reach_.last(k); ++target) stripe.for_stripe[target].clear();
  for (std::int32_t n = 0; n < task.deferred_count; ++n) {
    const int target = stripes().of(stripe.deferred[n].slot);
    stripe.for_stripe[target].push_back(n);
  }
  stripe.contacts = task.contacts;
  stripe.book = task.book, stripe.power = task.power;
  stripe.wall_work += task.wall_work, stripe.wall_power = task.wall_power;
}

void ContactSet::count_paths(const std::vector<double>& paths) {
  for (std::size_t k = 0; k < stripes_.size(); ++k) {
    NearList& soon = stripes_[k].near;
    const auto first = paths.begin() + static_cast<std::ptrdiff_t>(k);
    soon.closer += *first + *std::max_element(first, paths.begin() + reach_.last(static_cast<int>(k)) + 1);
    soon.is_old = soon.is_old || !(soon.closer < (1 - 1e-9) * near_gap());
  }
}

void ContactSet::work_out(const SphereRows& rows, double time, StripeLoads& loads, Team& team) {
  team.each(stripes().count(), [&](int k, int thread) { work_out(k, rows, time, loads.take(k, thread)); });
  team.each(stripes().count(), [&](int k, int) { gather_loads(k, loads.of(k)); });
}

void ContactSet::gather_loads(int k, LoadRange loads) {
  for (int from = reach_.first_to_reach(k); from < k; ++from) {
    if (reach_.last(from) < k) continue;
    const Stripe& other = stripes_[from];
    for (const std::int32_t n : other.for_stripe[k]) {
      const DeferredForce& later = other.deferred[n];
      double* load = loads.rows + (later.slot - loads.first) * load_numbers;
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

const ContactParameters<double>& ContactSet::parameters_of(const KeptContact& c) const {
  const int kind = kind_of_sphere_[c.first];
  return c.second < 0 ? wall_parameters_[kind] : pair_parameters_[kind * bodies_.size() + kind_of_sphere_[c.second]];
}

double ContactSet::energy_of(const KeptContact& c) const {
  const ContactParameters<double>& p = parameters_of(c);
  double energy = 0.4 * p.normal * c.root * c.root * c.root * c.root * c.root;
  for (const double spring : c.spring) {
    if (p.tangential > 0) energy += 0.5 * spring * spring / (p.tangential * c.root);
  }
  return energy;
}

double ContactSet::stored_energy() const {
  double sum = 0;
  for (const KeptContact& c : kept()) sum += energy_of(c);
  return sum;
}

double ContactSet::closing_power(const KeptContact& c) const {
  return -parameters_of(c).normal * c.root * c.root * c.root * c.opening;
}

double ContactSet::brought_by(const NearWall& near, const Stripe& stripe) const {
  double energy = 0;
  for (std::size_t n = 0; n < near.count; ++n) {
    if (near.contact[n] == 0) continue;
    KeptContact contact = stripe.memory.at(near.contact[n], near.slots[n], -1);
    std::fill_n(contact.spring, 3, 0.0);  // those of the first step come out of the motion
    energy += energy_of(contact) - 0.5 * step_ * closing_power(contact);
  }
  return energy;
}

void ContactSet::drop(NearWall& near, int wall, Stripe& stripe) const {
  for (std::size_t n = 0; n < near.count; ++n) {
    if (near.contact[n] == 0) continue;
    if (booked_) {
      const KeptContact contact = stripe.memory.at(near.contact[n], near.slots[n], -1 - wall);
      stripe.wall_work -= energy_of(contact) + 0.5 * step_ * closing_power(contact);
    }
    stripe.memory.give_back(near.contact[n]);
    near.contact[n] = 0;
  }
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
  for (const KeptContact& c : kept()) {
    const Vec<double, 3> x = rows.place(c.first);
    const Vec<double, 3> v = rows.velocity(c.first), w = rows.spin(c.first);
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
      const Vec<double, 3> r = nearest_image(periods_, rows.place(c.second) - x);
      pair.normal = (1 / norm(r)) * r;
      arm = norm(r) * radius_[c.first] / (radius_[c.first] + radius_[c.second]);
      other_arm = norm(r) - arm;
      other_velocity = rows.velocity(c.second);
      other_spin = rows.spin(c.second);
      p = &pair_parameters_[kind * bodies_.size() + kind_of_sphere_[c.second]];
    }
    pair.overlap = c.root * c.root;
    pair.velocity = other_velocity - v - cross(arm * w + other_arm * other_spin, pair.normal);
    pair.spin = other_spin - w;
    ContactHistory<double> history{{c.spring[0], c.spring[1], c.spring[2]}, c.root, c.opening};
    const ContactAction<double> action = contact_action(*p, pair, 0.0, history);
    all.push_back({c.first, c.second, pair.overlap, x + arm * pair.normal, action.force});
  }
  return all;
}

}  // namespace fiberchain::dem
