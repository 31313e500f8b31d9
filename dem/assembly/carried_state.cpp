#include "dem/assembly/carried_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dem/assembly/fiber_order.hpp"
#include "dem/assembly/group_layout.hpp"
#include "dem/insertion/placement.hpp"
#include "dem/model/errors.hpp"
#include "dem/simd/storage_layout.hpp"

namespace fiberchain::dem {
namespace {

using SavedReals = std::vector<double>;
using SavedCounts = std::vector<std::int64_t>;

[[noreturn]] void refuse_carried(std::string_view name, const std::string& reason) {
  throw InvalidInput(fmt::format("field '{}' of the saved state {}", name, reason));
}

template <class Values>
const Values& values_of(const SavedState& saved, std::string_view name, std::int64_t size = -1,
                        int version = 1) {
  const auto found = saved.find(name);
  if (found == saved.end()) refuse_carried(name, "is missing");
  if (found->second.version != version)
    refuse_carried(
        name, fmt::format("is of version {}; this program reads version {}", found->second.version, version));
  const auto* values = std::get_if<Values>(&found->second.values);
  if (values == nullptr) refuse_carried(name, "holds numbers of another type");
  if (size >= 0 && std::ssize(*values) != size)
    refuse_carried(name, fmt::format("has {} numbers, not {}", values->size(), size));
  return *values;
}

/// A saved state's groups and the order of their fibers.
struct SavedLayout {
  std::vector<GroupLayout> groups;
  std::vector<FiberOrder> orders;
  std::int64_t spheres = 0;
};

SavedLayout layout_in(const SavedState& saved) {
  SavedLayout all;
  all.groups = group_layouts_in(values_of<SavedCounts>(saved, layout_field));
  std::int64_t fibers = 0;
  for (const GroupLayout& group : all.groups) {
    if (!group.makes_sense()) refuse_carried(layout_field, "makes no sense");
    fibers += group.fibers, all.spheres += group.fibers * group.spheres;
  }
  const SavedCounts& order = values_of<SavedCounts>(saved, "fiber_order", fibers);
  auto from = order.begin();
  for (const GroupLayout& group : all.groups) {
    const auto fits = [&](std::int64_t fiber) { return fiber >= 0 && fiber < group.fibers; };
    if (!std::all_of(from, from + group.fibers, fits)) refuse_carried("fiber_order", "makes no sense");
    all.orders.emplace_back(std::vector<std::int32_t>(from, from + group.fibers));
    from += group.fibers;
  }
  return all;
}

Vec<double, 3> vector_at(const double* x) { return {x[0], x[1], x[2]}; }

/// Rows of all spheres of a group, from its first row on.
void take_rows(CarriedGroup& group, const SavedLayout& all, std::size_t g, std::int64_t first,
               const SavedState& saved) {
  const GroupLayout& layout = all.groups[g];
  const std::int64_t with_pads = all.spheres + 3;
  const SavedReals& places =
      values_of<SavedReals>(saved, "position_radius", with_pads * position_radius_size);
  const SavedReals& motions = values_of<SavedReals>(saved, "velocity_spin", with_pads * velocity_spin_size);
  const SavedReals& turns = values_of<SavedReals>(saved, "orientation");
  const SavedReals& loads = values_of<SavedReals>(saved, "load", all.spheres * load_size);
  group.oriented = std::ssize(turns) == with_pads * quaternion_size;
  group.radius = places[first * position_radius_size + radius_offset];
  for (std::int64_t fiber = 0; fiber < layout.fibers; ++fiber) {
    ChainState<3> state;
    for (std::int64_t i = 0; i < layout.spheres; ++i) {
      const std::int64_t row = first + all.orders[g].place(fiber) * layout.spheres + i;
      const double* q = turns.data() + row * quaternion_size;
      const double* motion = motions.data() + row * velocity_spin_size;
      state.poses.push_back(
          {vector_at(places.data() + row * position_radius_size),
           group.oriented ? Quaternion<double>{q[0], vector_at(q + 1)} : Quaternion<double>{}});
      state.velocity.push_back(vector_at(motion));
      state.spin.push_back(vector_at(motion + spin_offset));
      const double* load = loads.data() + row * load_size;
      group.loads.insert(group.loads.end(), load, load + load_size);
    }
    if (!group.oriented) orient_along(state);
    group.fibers.push_back(std::move(state));
  }
}

/// Histories of a group's bonds out of the lanes of its blocks, which begin at `from`.
const double* take_histories(CarriedGroup& group, const GroupLayout& layout, const FiberOrder& order,
                             const double* from) {
  const std::int64_t bonds = layout.spheres - 1, numbers = layout.bond_numbers, width = layout.width;
  group.histories.resize(static_cast<std::size_t>(layout.fibers * bonds * numbers));
  double* to = group.histories.data();
  for (std::int64_t fiber = 0; fiber < layout.fibers; ++fiber) {
    const std::int64_t place = order.place(fiber), lane = place % width;
    const double* block = from + place / width * (bonds * numbers * width);
    for (std::int64_t n = 0; n < bonds * numbers; ++n) *to++ = block[n * width + lane];
  }
  return from + layout.blocks() * bonds * numbers * width;
}

std::vector<SavedContact> saved_contacts_in(const SavedState& saved, const SavedLayout& all) {
  const SavedCounts& keys = values_of<SavedCounts>(saved, "contact_keys");
  const std::int64_t count = std::ssize(keys) / 3;
  const SavedReals& histories = values_of<SavedReals>(saved, "contact_history", count * contact_history_size);
  std::vector<std::int32_t> number_of_row;
  for (std::size_t g = 0; g < all.groups.size(); ++g) {
    const auto first = static_cast<std::int32_t>(number_of_row.size()),
               n = static_cast<std::int32_t>(all.groups[g].spheres);
    for (const std::int32_t fiber : all.orders[g].fibers()) {
      for (std::int32_t i = 0; i < n; ++i) number_of_row.push_back(first + fiber * n + i);
    }
  }
  std::vector<SavedContact> contacts(static_cast<std::size_t>(count));
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const std::int64_t* key = keys.data() + 3 * c;
    Primitive bodies[2] = {primitive_of(key[0]), primitive_of(key[1])};
    if (is_facet(bodies[0]) || bodies[0].number >= all.spheres ||
        (is_of_fiber(bodies[1]) && bodies[1].number >= all.spheres))
      refuse_carried("contact_keys",
                     fmt::format("names a pair {}, {} that it does not have", key[0], key[1]));
    for (Primitive& body : bodies) {
      if (is_of_fiber(body)) body.number = number_of_row[body.number];
    }
    contacts[c].key = {bodies[0], bodies[1], static_cast<std::int32_t>(key[2])};
    std::copy_n(histories.data() + c * contact_history_size, contact_history_size, contacts[c].history);
  }
  return contacts;
}

/// Takes off the loads of groups what is not of contacts.
void take_off_applied(CarriedState& state, const SavedState& saved) {
  if (!saved.contains(applied_loads_field)) return;
  const SavedReals& applied = values_of<SavedReals>(saved, applied_loads_field);
  for (std::size_t n = 0; n + applied_load_size <= applied.size(); n += applied_load_size) {
    auto number = static_cast<std::int64_t>(applied[n]);
    for (CarriedGroup& group : state.groups) {
      const std::int64_t spheres = std::ssize(group.loads) / load_size;
      if (number >= 0 && number < spheres) {
        for (int c = 0; c < 6; ++c) group.loads[number * load_size + c] -= applied[n + 1 + c];
        break;
      }
      number -= spheres;
    }
  }
}

}  // namespace

