#include "dem/lammps/style_makers.hpp"

#include <algorithm>

#include "memory.h"
#include "neighbor.h"
#include "pair.h"
#include "update.h"

namespace fiberchain::dem::mpi {
namespace {

using namespace LAMMPS_NS;

/// Contacts by the laws of dem/contact: of pairs, and of spheres with walls.
class PairFiberchain : public Pair {
 public:
  explicit PairFiberchain(LAMMPS* lammps) : Pair(lammps), rank_(rank_of(lammps)) {
    no_virial_fdotr_compute = 1;
    single_enable = restartinfo = writedata = 0;
    finitecutflag = 1;
  }
  ~PairFiberchain() override {
    if (allocated == 0 || copymode != 0) return;
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }

  void settings(int, char**) override {}
  void coeff(int, char**) override {
    const int n = atom->ntypes + 1;
    if (allocated == 0) {
      memory->create(setflag, n, n, "pair:setflag");
      memory->create(cutsq, n, n, "pair:cutsq");
    }
    allocated = 1;
    for (int i = 0; i < n; ++i) std::fill_n(setflag[i], n, 1), std::fill_n(cutsq[i], n, 0.0);
  }
  void init_style() override { neighbor->request(this, instance_me); }
  double init_one(int i, int j) override {
    return rank_.plan.groups[group_of_type(i)].radius + rank_.plan.groups[group_of_type(j)].radius +
           rank_.plan.law_reach;
  }

  void compute(int eflag, int vflag) override {
    ev_init(eflag, vflag);
    const int all = atom->nlocal + atom->nghost;
    RankContacts& contacts = rank_.contacts;
    if (update->setupflag != 0) {  // the forces of its first moment are there already
      for (int i = 0; i < atom->nlocal; ++i) add_load(i);
      return;
    }
    if (contacts.stale()) {
      for (int i = 0; i < all; ++i) put_row(rank_.rows, *atom, i);
      contacts.prune(rank_.rows, all);
    } else {
      for (const std::int32_t i : contacts.near()) put_row(rank_.rows, *atom, i);
    }
    contacts.work_out(rank_.rows, all, rank_.plan.time(update->ntimestep));
    for (const std::int32_t i : contacts.loaded()) {
      if (i < atom->nlocal) add_load(i);
    }
  }

 private:
  void add_load(int i) {
    const double* load = rank_.rows.load_of(static_cast<std::size_t>(i));
    for (int c = 0; c < 3; ++c) atom->f[i][c] += load[c], atom->torque[i][c] += load[moment_offset + c];
  }

  Rank& rank_;
};

}  // namespace

Pair* make_pair_style(LAMMPS* lammps) { return new PairFiberchain(lammps); }

}  // namespace fiberchain::dem::mpi
