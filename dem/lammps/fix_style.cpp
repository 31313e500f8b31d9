#include "dem/lammps/style_makers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dem/lammps/bond_kernel.hpp"
#include "domain.h"
#include "fix.h"
#include "force.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair.h"
#include "update.h"

namespace fiberchain::dem::mpi {
namespace {

using namespace LAMMPS_NS;

/// Leapfrog with poses, what travels with a sphere, walls in motion.
class FixFiberchain : public Fix {
 public:
  FixFiberchain(LAMMPS* lammps, int count, char** arguments)
      : Fix(lammps, count, arguments), rank_(rank_of(lammps)) {
    time_integrate = 1;
    create_attribute = 1;
    comm_border = rank_.plan.oriented ? quaternion_size : 0;
    maxexchange_dynamic = 1;
    force_reneighbor = 1;
    nevery = 1;
    next_reneighbor = -1;
    FixFiberchain::grow_arrays(atom->nmax);
    atom->add_callback(Atom::GROW);
    if (rank_.plan.oriented) atom->add_callback(Atom::BORDER);
  }
  ~FixFiberchain() override {
    atom->delete_callback(id, Atom::GROW);
    if (rank_.plan.oriented) atom->delete_callback(id, Atom::BORDER);
  }

  int setmask() override {
    using namespace FixConst;
    return INITIAL_INTEGRATE | PRE_EXCHANGE | POST_NEIGHBOR | PRE_FORCE | END_OF_STEP;
  }

  void init() override {
    kicks_.assign(1, {});
    for (const GroupNumbers& fibers : rank_.plan.groups) {
      for (const bool is_end : {false, true}) {
        const SphereStep<double>& own = is_end ? fibers.march.end : fibers.march.inner;
        const double share = is_end ? fibers.march.end_share : 1;
        kicks_.push_back({own.impulse,
                          own.angular_impulse,
                          {share * fibers.weight[0], share * fibers.weight[1], share * fibers.weight[2]}});
      }
    }
  }
  void setup_pre_exchange() override { pre_exchange(); }
  void setup_post_neighbor() override { post_neighbor(); }

