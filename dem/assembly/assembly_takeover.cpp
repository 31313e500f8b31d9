#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "dem/assembly/assembly_state.hpp"
#include "dem/assembly/fiber_reader.hpp"
#include "dem/contact/contact_law.hpp"
#include "dem/model/errors.hpp"

// Fibers that go on from another assembly: their velocities, the memory of their bonds and contacts.
namespace fiberchain::dem {
namespace {

using State = Assembly::State;

void check_carried(const State& s, const CarriedState& carried) {
  if (carried.groups.size() > s.kinds.size())
    throw InvalidInput(fmt::format("{} groups of fibers are carried; this assembly has {}",
                                   carried.groups.size(), s.kinds.size()));
  for (std::size_t g = 0; g < carried.groups.size(); ++g) {
    const CarriedGroup& group = carried.groups[g];
    if (std::ssize(group.fibers) == s.fibers[g] && group.spheres() == s.kinds[g].spheres()) continue;
    throw InvalidInput(
        fmt::format("group {} is carried with {} fibers of {} spheres; this assembly has {} of {}", g,
                    group.fibers.size(), group.spheres(), s.fibers[g], s.kinds[g].spheres()));
  }
}

void put_velocities(State& s, const CarriedGroup& group, int g) {
  for (std::size_t f = 0; f < group.fibers.size(); ++f) {
    std::int64_t row = s.first_row(g, static_cast<int>(f));
    for (int i = 0; i < group.spheres(); ++i, ++row) {
      double* own = s.rows.velocity_row(row);
      for (int c = 0; c < 3; ++c)
        own[c] = group.fibers[f].velocity[i][c], own[spin_offset + c] = group.fibers[f].spin[i][c];
    }
  }
}

/// Histories of the bonds where they are of the same law, without what has another layout.
void put_histories(State& s, const CarriedGroup& group, int g, double step, CarriedLosses& losses) {
  const GroupKind& kind = s.kinds[g];
  const std::int64_t bonds = kind.spheres() - 1, width = kind.kernel->width,
                     of_bond = static_cast<std::int64_t>(kind.memory.bond),
                     law = static_cast<std::int64_t>(kind.kernel->history), all = s.fibers[g] * bonds;
  // bonds that break or yield go on from the same law that did not
  const bool same_law = !group.histories.empty() && group.form == kind.law->form &&
                        (group.law_numbers == law || group.law_numbers == kind.law->failure_place);
  const bool same_branches = same_law && group.bond_numbers == of_bond;
  if (!same_law) losses.bonds_without += law > 0 ? all : 0;
  if (!same_branches && of_bond > law) losses.branches_without += all;
  if (!same_law) return;
  const std::int64_t taken = same_branches ? of_bond : std::min<std::int64_t>(law, group.law_numbers);
  for (std::int64_t place = 0; place < s.order[g].count(); ++place) {
    FiberBlock& block = s.blocks[s.first_block[g] + place / width];
    const double* from = group.histories.data() + s.order[g].fiber(place) * bonds * group.bond_numbers;
    // unused lanes repeat the last fiber
    const std::int64_t lane = place % width, end = place + 1 == s.order[g].count() ? width : lane + 1;
    for (std::int64_t k = lane; k < end; ++k) {
      for (std::int64_t i = 0; i < bonds; ++i) {
        double* to = kind.history_of(block.histories(), static_cast<int>(k), static_cast<int>(i));
        for (std::int64_t n = 0; n < taken; ++n) to[n * width] = from[i * group.bond_numbers + n];
      }
    }
    block.saved_arrays()[0][0] = step;
  }
}

/// A contact of this assembly: rows in place of numbers.
SavedContact in_rows(const State& s, const SavedContact& carried) {
  SavedContact contact = carried;
  contact.key.first.number = s.row_of(carried.key.first.number);
  if (is_of_fiber(carried.key.second)) contact.key.second.number = s.row_of(carried.key.second.number);
  return contact;
}

using ContactsNow = std::map<ContactKey, SavedContact>;

/// The contact here with a wall that a sphere overlaps as it did one there, by which its history goes on: the
/// same wall and feature of a mesh first, then of all the lowest.
ContactKey wall_contact_like(const ContactsNow& now, const SavedContact& contact, const ContactLaw& law,
                             double radius) {
  const double overlap = law.overlap(contact.history);
  const auto fits = [&](const SavedContact& other) {
    constexpr double close = 1e-6;  // of the radius
    return std::abs(law.overlap(other.history) - overlap) < close * radius;
  };
  const auto same = now.find(contact.key);
  if (same != now.end() && fits(same->second)) return contact.key;
  ContactKey best = contact.key;
  bool found = false;
  const Primitive& sphere = contact.key.first;
  // walls come before spheres, the last wall first
  const ContactKey first{sphere, facet_primitive(first_segment), 0};
  for (auto at = now.lower_bound(first); at != now.end() && at->first.first == sphere; ++at) {
    const ContactKey& key = at->first;
    if (!is_facet(key.second)) break;
    if (!fits(at->second) || (found && key.second == best.second)) continue;
    best = key, found = true;
  }
  return best;
}

/// Gives the contacts that are there the histories they had. The spheres whose contacts are not the same.
std::set<std::int64_t> put_contacts(State& s, const CarriedState& carried, CarriedLosses& losses) {
  const ContactLaw& law = law_of(s.domain.contacts);
  ContactsNow now;
  std::set<std::int64_t> changed;
  const auto change = [&](const ContactKey& key) {
    changed.insert(key.first.number);
    if (is_of_fiber(key.second)) changed.insert(key.second.number);
  };
  for (const SavedContact& contact : s.contacts.saved()) now.emplace(contact.key, contact);
  std::set<ContactKey> kept;
  for (const SavedContact& one : carried.contacts) {
    SavedContact contact = in_rows(s, one);
    if (is_of_fiber(contact.key.second)) {
      if (contact.key.first.number > contact.key.second.number) {
        std::swap(contact.key.first, contact.key.second);
        law.exchange_bodies(contact.history);
      }
    } else {
      contact.key = wall_contact_like(now, contact, law, s.rows.radius(contact.key.first.number));
    }
    const auto found = now.find(contact.key);
    if (found == now.end()) {
      change(contact.key);
      continue;
    }
    std::copy_n(contact.history, contact_history_size, found->second.history);
    kept.insert(contact.key);
  }
  std::vector<SavedContact> all;
  for (const auto& [key, contact] : now) {
    all.push_back(contact);
    if (!kept.contains(key)) change(key);
  }
  s.contacts.clear();
  s.contacts.restore(all);
  losses.contacts = std::ssize(carried.contacts), losses.kept = std::ssize(kept);
  return changed;
}

/// Loads of contacts that are the same.
void put_loads(State& s, const CarriedState& carried, const std::set<std::int64_t>& changed) {
  std::vector<double> loads = s.loads.all();
  for (int g = 0; g < static_cast<int>(carried.groups.size()); ++g) {
    const CarriedGroup& group = carried.groups[g];
    if (group.loads.empty()) continue;
    for (int f = 0; f < s.fibers[g]; ++f) {
      const std::int64_t first = s.first_row(g, f), n = group.spheres();
      for (std::int64_t i = 0; i < n; ++i) {
        if (changed.contains(first + i)) continue;
        std::copy_n(group.loads.data() + (f * n + i) * load_size, load_size,
                    loads.data() + (first + i) * load_size);
      }
    }
  }
  s.held.add_loads(s, changed, loads);
  s.loads.set(loads.data(), loads.size());
}

/// Histories of a block's bonds to this moment, velocities from half a step of `before` back to half a step
/// of this assembly back, which its own half kick tells: as an assembly starts.
void begin_again(State& s, FiberReader& reader, FiberBlock& block, double before) {
  const GroupKind& kind = s.kinds[block.group()];
  reader.take(block);
  const double back = before / s.step - 1;
  for (int lane = 0; lane < block.lanes() && back != 0; ++lane) {
    const ChainState<3>& ahead = reader.read(lane);
    for (int i = 0; i < kind.spheres(); ++i) {
      double* own = s.rows.velocity_row(block.first(lane) + i);
      for (int c = 0; c < 3; ++c) {
        own[c] += back * (ahead.velocity[i][c] - own[c]);
        own[spin_offset + c] += back * (ahead.spin[i][c] - own[spin_offset + c]);
      }
    }
  }
  const auto arrays = block.saved_arrays();
  if (!arrays[2].empty()) std::copy_n(reader.history(0, 0), arrays[2].size(), arrays[2].begin());
  arrays[0][0] = 0;
}

}  // namespace

CarriedLosses Assembly::take_over(const CarriedState& carried) {
  State& s = *state_;
  check_carried(s, carried);
  CarriedLosses losses;
  const int groups = static_cast<int>(carried.groups.size());
  for (int g = 0; g < groups; ++g) put_histories(s, carried.groups[g], g, carried.step, losses);
  s.adopt_failures(groups);
  if (carried.step == 0) return losses;
  for (int g = 0; g < groups; ++g) put_velocities(s, carried.groups[g], g);
  put_loads(s, carried, put_contacts(s, carried, losses));
  FiberReader reader(s);
  for (FiberBlock& block : s.blocks) {
    if (block.group() < groups) begin_again(s, reader, block, carried.step);
  }
  if (s.held.any()) s.held.set_speeds(s);
  s.held.begin_accounts(s);
  return losses;
}

}  // namespace fiberchain::dem