void orient_along(ChainState<3>& fiber) {
  const std::size_t last = fiber.poses.size() - 1;
  const auto direction = [&](std::size_t from, std::size_t to) {
    const Vec<double, 3> r = fiber.poses[to].position - fiber.poses[from].position;
    return (1 / norm(r)) * r;
  };
  // a bond lies along the mean of its spheres' axes, which gives those of the ends
  const auto mirrored = [](const Vec<double, 3>& bond, const Vec<double, 3>& axis) {
    return 2 * dot(bond, axis) * bond - axis;
  };
  std::vector<Vec<double, 3>> axes(last + 1, direction(0, last > 1 ? 2 : 1));
  for (std::size_t i = 1; i < last; ++i) axes[i] = direction(i - 1, i + 1);
  if (last > 1) {
    axes[0] = mirrored(direction(0, 1), axes[1]);
    axes[last] = mirrored(direction(last - 1, last), axes[last - 1]);
  }
  Vec<double, 3> before{1, 0, 0};
  Quaternion<double> turn{1, {0, 0, 0}};
  for (std::size_t i = 0; i <= last; ++i) {
    turn = rotation_between(before, axes[i]) * turn;
    fiber.poses[i].orientation = turn;
    before = axes[i];
  }
}

CarriedState carried_state(const SavedState& saved) {
  const SavedLayout all = layout_in(saved);
  CarriedState state;
  state.step = values_of<SavedReals>(saved, "time_step", 1).front();
  state.time = static_cast<double>(values_of<SavedCounts>(saved, "steps", 1).front()) * state.step +
               values_of<SavedReals>(saved, "time_shift", 1).front();
  std::int64_t numbers = 0, row = 0;
  for (const GroupLayout& group : all.groups)
    numbers += group.blocks() * (group.spheres - 1) * group.bond_numbers * group.width;
  const double* histories = values_of<SavedReals>(saved, "bond_history", numbers).data();
  for (std::size_t g = 0; g < all.groups.size(); ++g) {
    const GroupLayout& layout = all.groups[g];
    CarriedGroup group{.fibers = {},
                       .form = layout.form,
                       .law_numbers = static_cast<int>(layout.law_numbers),
                       .bond_numbers = static_cast<int>(layout.bond_numbers),
                       .histories = {},
                       .loads = {}};
    take_rows(group, all, g, row, saved);
    histories = take_histories(group, layout, all.orders[g], histories);
    row += layout.fibers * layout.spheres;
    state.groups.push_back(std::move(group));
  }
  take_off_applied(state, saved);
  state.contacts = saved_contacts_in(saved, all);
  return state;
}

}  // namespace fiberchain::dem
