#include <algorithm>

#include "dem/contact/contacts.hpp"

// Energy that contacts store and dissipate, and the work of walls.
namespace fiberchain::dem {
namespace {

void add_times(ContactAccount<double>& sum, double factor, const ContactAccount<double>& more) {
  sum.normal_dashpot += factor * more.normal_dashpot;
  sum.sliding += factor * more.sliding;
  sum.rolling += factor * more.rolling;
}

}  // namespace

ContactAccumulators& ContactAccumulators::operator+=(const ContactAccumulators& more) {
  contacts += more.contacts;
  add_times(account, 1, more.account);
  add_times(power, 1, more.power);
  return *this;
}

ContactAccount<double> Contacts::dissipated() const {
  const double half = 0.5 * step_;
  ContactAccount<double> sum{};
  for (const Part& part : parts_) {
    add_times(sum, 1, part.sums.account);
    add_times(sum, -half, part.sums.power);
  }
  return sum;
}

void Contacts::begin_accounts() {
  const double half = 0.5 * step_;
  for (Part& part : parts_) {
    add_times(part.sums.account, -half, part.sums.power);
  }
  begin_wall_interval(0);
  for (WallRecord& record : records_) record.work -= half * record.power;
  for (Wall& wall : domain_.walls) {
    if (wall.motion.drive) wall.motion.drive->speed *= 0.5;
  }
}

double Contacts::energy_of(const SavedContact& c) const {
  return law_->stored_energy(parameters_of(c), c.history);
}

double Contacts::smaller_radius(const ContactKey& key) const {
  const double first = radius_[key.first.number];
  return is_of_fiber(key.second) ? std::min(first, radius_[key.second.number]) : first;
}

ContactSums Contacts::sums() const {
  ContactSums all;
  each_place([&](const ContactPlace& place) {
    const SavedContact contact = saved(place);
    all.stored_energy += energy_of(contact);
    const double overlap = law_->overlap(contact.history);
    if (overlap > 0) all.overlap += overlap / smaller_radius(contact.key), ++all.overlapping;
  });
  return all;
}

double Contacts::closing_power(const SavedContact& c) const {
  return law_->closing_power(parameters_of(c), c.history);
}

double Contacts::brought_by(std::size_t wall, const Part& part) const {
  double energy = 0;
  each_at_wall(part, wall, [&](const ContactKey& key, std::int32_t number) {
    const SavedContact contact = part.histories.at(number, key);
    // tangential springs of the first step come out of the motion
    energy +=
        law_->normal_energy(parameters_of(contact), contact.history) - 0.5 * step_ * closing_power(contact);
  });
  return energy;
}

void Contacts::drop(std::size_t wall, Part& part) const {
  bool any = false;
  each_at_wall(part, wall, [&](const ContactKey& key, std::int32_t number) {
    const SavedContact contact = part.histories.at(number, key);
    part.wall_brought[wall] -= energy_of(contact) + 0.5 * step_ * closing_power(contact);
    part.histories.give_back(number);
    any = true;
  });
  if (any) std::ranges::fill(part.walls[wall].contact, 0);
  if (is_mesh(wall)) part.walls[wall] = {};
  if (has_ridges(wall)) part.ridges[wall].contacts().clear();
}

std::vector<double> Contacts::accumulators() const {
  std::vector<double> all;
  for (const Part& part : parts_) {
    const ContactAccumulators& s = part.sums;
    all.insert(all.end(), {static_cast<double>(s.contacts), s.account.normal_dashpot, s.account.sliding,
                           s.account.rolling, s.power.normal_dashpot, s.power.sliding, s.power.rolling});
  }
  return all;
}

void Contacts::set_accumulators(const double* from) {
  for (Part& part : parts_) {
    part.sums = {.contacts = static_cast<std::int64_t>(from[0]),
                 .account = {from[1], from[2], from[3]},
                 .power = {from[4], from[5], from[6]}};
    from += accumulators_per_part;
  }
}

}  // namespace fiberchain::dem
