#include <array>

#include "dem/assembly/assembly_state.hpp"
#include "dem/model/errors.hpp"

// The whole state as numbers, and back.
namespace fiberchain::dem {
namespace {

/// Steps, time of the list, displacement_budget, inserted energy, spheres.
constexpr std::size_t head_numbers = 5;
/// Of a contact.
constexpr std::size_t kept_numbers = 3 + contact_history_size + contact_account_size;

std::array<const LaneArray*, 3> arrays(const SphereStorage& rows) { return {&rows.position_radius, &rows.motions, &rows.orientation}; }

std::size_t fixed_numbers(const Assembly::State& s, std::size_t parts) {
  std::size_t sum = head_numbers + parts * Contacts::accumulators_per_part + (3 + load_size) * s.rows.count + 1;
  for (const LaneArray* a : arrays(s.rows)) sum += a->size();
  for (const FiberBlock& block : s.blocks) sum += block.saved_size();
  return sum;
}

}  // namespace

std::vector<double> Assembly::saved() const {
  const State& s = *state_;
  std::vector<double> all{static_cast<double>(s.steps), s.contacts.reference_time(), s.displacement_budget, s.inserted,
                          static_cast<double>(s.rows.count)};
  const std::vector<double> accumulators = s.contacts.accumulators();
  all.insert(all.end(), accumulators.begin(), accumulators.end());
  for (const auto& x : s.contacts.reference_positions()) all.insert(all.end(), x.c, x.c + 3);
  for (const LaneArray* a : arrays(s.rows)) all.insert(all.end(), a->data(), a->data() + a->size());
  const std::vector<double> loads = s.loads.all();
  all.insert(all.end(), loads.begin(), loads.end());
  for (const FiberBlock& block : s.blocks) block.save(all);
  const std::vector<SavedContact> saved = s.contacts.saved();
  all.push_back(static_cast<double>(saved.size()));
  for (const SavedContact& c : saved) {
    all.insert(all.end(), {static_cast<double>(to_number(c.key.first)), static_cast<double>(to_number(c.key.second)),
                           static_cast<double>(c.key.slot)});
    all.insert(all.end(), c.history, c.history + contact_history_size);
    all.insert(all.end(), c.work, c.work + contact_account_size);
  }
  return all;
}

void Assembly::restore(const std::vector<double>& saved) {
  State& s = *state_;
  const std::size_t fixed = fixed_numbers(s, s.contacts.parts().count());
  if (saved.size() < fixed || saved[head_numbers - 1] != static_cast<double>(s.rows.count) || !(saved[fixed - 1] >= 0) ||
      static_cast<double>(saved.size()) != static_cast<double>(fixed) + kept_numbers * saved[fixed - 1]) {
    throw InvalidInput("these numbers are not a state of this assembly");
  }
  const double* from = saved.data() + head_numbers;
  std::vector<Vec<double, 3>> listed(s.rows.count);
  const double* accumulators = from;
  from += static_cast<std::size_t>(s.contacts.parts().count()) * Contacts::accumulators_per_part;
  for (auto& x : listed) x = {from[0], from[1], from[2]}, from += 3;
  for (LaneArray* a : {&s.rows.position_radius, &s.rows.motions, &s.rows.orientation}) {
    std::copy_n(from, a->size(), a->data());
    from += a->size();
  }
  const std::size_t loads = load_size * s.rows.count;
  s.loads.set(from, loads);
  from += loads;
  for (FiberBlock& block : s.blocks) from = block.restore(from);
  std::vector<SavedContact> contacts(static_cast<std::size_t>(*from++));
  for (SavedContact& c : contacts) {
    c.key = {primitive_of(static_cast<std::int64_t>(from[0])), primitive_of(static_cast<std::int64_t>(from[1])),
             static_cast<std::int32_t>(from[2])};
    std::copy_n(from + 3, contact_history_size, c.history);
    std::copy_n(from + 3 + contact_history_size, contact_account_size, c.work);
    from += kept_numbers;
  }
  s.contacts.rebuild_neighbor_list(std::move(listed), saved[1], s.pool);
  s.contacts.clear();
  s.contacts.restore(contacts);
  s.contacts.set_accumulators(accumulators);
  s.steps = static_cast<std::int64_t>(saved[0]);
  s.displacement_budget = saved[2];
  s.inserted = saved[3];
  s.set_gradient();
}

}  // namespace fiberchain::dem
