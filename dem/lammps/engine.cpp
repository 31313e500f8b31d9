#include "dem/lammps/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "atom.h"
#include "dem/lammps/carried_keys.hpp"
#include "dem/lammps/exchange.hpp"
#include "dem/lammps/rank.hpp"
#include "dem/lammps/resources.hpp"
#include "dem/lammps/styles.hpp"
#include "dem/model/errors.hpp"
#include "domain.h"
#include "fix.h"
#include "input.h"
#include "lammps.h"
#include "library.h"
#include "modify.h"
#include "update.h"

namespace fiberchain::dem::mpi {
namespace {

using LAMMPS_NS::LAMMPS;

enum class Command : std::int32_t { send_out, march, gather, cost, dismiss };

struct Order {
  std::int64_t command, steps;
};

/// The largest overlap and path that bodies do not pass through each other with, as Assembly has them.
constexpr double deepest_passable = 1, longest_passable = 0.5;

}  // namespace

struct Engine::State {
  MPI_Comm world;
  int me = 0, ranks = 1;
  PackingScene scene;
  Sharing sharing;
  std::unique_ptr<LAMMPS> lammps;
  std::unique_ptr<Rank> rank;
  bool set_up = false;            ///< LAMMPS has forces and lists of this moment
  std::int64_t sent_spheres = 0;  ///< rank 0: of the assembly that was sent out or came back last
  std::int64_t sent_step = -1;
  Spread spread;
  double memory_before = 0;  ///< [bytes]

  void command(const std::string& line) { lammps->input->one(line); }

  void forget() {
    if (lammps) forget_styles(*lammps);
    lammps.reset();
    rank.reset();
  }

  /// A LAMMPS without spheres, its box that of all.
  void make_lammps(Plan plan, const double* low, const double* high) {
    forget();
    rank = std::make_unique<Rank>(std::move(plan), best_instruction_set());
    const char* arguments[] = {"fiberchain-mpi", "-log", "none", "-screen", "none"};
    lammps = std::make_unique<LAMMPS>(5, const_cast<char**>(arguments), world);
    register_styles(*lammps, *rank);
    const Plan& p = rank->plan;
    std::string boundary = "boundary";
    for (int c = 0; c < 3; ++c) boundary += p.domain.period[c] > 0 ? " p" : " s";
    const std::size_t groups = p.groups.size();
    for (const std::string& line : std::vector<std::string>{
             "units si", "newton off on", "atom_style hybrid sphere bond", "atom_modify map hash sort 0 0",
             boundary, sharing == Sharing::tiles ? "comm_style tiled" : "comm_style brick",
             fmt::format("region all block {} {} {} {} {} {} units box", low[0], high[0], low[1], high[1],
                         low[2], high[2]),
             fmt::format("create_box {} all bond/types {} extra/bond/per/atom 1", 2 * groups, groups),
             "comm_modify vel yes", fmt::format("neighbor {} bin", p.skin),
             "neigh_modify delay 0 every 1 check yes one 4000 page 400000", "pair_style fiberchain",
             "pair_coeff * *", "bond_style fiberchain", "bond_coeff *", fmt::format("timestep {}", p.step),
             "thermo_style custom step", "thermo 0"})
      command(line);
  }

