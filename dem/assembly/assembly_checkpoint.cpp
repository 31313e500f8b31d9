#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

#include "dem/assembly/field_rules.hpp"
#include "dem/assembly/group_layout.hpp"
#include "dem/model/errors.hpp"

// Saving and restoring the state: one table of fields serves both.
namespace fiberchain::dem {
namespace {

using namespace field_rules;

constexpr std::string_view order_field = "fiber_order";

/// The fibers of all groups, place by place.
FieldValues fiber_orders(State& s, const Places&) {
  Integers all;
  for (const FiberOrder& order : s.order) all.insert(all.end(), order.fibers().begin(), order.fibers().end());
  return all;
}

std::vector<FiberOrder> orders_from(const State& s, const Integers& fibers) {
  std::vector<FiberOrder> orders;
  auto from = fibers.begin();
  for (const FiberOrder& own : s.order) {
    orders.emplace_back(std::vector<std::int32_t>(from, from + own.count()));
    from += own.count();
  }
  return orders;
}

void set_fiber_orders(State& s, const FieldValues& values) {
  s.order = orders_from(s, std::get<Integers>(values));
}

FieldValues reference_positions(State& s, const Places&) {
  Reals all;
  all.reserve(3 * s.contacts.reference_positions().size());
  for (const auto& x : s.contacts.reference_positions()) all.insert(all.end(), x.c, x.c + 3);
  return all;
}

/// Lists pairs and wall neighbors as they stood; contacts follow from fields of their own.
void set_reference_positions(State& s, const FieldValues& values) {
  std::vector<Vec<double, 3>> listed;
  const Reals& x = std::get<Reals>(values);
  s.part_pieces();
  for (std::size_t i = 0; i < x.size(); i += 3) listed.push_back({x[i], x[i + 1], x[i + 2]});
  s.contacts.rebuild_neighbor_list(std::move(listed), s.contacts.reference_time(), s.pool);
  s.contacts.clear();
}

constexpr std::string_view keys_field = "contact_keys";
/// First and second primitive (to_number), slot.
constexpr std::size_t key_size = 3;

FieldValues contact_keys(State&, const Places& contacts) {
  Integers all;
  all.reserve(key_size * contacts.size());
  for (const ContactPlace& c : contacts)
    all.insert(all.end(), {to_number(c.key.first), to_number(c.key.second), c.key.slot});
  return all;
}

/// Contacts without history, which follows.
void set_contact_keys(State& s, const FieldValues& values) {
  const Integers& keys = std::get<Integers>(values);
  std::vector<SavedContact> contacts(keys.size() / key_size);
  for (std::size_t n = 0; n < contacts.size(); ++n) {
    const std::int64_t* key = keys.data() + key_size * n;
    contacts[n].key = {primitive_of(key[0]), primitive_of(key[1]), static_cast<std::int32_t>(key[2])};
  }
  s.contacts.restore(contacts);
  if (contact_keys(s, s.contacts.places()) != values)
    refuse(keys_field, "names pairs that are not neighbors, or in another order");
}

FieldValues contact_histories(State& s, const Places& contacts) {
  Reals all;
  all.reserve(contact_history_size * contacts.size());
  for (const ContactPlace& place : contacts) {
    const SavedContact c = s.contacts.saved(place);
    all.insert(all.end(), c.history, c.history + contact_history_size);
  }
  return all;
}

/// read(contact, numbers) for every contact, of which a field has `width` numbers each.
template <class Read>
void change_contacts(State& s, const FieldValues& values, int width, const Read& read) {
  std::vector<SavedContact> contacts = s.contacts.saved();
  const double* from = std::get<Reals>(values).data();
  for (SavedContact& contact : contacts) read(contact, from), from += width;
  s.contacts.clear();
  s.contacts.restore(contacts);
}

void set_contact_histories(State& s, const FieldValues& values) {
  change_contacts(s, values, contact_history_size, [](SavedContact& c, const double* history) {
    std::copy_n(history, contact_history_size, c.history);
  });
}

/// Numbers of a contact that accounting needs.
std::size_t work_size(const State& s) { return s.options.account_energy ? contact_account_size : 0; }

FieldValues contact_works(State& s, const Places& contacts) {
  Reals all;
  if (!s.options.account_energy) return all;
  all.reserve(contact_account_size * contacts.size());
  for (const ContactPlace& place : contacts) {
    const SavedContact c = s.contacts.saved(place);
    all.insert(all.end(), c.work, c.work + contact_account_size);
  }
  return all;
}

void set_contact_works(State& s, const FieldValues& values) {
  if (!s.options.account_energy) return;
  change_contacts(s, values, contact_account_size, [](SavedContact& c, const double* work) {
    std::copy_n(work, contact_account_size, c.work);
  });
}

/// Every field, in the order of restoring; a new one is a line here.
const std::vector<FieldRule>& fields() {
  static const std::vector<FieldRule> all = {
      {.name = layout_field,
       .get = [](State& s, const Places&) -> FieldValues { return to_numbers(group_layouts(s)); },
       .set = [](State& s,
                 const FieldValues& v) { require_same(layout_field, v, to_numbers(group_layouts(s))); }},
      {.name = "time_step",
       .get = [](State& s, const Places&) -> FieldValues { return Reals{s.step}; },
       .set = [](State& s, const FieldValues& v) { require_same("time_step", v, Reals{s.step}); }},
      {.name = "time_shift",
       .get = [](State& s, const Places&) -> FieldValues { return Reals{s.options.time_shift}; },
       .set = [](State& s, const FieldValues& v) { s.options.time_shift = std::get<Reals>(v).front(); }},
      number_field<&State::steps>("steps"),
      number_field<&State::displacement_budget>("displacement_budget"),
      number_field<&State::inserted>("inserted_energy"),
      number_field<&State::released>("released_energy"),
      number_field<&State::broken_bonds>("broken_bonds"),
      number_field<&State::longest_path>("longest_path"),
      number_field<&State::best_cross_part_fraction>("best_cross_part_fraction"),
      number_field<&State::sort_count>("sort_count"),
      number_field<&State::largest_turn>("largest_turn"),
      {.name = order_field, .get = fiber_orders, .set = set_fiber_orders},
      sphere_field<&SphereStorage::position_radius>("position_radius"),
      sphere_field<&SphereStorage::velocity_spin>("velocity_spin"),
      sphere_field<&SphereStorage::orientation>("orientation"),
      {.name = "load",
       .get = [](State& s, const Places&) -> FieldValues { return s.loads.all(); },
       .set =
           [](State& s, const FieldValues& v) {
             s.loads.set(std::get<Reals>(v).data(), std::get<Reals>(v).size());
           }},
      block_field<0>("block_previous_step"),
      block_field<1>("block_fluid_dissipation"),
      block_field<2>("bond_history"),
      block_field<3>("block_workspace"),
      block_field<4>("bond_previous_loads"),
      block_field<5>("bond_dissipation", 2),
      {.name = "reference_time",
       .get = [](State& s, const Places&) -> FieldValues { return Reals{s.contacts.reference_time()}; },
       .set = [](State& s,
                 const FieldValues& v) { s.contacts.set_reference_time(std::get<Reals>(v).front()); }},
      {.name = "wall_reference",
       .get = [](State& s, const Places&) -> FieldValues { return s.contacts.reference_shifts(); },
       .set = [](State& s, const FieldValues& v) { s.contacts.set_drive_shifts(std::get<Reals>(v)); }},
      {.name = "reference_position", .get = reference_positions, .set = set_reference_positions},
      {.name = keys_field,
       .get = contact_keys,
       .set = set_contact_keys,
       .extent = Extent::per_contact,
       .width = [](const State&) { return key_size; }},
      {.name = "contact_history",
       .get = contact_histories,
       .set = set_contact_histories,
       .extent = Extent::per_contact,
       .width = [](const State&) { return std::size_t{contact_history_size}; }},
      {.name = "contact_work",
       .get = contact_works,
       .set = set_contact_works,
       .extent = Extent::per_contact,
       .width = work_size},
      {.name = "contact_accumulators",
       .get = [](State& s, const Places&) -> FieldValues { return s.contacts.accumulators(); },
       .set = [](State& s, const FieldValues& v) { s.contacts.set_accumulators(std::get<Reals>(v).data()); },
       .version = 2},
      {.name = "walls",
       .get = [](State& s, const Places&) -> FieldValues { return s.contacts.wall_records(); },
       .set = [](State& s, const FieldValues& v) { s.contacts.set_wall_records(std::get<Reals>(v).data()); }},
      {.name = "held",
       .get = [](State& s, const Places&) -> FieldValues { return s.held.saved(); },
       .set = [](State& s, const FieldValues& v) { s.held.restore(std::get<Reals>(v).data()); }},
      {.name = applied_loads_field,
       .get = [](State& s, const Places&) -> FieldValues { return s.held.applied_loads(s); },
       .set = [](State&, const FieldValues&) {}},  // of a run that goes on with others
      {.name = "deepest_overlap",
       .get = [](State& s, const Places&) -> FieldValues { return Reals{s.contacts.deepest()}; },
       .set = [](State& s, const FieldValues& v) { s.contacts.set_deepest(std::get<Reals>(v).front()); }},
  };
  return all;
}

std::size_t size_of(const FieldValues& values) {
  return std::visit([](const auto& numbers) { return numbers.size(); }, values);
}

/// Contacts of a saved state, whose pairs have been checked.
std::size_t contacts_in(const SavedState& saved) {
  const auto found = saved.find(keys_field);
  return found == saved.end() ? 0 : size_of(found->second.values) / key_size;
}

void check_field(State& s, const FieldRule& rule, const SavedState& saved) {
  const auto found = saved.find(rule.name);
  if (found == saved.end()) refuse(rule.name, "is missing");
  const StateField& field = found->second;
  if (field.version != rule.version)
    refuse(rule.name,
           fmt::format("is of version {}; this program reads version {}", field.version, rule.version));
  const FieldValues own = rule.get(s, s.contacts.places());
  if (own.index() != field.values.index())
    refuse(rule.name, own.index() == 1 ? "holds reals, not integers" : "holds integers, not reals");
  const std::size_t wanted = rule.extent == Extent::fixed ? size_of(own) : rule.width(s) * contacts_in(saved);
  if (size_of(field.values) != wanted)
    refuse(rule.name, fmt::format("has {} numbers; this assembly has {}", size_of(field.values), wanted));
}

void check_keys(const State& s, const Integers& keys) {
  const auto walls = static_cast<std::int64_t>(s.domain.walls.size());
  for (std::size_t n = 0; n < keys.size(); n += key_size) {
    const std::int64_t first = keys[n], second = keys[n + 1];
    const Primitive one = primitive_of(first), other = primitive_of(second);
    const auto is_there = [&](const Primitive& body) {
      // spheres are left of smooth fibers that have broken
      return body.number < s.rows.count && (is_sphere(body) || body == s.contacts.primitive(body.number));
    };
    const bool there = is_facet(other) ? is_of_fiber(one) && is_there(one) && other.number < walls
                                       : is_of_fiber(one) && is_there(one) && is_there(other);
    if (!there)
      refuse(keys_field, fmt::format("names a pair {}, {} that this assembly does not have", first, second));
  }
}

void check_orders(const State& s, const Integers& fibers) {
  for (const std::int64_t fiber : fibers) {
    if (fiber < 0 || fiber > std::numeric_limits<std::int32_t>::max())
      refuse(order_field, fmt::format("names a fiber {}", fiber));
  }
  try {
    orders_from(s, fibers);
  } catch (const InvalidInput& error) {
    refuse(order_field, fmt::format("is none: {}", error.what()));
  }
}

void check_state(State& s, const SavedState& saved) {
  for (const FieldRule& rule : fields()) check_field(s, rule, saved);
  for (const auto& [name, field] : saved) {
    if (std::ranges::find(fields(), name, &FieldRule::name) == fields().end()) refuse(name, "is unknown");
  }
  check_orders(s, std::get<Integers>(saved.find(order_field)->second.values));
  check_keys(s, std::get<Integers>(saved.find(keys_field)->second.values));
}

}  // namespace

SavedState Assembly::saved() const {
  SavedState all;
  each_saved([&](std::string_view name, const StateField& field) { all.emplace(name, field); });
  return all;
}

void Assembly::each_saved(const UseField& use) const {
  const Places contacts = state_->contacts.places();
  for (const FieldRule& rule : fields()) use(rule.name, {rule.version, rule.get(*state_, contacts)});
}

void Assembly::restore(const SavedState& saved) {
  State& s = *state_;
  check_state(s, saved);
  for (const FieldRule& rule : fields()) rule.set(s, saved.find(rule.name)->second.values);
  s.set_gradient();
  s.held.locate(s);
  if (s.held.any()) s.held.grasp(s);
}

}  // namespace fiberchain::dem