  void initial_integrate(int) override {
    const Plan& plan = rank_.plan;
    rank_.contacts.move_walls();
    double fastest = 0;
    double *x = &atom->x[0][0], *v = &atom->v[0][0], *w = &atom->omega[0][0];
    const double *f = &atom->f[0][0], *torque = &atom->torque[0][0];
    for (int i = 0; i < atom->nlocal; ++i, x += 3, v += 3, w += 3, f += 3, torque += 3) {
      const SphereKick& own = kicks_[static_cast<std::size_t>(atom->type[i])];
      for (int c = 0; c < 3; ++c) {
        v[c] += own.impulse * (f[c] + own.weight[c]);
        w[c] += own.angular_impulse * torque[c];
        x[c] += plan.step * v[c];
      }
      fastest = std::max(fastest, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    turn(0, atom->nlocal);
    const double own_path = plan.step * std::sqrt(fastest);
    MPI_Allreduce(&own_path, &path_, 1, MPI_DOUBLE, MPI_MAX, world);
    path_since_ += path_;
    // before the sum of paths is half of the skin none has gone so far: LAMMPS need not look at each
    neighbor->delay = path_since_ < 0.499 * neighbor->skin ? never : 0;
    rank_.longest_path = std::max(rank_.longest_path, path_ + wall_path());
  }

  void pre_exchange() override {
    rank_.contacts.unlist(rank_.rows, atom->nlocal, [this](int i) { return number_of(*atom, i); });
    std::size_t most = 0;
    for (int i = 0; i < atom->nlocal; ++i) most = std::max(most, rank_.rows.contacts[i].size());
    maxexchange = fixed_numbers + 1 + static_cast<int>(most) * contact_numbers;
  }

  void post_neighbor() override {
    for (int i = 0; i < atom->nlocal + atom->nghost; ++i) put_row(rank_.rows, *atom, i), put_kind(i);
    path_since_ = 0;
    rank_.contacts.set_turn_reach(turn_reach());
    list_pairs();
  }

  /// Ghosts have come; between two lists their orientations go on here as they do where they belong.
  void pre_force(int) override {
    if (neighbor->ago > 0) turn(atom->nlocal, atom->nlocal + atom->nghost);
    rank_.contacts.add_path(path_);
  }

  void end_of_step() override {
    const std::vector<double>& own = rank_.contacts.wall_loads();
    if (own.empty()) return;
    std::vector<double> all(own.size());
    MPI_Allreduce(own.data(), all.data(), static_cast<int>(own.size()), MPI_DOUBLE, MPI_SUM, world);
    rank_.contacts.end_forces(all, rank_.plan.time(update->ntimestep));
    next_reneighbor = rank_.contacts.walls_moved_far() ? update->ntimestep + 1 : -1;
  }

  void grow_arrays(int size) override { rank_.rows.grow(static_cast<std::size_t>(size)); }
  void copy_arrays(int from, int to, int) override {
    Rows& r = rank_.rows;
    const auto f = static_cast<std::size_t>(from), t = static_cast<std::size_t>(to);
    std::copy_n(r.orientation_of(f), quaternion_size, r.orientation_of(t));
    std::copy_n(r.load_of(f), load_size, r.load_of(t));
    std::copy_n(r.history_of(f), bond_history_size, r.history_of(t));
    r.contacts[t] = r.contacts[f];
  }
  void set_arrays(int i) override {
    Rows& r = rank_.rows;
    const auto at = static_cast<std::size_t>(i);
    std::fill_n(r.orientation_of(at), quaternion_size, 0.0);
    r.orientation_of(at)[0] = 1;
    std::fill_n(r.load_of(at), load_size, 0.0);
    std::fill_n(r.history_of(at), bond_history_size, 0.0);
    r.contacts[at].clear();
  }

  int pack_border(int count, int* spheres, double* buffer) override {
    for (int n = 0; n < count; ++n)
      std::copy_n(rank_.rows.orientation_of(static_cast<std::size_t>(spheres[n])), quaternion_size,
                  buffer + n * quaternion_size);
    return count * quaternion_size;
  }
  int unpack_border(int count, int first, double* buffer) override {
    std::copy_n(buffer, count * quaternion_size, rank_.rows.orientation_of(static_cast<std::size_t>(first)));
    return count * quaternion_size;
  }

  int pack_exchange(int i, double* buffer) override {
    Rows& r = rank_.rows;
    const auto at = static_cast<std::size_t>(i);
    double* to = std::copy_n(r.orientation_of(at), quaternion_size, buffer);
    to = std::copy_n(r.load_of(at), load_size, to);
    to = std::copy_n(r.history_of(at), bond_history_size, to);
    *to++ = static_cast<double>(r.contacts[at].size());
    for (const TravellingContact& contact : r.contacts[at]) {
      *to++ = contact.partner;
      to = std::copy_n(contact.history, contact_history_size, to);
    }
    return static_cast<int>(to - buffer);
  }
  int unpack_exchange(int i, double* buffer) override {
    Rows& r = rank_.rows;
    const auto at = static_cast<std::size_t>(i);
    const double* from = buffer;
    const auto take = [&](double* to, int numbers) { std::copy_n(from, numbers, to), from += numbers; };
    take(r.orientation_of(at), quaternion_size);
    take(r.load_of(at), load_size);
    take(r.history_of(at), bond_history_size);
    r.contacts[at].resize(static_cast<std::size_t>(*from++));
    for (TravellingContact& contact : r.contacts[at]) {
      contact.partner = *from++;
      take(contact.history, contact_history_size);
    }
    return static_cast<int>(from - buffer);
  }

 private:
  static constexpr int fixed_numbers = quaternion_size + load_size + bond_history_size;
  static constexpr int contact_numbers = 1 + contact_history_size;
  static constexpr int never = std::numeric_limits<int>::max();

  /// The pairs that LAMMPS has listed, bonded ones left out.
  void list_pairs() {
    const NeighList& list = *force->pair->list;
    std::vector<SlotPair> pairs;
    for (int n = 0; n < list.inum; ++n) {
      const int i = list.ilist[n];
      const GroupNumbers& fibers = rank_.plan.groups[group_of_type(atom->type[i])];
      for (int k = 0; k < list.numneigh[i]; ++k) {
        const int j = list.firstneigh[i][k] & NEIGHMASK;
        const auto [lower, higher] = std::minmax({number_of(*atom, i), number_of(*atom, j)});
        if (group_of_type(atom->type[j]) == group_of_type(atom->type[i]) && are_bonded(fibers, lower, higher))
          continue;
        pairs.push_back({i, j});
      }
    }
    rank_.contacts.list(rank_.rows, atom->nlocal, atom->nlocal + atom->nghost, pairs,
                        rank_.plan.time(update->ntimestep), [this](int i) { return number_of(*atom, i); });
  }

  /// What a step does to a sphere of a type.
  struct SphereKick {
    double impulse, angular_impulse, weight[3];
  };

  void turn(int begin, int end) {
    if (!rank_.plan.oriented) return;
    bond_kernel(rank_.plan.form, false, set_for_rows(rank_, *atom))
        .turn(rank_.rows.orientation.data(), &atom->omega[0][0], begin, end, rank_.plan.step);
  }

  void put_kind(int i) {
    const auto at = static_cast<std::size_t>(i);
    const GroupNumbers& fibers = rank_.plan.groups[group_of_type(atom->type[i])];
    rank_.rows.position_of(at)[radius_offset] = fibers.radius;
    rank_.rows.kind[at] = fibers.contact_kind;
  }

  /// Of the fastest wall in this step [m].
  double wall_path() const {
    double fastest = 0;
    const double time = rank_.plan.time(update->ntimestep);
    for (const Wall& wall : rank_.contacts.walls()) {
      if (is_at_rest(wall) || !is_active(wall, time)) continue;
      const WallVelocity now = velocity_at(wall, time);
      fastest =
          std::max(fastest, norm(now.velocity) + (turns_visibly(wall) ? norm(now.spin) * turn_reach() : 0));
    }
    return rank_.plan.step * fastest;
  }

  /// From where walls turn to the farthest corner of the box that holds all spheres [m].
  double turn_reach() const {
    double reach = 0;
    const double time = rank_.plan.time(update->ntimestep);
    for (const Wall& wall : rank_.contacts.walls()) {
      if (!turns_visibly(wall)) continue;
      const Vec<double, 3> center = pose_at(wall, time).center_now();
      double squared = 0;
      for (int c = 0; c < 3; ++c) {
        const double far =
            std::max(std::abs(domain->boxlo[c] - center[c]), std::abs(domain->boxhi[c] - center[c]));
        squared += far * far;
      }
      reach = std::max(reach, std::sqrt(squared));
    }
    return reach;
  }

  Rank& rank_;
  std::vector<SphereKick> kicks_;  ///< by type
  double path_ = 0;                ///< of the fastest sphere of all ranks in this step [m]
  double path_since_ = 0;          ///< sum of those since lists were made [m]
};

}  // namespace

Fix* make_fix_style(LAMMPS* lammps, int count, char** arguments) {
  return new FixFiberchain(lammps, count, arguments);
}

}  // namespace fiberchain::dem::mpi
