#include "dem/lammps/exchange.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "dem/assembly/carried_state.hpp"
#include "dem/contact/contact_law.hpp"
#include "dem/contact/wall_record.hpp"
#include "dem/lammps/carried_keys.hpp"
#include "dem/model/errors.hpp"
#include "dem/motion/relaxation.hpp"

namespace fiberchain::dem::mpi {
namespace {

/// Largest gap of neighbors over the smallest radius: more than in Contacts, whose lists are made anew for
/// those alone that have moved far.
constexpr double skin_over_radius = 0.9;

const std::vector<double>& reals(const SavedState& saved, std::string_view name) {
  return std::get<std::vector<double>>(saved.find(name)->second.values);
}

GroupNumbers numbers_of(const Chain<3>& chain, const Domain& domain, double step) {
  const Fiber& fiber = chain.fiber;
  GroupNumbers group{};
  group.march = march_parameters<3>(fiber, StokesDrag{}, step);
  group.mass = sphere_mass(fiber);
  for (int c = 0; c < 3; ++c) group.weight[c] = group.mass * domain.gravity[c];
  group.radius = sphere_radius(fiber);
  group.spheres = fiber.aspect_ratio + 1;
  const BondParameters<double>& bond = group.march.bond;
  group.damped =
      bond.dash_stretch != 0 || bond.dash_shear != 0 || bond.dash_twist != 0 || bond.dash_bend != 0;
  return group;
}

/// Groups, kinds of contact and their parameters, as Contacts sets them.
Plan plan_of_assembly(const Assembly& assembly, const PackingScene& scene, double time_shift) {
  Plan plan;
  plan.domain = scene.domain, plan.form = scene.form;
  plan.step = assembly.step(), plan.time_shift = time_shift;
  plan.domain.gravity = assembly.gravity();
  plan.domain.walls = assembly.walls();
  std::vector<ContactBody> bodies;
  std::int64_t first = 0;
  for (int g = 0; g < assembly.groups(); ++g) {
    refuse_chain(assembly.chain(g));
    GroupNumbers group = numbers_of(assembly.chain(g), plan.domain, plan.step);
    group.first = first, group.fibers = assembly.fibers(g);
    first += group.fibers * group.spheres;
    const ContactBody body = sphere_body(assembly.chain(g), plan.domain);
    const auto found = std::ranges::find(bodies, body);
    group.contact_kind = static_cast<std::int32_t>(found - bodies.begin());
    if (found == bodies.end()) bodies.push_back(body);
    plan.groups.push_back(group);
  }
  const ContactLaw& law = law_of(plan.domain.contacts);
  const auto append = [&](std::vector<double>& table, const ContactBody& body, const ContactBody& other) {
    std::vector<double> numbers(static_cast<std::size_t>(law.parameters_size));
    const ContactPair pair = contact_pair(plan.domain, body, other);
    law.parameters(pair.together(), pair.properties, plan.step, numbers.data());
    table.insert(table.end(), numbers.begin(), numbers.end());
  };
  for (const ContactBody& body : bodies) {
    for (const ContactBody& other : bodies) append(plan.pair_parameters, body, other);
  }
  for (const Wall& wall : plan.domain.walls) {
    for (const ContactBody& body : bodies) append(plan.wall_parameters, body, wall_body(plan.domain, wall));
  }
  for (const ContactPair& pair : contact_pairs(plan.domain, bodies))
    plan.law_reach = std::max(plan.law_reach, law.reach(pair.together(), pair.properties));
  plan.contact_kinds = static_cast<std::int32_t>(bodies.size());
  plan.rolls = rolls(plan.domain);
  plan.oriented = from_poses(plan.form) || scene.orientations;
  plan.skin = skin_over_radius * plan.smallest_radius();
  return plan;
}

void put(const Vec<double, 3>& from, double* to) { std::copy_n(from.c, 3, to); }
Vec<double, 3> three(const double* x) { return {x[0], x[1], x[2]}; }

std::vector<SphereRecord> spheres_of(const CarriedState& state, const Plan& plan) {
  std::vector<SphereRecord> all(static_cast<std::size_t>(plan.spheres()));
  for (std::size_t g = 0; g < state.groups.size(); ++g) {
    const CarriedGroup& group = state.groups[g];
    const std::int64_t n = plan.groups[g].spheres;
    for (std::int64_t f = 0; f < plan.groups[g].fibers; ++f) {
      const ChainState<3>& fiber = group.fibers[static_cast<std::size_t>(f)];
      for (std::int64_t i = 0; i < n; ++i) {
        const std::int64_t of_group = f * n + i, number = plan.groups[g].first + of_group;
        SphereRecord& s = all[static_cast<std::size_t>(number)];
        s.number = static_cast<double>(number), s.group = static_cast<double>(g);
        const auto at = static_cast<std::size_t>(i);
        put(fiber.poses[at].position, s.position);
        put(fiber.velocity[at], s.velocity), put(fiber.spin[at], s.spin);
        s.orientation[0] = fiber.poses[at].orientation.w;
        put(fiber.poses[at].orientation.v, s.orientation + 1);
        std::copy_n(group.loads.data() + of_group * load_size, 6, s.load);
        if (group.bond_numbers == bond_history_size && i + 1 < n)
          std::copy_n(group.histories.data() + (f * (n - 1) + i) * bond_history_size, bond_history_size,
                      s.history);
      }
    }
  }
  return all;
}

void find_box(Outgoing& all) {
  for (int c = 0; c < 3; ++c) {
    const double period = all.plan.domain.period[c];
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const SphereRecord& s : all.spheres)
      low = std::min(low, s.position[c]), high = std::max(high, s.position[c]);
    const double margin = all.plan.largest_radius();
    all.low[c] = period > 0 ? 0 : low - margin;
    all.high[c] = period > 0 ? period : high + margin;
  }
}

/// Fibers as states with velocities half a step back.
CarriedState carried_of(const Gathered& all, const Plan& plan, std::int64_t steps) {
  CarriedState state{.time = plan.time(steps), .step = plan.step, .groups = {}, .contacts = {}};
  const int numbers = plan.form == BondForm::incremental ? bond_history_size : 0;
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    const GroupNumbers& own = plan.groups[g];
    const auto n = static_cast<std::size_t>(own.spheres), fibers = static_cast<std::size_t>(own.fibers);
    ChainState<3> empty;
    empty.poses.resize(n), empty.velocity.resize(n), empty.spin.resize(n);
    state.groups.push_back(
        {.radius = own.radius,
         .oriented = true,
         .fibers = std::vector<ChainState<3>>(fibers, empty),
         .form = plan.form,
         .law_numbers = numbers,
         .bond_numbers = numbers,
         .histories = std::vector<double>(fibers * (n - 1) * static_cast<std::size_t>(numbers)),
         .loads = std::vector<double>(fibers * n * load_size)});
  }
  for (const SphereRecord& s : all.spheres) {
    const auto g = static_cast<std::size_t>(s.group);
    CarriedGroup& group = state.groups[g];
    const auto n = static_cast<std::size_t>(plan.groups[g].spheres);
    const auto of_group = static_cast<std::size_t>(s.number) - static_cast<std::size_t>(plan.groups[g].first);
    const std::size_t f = of_group / n, i = of_group % n;
    ChainState<3>& fiber = group.fibers[f];
    fiber.poses[i] = {three(s.position), {s.orientation[0], three(s.orientation + 1)}};
    fiber.velocity[i] = three(s.velocity), fiber.spin[i] = three(s.spin);
    std::copy_n(s.load, 6, group.loads.data() + of_group * load_size);
    if (numbers > 0 && i + 1 < n)
      std::copy_n(s.history, bond_history_size,
                  group.histories.data() + (f * (n - 1) + i) * bond_history_size);
  }
  for (const ContactRecord& c : all.contacts) {
    SavedContact contact{.key = {primitive_of(static_cast<std::int64_t>(c.first)),
                                 primitive_of(static_cast<std::int64_t>(c.second)), 0}};
    std::copy_n(c.history, contact_history_size, contact.history);
    state.contacts.push_back(contact);
  }
  return state;
}