  void add_spheres(const SphereRecord* records, std::size_t count);
  void add_contacts(const std::vector<ContactRecord>& contacts);
  void send_out(const Assembly* assembly);
  void run(std::int64_t steps);
  Gathered gather();
  Cost cost(std::int64_t steps);
};

/// Those that are this rank's are kept, with all that belongs to them.
void Engine::State::add_spheres(const SphereRecord* records, std::size_t count) {
  std::vector<int> tags, types, images;
  std::vector<double> x, v;
  const Plan& plan = rank->plan;
  for (std::size_t n = 0; n < count; ++n) {
    const SphereRecord& s = records[n];
    tags.push_back(static_cast<int>(s.number) + 1);
    const auto group = static_cast<std::size_t>(s.group);
    const auto place =
        (static_cast<std::int64_t>(s.number) - plan.groups[group].first) % plan.groups[group].spheres;
    types.push_back(type_of(group, place == 0 || place + 1 == plan.groups[group].spheres));
    int turns[3];
    for (int c = 0; c < 3; ++c) {
      const double period = plan.domain.period[c];
      turns[c] =
          period > 0 ? static_cast<int>(std::floor((s.position[c] - lammps->domain->boxlo[c]) / period)) : 0;
      x.push_back(s.position[c] - turns[c] * period);
      v.push_back(s.velocity[c]);
    }
    images.push_back(lammps_encode_image_flags(turns[0], turns[1], turns[2]));
  }
  const int before = lammps->atom->nlocal;
  lammps_create_atoms(lammps.get(), static_cast<int>(count), tags.data(), types.data(), x.data(), v.data(),
                      images.data(), 0);
  LAMMPS_NS::Atom& atom = *lammps->atom;
  rank->rows.grow(static_cast<std::size_t>(atom.nmax));
  const auto first_tag = static_cast<int>(records[0].number) + 1;
  for (int i = before; i < atom.nlocal; ++i) {
    const SphereRecord& s = records[atom.tag[i] - first_tag];
    const GroupNumbers& group = plan.groups[static_cast<std::size_t>(s.group)];
    const auto at = static_cast<std::size_t>(i);
    std::copy_n(s.spin, 3, atom.omega[i]);
    atom.radius[i] = group.radius;
    atom.rmass[i] = group.mass * (is_end_type(atom.type[i]) ? group.march.end_share : 1);
    const auto place = (static_cast<std::int64_t>(s.number) - group.first) % group.spheres;
    atom.num_bond[i] = place + 1 < group.spheres ? 1 : 0;
    if (atom.num_bond[i] == 1) {
      atom.bond_type[i][0] = static_cast<int>(s.group) + 1;
      atom.bond_atom[i][0] = atom.tag[i] + 1;
    }
    std::copy_n(s.orientation, quaternion_size, rank->rows.orientation_of(at));
    std::fill_n(rank->rows.load_of(at), load_size, 0.0);
    std::copy_n(s.load, 6, rank->rows.load_of(at));
    std::copy_n(s.history, bond_history_size, rank->rows.history_of(at));
    rank->rows.contacts[at].clear();
  }
}

void Engine::State::add_contacts(const std::vector<ContactRecord>& contacts) {
  const ContactLaw& law = law_of(rank->plan.domain.contacts);
  LAMMPS_NS::Atom& atom = *lammps->atom;
  const auto give = [&](double to, double partner, const double* history, bool exchanged) {
    const int i = atom.map(static_cast<int>(to) + 1);
    if (i < 0 || i >= atom.nlocal) return;
    TravellingContact contact{partner, {}};
    std::copy_n(history, contact_history_size, contact.history);
    if (exchanged) law.exchange_bodies(contact.history);
    rank->rows.contacts[static_cast<std::size_t>(i)].push_back(contact);
  };
  for (const ContactRecord& c : contacts) {
    give(c.first, c.second, c.history, false);
    if (c.second >= 0) give(c.second, c.first, c.history, true);
  }
}

void Engine::State::send_out(const Assembly* assembly) {
  Outgoing all;
  if (me == 0) all = outgoing(*assembly, scene);
  broadcast(all, scene, world, me);
  make_lammps(all.plan, all.low, all.high);
  constexpr std::size_t chunk = 200000;
  std::vector<SphereRecord> some;
  const auto spheres = static_cast<std::size_t>(all.plan.spheres());
  for (std::size_t from = 0; from < spheres; from += chunk) {
    const std::size_t count = std::min(chunk, spheres - from);
    some.resize(count);
    if (me == 0) std::copy_n(all.spheres.begin() + static_cast<std::ptrdiff_t>(from), count, some.begin());
    MPI_Bcast(some.data(), static_cast<int>(count * sizeof(SphereRecord)), MPI_BYTE, 0, world);
    add_spheres(some.data(), count);
  }
  std::int64_t bonds = 0;
  for (const GroupNumbers& group : all.plan.groups) bonds += group.fibers * (group.spheres - 1);
  lammps->atom->nbonds = bonds;
  command("fix fiberchain all fiberchain");
  add_contacts(all.contacts);
  rank->contacts.set_wall_records(all.record.walls);
  rank->contacts.set_deepest(all.record.deepest_overlap);
  rank->longest_path = all.record.longest_path;
  command(fmt::format("reset_timestep {}", all.steps));
  lammps->modify->fix[lammps->modify->nfix - 1]->setup_pre_exchange();  // knows what spheres take with them
  if (sharing == Sharing::tiles && ranks > 1) command("balance 1.05 rcb");
  set_up = false;
}

void Engine::State::run(std::int64_t steps) {
  command(fmt::format("run {} {} post no", steps, set_up ? "pre no" : "pre yes"));
  set_up = true;
}

Gathered Engine::State::gather() {
  LAMMPS_NS::Atom& atom = *lammps->atom;
  Rows& rows = rank->rows;
  std::vector<SphereRecord> own(static_cast<std::size_t>(atom.nlocal));
  const bool incremental = rank->plan.form == BondForm::incremental;
  for (int i = 0; i < atom.nlocal; ++i) {
    const auto at = static_cast<std::size_t>(i);
    SphereRecord& s = own[at];
    s.number = atom.tag[i] - 1;
    s.group = static_cast<double>(group_of_type(atom.type[i]));
    lammps->domain->unmap(atom.x[i], atom.image[i], s.position);
    std::copy_n(atom.v[i], 3, s.velocity);
    std::copy_n(atom.omega[i], 3, s.spin);
    std::copy_n(rows.orientation_of(at), quaternion_size, s.orientation);
    std::copy_n(rows.load_of(at), 6, s.load);
    if (incremental)
      std::copy_n(rank->history_before.data() + i * bond_history_size, bond_history_size, s.history);
  }
  std::vector<ContactRecord> contacts;
  rank->contacts.each([&](std::int32_t first, std::int64_t second, const double* history) {
    ContactRecord contact{static_cast<double>(atom.tag[first] - 1), static_cast<double>(second), {}};
    if (second >= 0) {
      contact.second = atom.tag[second] - 1;
      // of pairs that two ranks know, or two images, each knows its own sphere's side
      if (second >= atom.nlocal && contact.first > contact.second) return;
    }
    std::copy_n(history, contact_history_size, contact.history);
    contacts.push_back(contact);
  });
  Gathered all;
  all.spheres = gathered(own, world, me, ranks);
  all.contacts = gathered(contacts, world, me, ranks);
  const double most[2] = {rank->contacts.deepest(), rank->longest_path};
  double largest[2];
  MPI_Reduce(most, largest, 2, MPI_DOUBLE, MPI_MAX, 0, world);
  all.record = {largest[0], largest[1], rank->contacts.wall_records()};
  const std::int64_t counts[2] = {atom.nlocal, atom.nghost};
  MPI_Reduce(&counts[0], &spread.most, 1, MPI_INT64_T, MPI_MAX, 0, world);
  MPI_Reduce(&counts[1], &spread.ghosts, 1, MPI_INT64_T, MPI_SUM, 0, world);
  return all;
}

Engine::Cost Engine::State::cost(std::int64_t steps) {
  run(1);
  MPI_Barrier(world);
  const double began = MPI_Wtime(), worked = processor_time();
  run(steps);
  const double slowest = MPI_Wtime() - began,
               own[] = {processor_time() - worked, static_cast<double>(lammps->atom->nghost),
                        resident_memory() - memory_before};
  double sums[3] = {};
  Cost all;
  MPI_Reduce(&slowest, &all.wall, 1, MPI_DOUBLE, MPI_MAX, 0, world);
  MPI_Reduce(own, sums, 3, MPI_DOUBLE, MPI_SUM, 0, world);
  all.processor = sums[0], all.ghosts = sums[1], all.memory = sums[2];
  return all;
}

Engine::Engine(MPI_Comm world, const PackingScene& scene, Sharing sharing)
    : state_(std::make_unique<State>()) {
  refuse_what_is_not_carried(scene);
  state_->world = world;
  state_->scene = scene;
  state_->sharing = sharing;
  MPI_Comm_rank(world, &state_->me);
  MPI_Comm_size(world, &state_->ranks);
  state_->memory_before = resident_memory();
}

Engine::~Engine() { state_->forget(); }

namespace {

void give_order(MPI_Comm world, Command command, std::int64_t steps = 0) {
  Order order{static_cast<std::int64_t>(command), steps};
  MPI_Bcast(&order, 2, MPI_INT64_T, 0, world);
}

}  // namespace

void Engine::send_out(const Assembly& assembly) {
  give_order(state_->world, Command::send_out);
  state_->send_out(&assembly);
  state_->sent_spheres = assembly.spheres(), state_->sent_step = assembly.steps();
}

void Engine::march(Assembly& assembly, std::int64_t steps) {
  State& s = *state_;
  if (s.sent_spheres != assembly.spheres() || s.sent_step != assembly.steps()) send_out(assembly);
  // those that write files begin intervals of the walls' forces
  give_order(s.world, Command::march, steps);
  std::vector<double> walls = assembly.record().walls;
  MPI_Bcast(walls.data(), static_cast<int>(walls.size()), MPI_DOUBLE, 0, s.world);
  s.rank->contacts.set_wall_records(walls);
  s.run(steps);
  give_order(s.world, Command::gather);
  const Gathered all = s.gather();
  const std::int64_t now = assembly.steps() + steps;
  check_finite(all, s.rank->plan, now);
  assembly = assembly_of(assembly, all, s.rank->plan, s.scene, now);
  s.sent_step = now;
  const double path = all.record.longest_path / s.rank->plan.smallest_radius();
  if (s.scene.allow_unstable) return;
  if (all.record.deepest_overlap > deepest_passable || path > longest_passable)
    throw Diverged(fmt::format(
        "bodies may have passed through each other or through a wall before step {} (t = {:.6g} s): the "
        "deepest "
        "overlap was {:.3g} of the smaller radius, the longest path of a step {:.3g} of the smallest",
        now, s.rank->plan.time(now), all.record.deepest_overlap, path));
}

Engine::Cost Engine::cost(const Assembly& assembly, std::int64_t steps) {
  send_out(assembly);
  give_order(state_->world, Command::cost, steps);
  return state_->cost(steps);
}

void Engine::dismiss() { give_order(state_->world, Command::dismiss); }

void Engine::serve() {
  State& s = *state_;
  while (true) {
    Order order{};
    MPI_Bcast(&order, 2, MPI_INT64_T, 0, s.world);
    switch (static_cast<Command>(order.command)) {
      case Command::send_out:
        s.send_out(nullptr);
        break;
      case Command::march: {
        std::vector<double> walls(s.rank->contacts.wall_records().size());
        MPI_Bcast(walls.data(), static_cast<int>(walls.size()), MPI_DOUBLE, 0, s.world);
        s.rank->contacts.set_wall_records(walls);
        s.run(order.steps);
        break;
      }
      case Command::gather:
        s.gather();
        break;
      case Command::cost:
        s.cost(order.steps);
        break;
      case Command::dismiss:
        return;
    }
  }
}

void Engine::run_script(const std::string& path) {
  if (state_->lammps) return state_->lammps->input->file(path.c_str());
  const char* arguments[] = {"fiberchain-mpi", "-log", "none"};
  LAMMPS lammps(3, const_cast<char**>(arguments), state_->world);
  lammps.input->file(path.c_str());
}

Engine::Spread Engine::spread() const { return state_->spread; }

}  // namespace fiberchain::dem::mpi