Assembly assembly_of(const Assembly& before, const CarriedState& state, const Plan& plan,
                     const MarchRecord& record, const PackingScene& scene, std::int64_t steps) {
  std::vector<FiberGroup> groups;
  for (int g = 0; g < before.groups(); ++g)
    groups.push_back({before.chain(g), state.groups[static_cast<std::size_t>(g)].fibers});
  Domain domain = plan.domain;
  for (std::size_t w = 0; w < domain.walls.size(); ++w) {
    if (std::optional<WallDrive>& drive = domain.walls[w].motion.drive)
      drive->shift = record.walls[w * wall_record_size + wall_record_size - 2];
  }
  AssemblyOptions options{.step = plan.step, .form = plan.form, .orientations = scene.orientations};
  options.placed_anywhere = true;
  options.sort_in_space = false;
  options.allow_passage = true;  // the engine looks for it itself
  options.steps_before = steps;
  options.time_shift = plan.time_shift;
  Assembly assembly(std::move(groups), std::move(domain), options);
  assembly.take_over(state);
  assembly.adopt(record);
  return assembly;
}

}  // namespace

Outgoing outgoing(const Assembly& assembly, const PackingScene& scene) {
  const SavedState saved = assembly.saved();
  const CarriedState state = carried_state(saved);
  Outgoing all{.plan = plan_of_assembly(assembly, scene, reals(saved, "time_shift").front()),
               .steps = assembly.steps(),
               .record = assembly.record(),
               .contacts = {},
               .spheres = {}};
  const std::vector<double>& steps_back = reals(saved, "block_previous_step");
  if (std::ranges::any_of(steps_back, [](double step) { return step > 0; })) {
    // histories of bonds a step back: through an assembly that moves them on
    return outgoing(assembly_of(assembly, state, all.plan, all.record, scene, all.steps), scene);
  }
  all.spheres = spheres_of(state, all.plan);
  for (const SavedContact& contact : state.contacts) {
    ContactRecord record{static_cast<double>(to_number(contact.key.first)),
                         static_cast<double>(to_number(contact.key.second)),
                         {}};
    std::copy_n(contact.history, contact_history_size, record.history);
    all.contacts.push_back(record);
  }
  find_box(all);
  return all;
}

void broadcast(Outgoing& all, const PackingScene& scene, MPI_Comm world, int me) {
  const auto bytes = [&](void* from, std::size_t size) {
    constexpr std::size_t most = 1 << 30;  // MPI counts in int
    for (std::size_t at = 0; at < size; at += most)
      MPI_Bcast(static_cast<char*>(from) + at, static_cast<int>(std::min(most, size - at)), MPI_BYTE, 0,
                world);
  };
  const auto list = [&]<class Value>(std::vector<Value>& values) {
    std::uint64_t size = values.size();
    bytes(&size, sizeof size);
    values.resize(size);
    bytes(values.data(), size * sizeof(Value));
  };
  Plan& plan = all.plan;
  if (me != 0) plan.domain = scene.domain, plan.form = scene.form;
  list(plan.groups), list(plan.pair_parameters), list(plan.wall_parameters);
  list(all.contacts), list(all.record.walls);
  const auto flag = [](bool set) { return set ? 1.0 : 0.0; };
  double numbers[] = {plan.step,
                      plan.time_shift,
                      plan.law_reach,
                      plan.skin,
                      static_cast<double>(plan.contact_kinds),
                      flag(plan.rolls),
                      static_cast<double>(all.steps),
                      all.low[0],
                      all.low[1],
                      all.low[2],
                      all.high[0],
                      all.high[1],
                      all.high[2],
                      all.record.deepest_overlap,
                      all.record.longest_path,
                      flag(plan.oriented)};
  bytes(numbers, sizeof numbers);
  plan.step = numbers[0], plan.time_shift = numbers[1], plan.law_reach = numbers[2], plan.skin = numbers[3];
  plan.contact_kinds = static_cast<std::int32_t>(numbers[4]), plan.rolls = numbers[5] != 0;
  all.steps = static_cast<std::int64_t>(numbers[6]);
  for (int c = 0; c < 3; ++c) all.low[c] = numbers[7 + c], all.high[c] = numbers[10 + c];
  all.record.deepest_overlap = numbers[13], all.record.longest_path = numbers[14];
  plan.oriented = numbers[15] != 0;
}

void check_finite(const Gathered& all, const Plan& plan, std::int64_t steps) {
  const auto blown_up = [&](double number) {
    return Diverged(
        fmt::format("the run blew up: sphere {} before step {} (dt = {:.6g} s, t = {:.6g} s); likely cause: "
                    "a step too long "
                    "for the bonds or for how hard contacts press",
                    number, steps, plan.step, plan.time(steps)));
  };
  std::vector<bool> there(static_cast<std::size_t>(plan.spheres()));
  for (const SphereRecord& s : all.spheres) {
    double sum = 0;
    for (int c = 0; c < 3; ++c) sum += s.position[c] + s.velocity[c] + s.spin[c];
    if (!std::isfinite(sum)) throw blown_up(s.number);
    there[static_cast<std::size_t>(s.number)] = true;
  }
  const auto missing = std::ranges::find(there, false);
  if (missing != there.end()) throw blown_up(static_cast<double>(missing - there.begin()));
}

Assembly assembly_of(const Assembly& before, const Gathered& all, const Plan& plan, const PackingScene& scene,
                     std::int64_t steps) {
  return assembly_of(before, carried_of(all, plan, steps), plan, all.record, scene, steps);
}

}  // namespace fiberchain::dem::mpi
