#include "dem/lammps/style_makers.hpp"

#include <algorithm>
#include <utility>

#include "bond.h"
#include "dem/lammps/bond_kernel.hpp"
#include "error.h"
#include "memory.h"
#include "neighbor.h"
#include "update.h"

namespace fiberchain::dem::mpi {
namespace {

using namespace LAMMPS_NS;

/// Bonds by the laws of dem/bond, of the group that is the bond's type.
class BondFiberchain : public Bond {
 public:
  explicit BondFiberchain(LAMMPS* lammps) : Bond(lammps), rank_(rank_of(lammps)) {}
  ~BondFiberchain() override {
    if (allocated != 0 && copymode == 0) memory->destroy(setflag);
  }

  void coeff(int, char**) override {
    if (allocated == 0) memory->create(setflag, atom->nbondtypes + 1, "bond:setflag");
    allocated = 1;
    std::fill_n(setflag, atom->nbondtypes + 1, 1);
  }
  double equilibrium_distance(int type) override {
    return 1 / rank_.plan.groups[static_cast<std::size_t>(type - 1)].march.inverse_length;
  }
  void write_restart(FILE*) override { refuse_restart(); }
  void read_restart(FILE*) override { refuse_restart(); }
  double single(int, double, int, int, double& pull) override { return pull = 0; }

  /// LAMMPS lists bonds anew with the neighbors, in any order.
  void compute(int eflag, int vflag) override {
    ev_init(eflag, vflag);
    if (neighbor->ago == 0 || update->setupflag != 0 || lists_.size() != rank_.plan.groups.size())
      sort_bonds();
    const bool last = update->ntimestep == update->laststep && rank_.plan.form == BondForm::incremental;
    if (last) {
      const double* now = rank_.rows.history.data();
      rank_.history_before.assign(now, now + static_cast<std::ptrdiff_t>(atom->nlocal) * bond_history_size);
    }
    for (std::size_t g = 0; g < lists_.size(); ++g) {
      if (lists_[g].count == 0) continue;
      const GroupNumbers& fibers = rank_.plan.groups[g];
      bond_kernel(rank_.plan.form, fibers.damped, set_for_rows(rank_, *atom))
          .act({.first = lists_[g].first.data(),
                .second = lists_[g].second.data(),
                .count = lists_[g].count,
                .position = &atom->x[0][0],
                .velocity = &atom->v[0][0],
                .spin = &atom->omega[0][0],
                .orientation = rank_.rows.orientation.data(),
                .history = rank_.rows.history.data(),
                .force = &atom->f[0][0],
                .torque = &atom->torque[0][0],
                .parameters = &fibers.march.bond,
                .inverse_length = fibers.march.inverse_length,
                .step = update->setupflag != 0 ? 0.0 : rank_.plan.step});
    }
  }

 private:
  struct List {
    std::vector<std::int32_t> first, second;
    std::int32_t count = 0;
  };

  [[noreturn]] void refuse_restart() {
    error->all(
        FLERR,
        std::string("restart files of LAMMPS do not have the memory of fiberchain's bonds and contacts: "
                    "use its own checkpoints"));
  }

  void sort_bonds() {
    std::vector<std::vector<SlotPair>> bonds(rank_.plan.groups.size());
    for (int n = 0; n < neighbor->nbondlist; ++n) {
      int first = neighbor->bondlist[n][0], second = neighbor->bondlist[n][1];
      if (atom->tag[first] > atom->tag[second]) std::swap(first, second);
      bonds[static_cast<std::size_t>(neighbor->bondlist[n][2] - 1)].push_back({first, second});
    }
    lists_.resize(bonds.size());
    const int width = bond_kernel(rank_.plan.form, false, rank_.set).width;
    for (std::size_t g = 0; g < bonds.size(); ++g) {
      std::ranges::sort(bonds[g], {}, &SlotPair::first);
      List& list = lists_[g];
      list = {.first = {}, .second = {}, .count = static_cast<std::int32_t>(bonds[g].size())};
      for (const SlotPair& bond : bonds[g])
        list.first.push_back(bond.first), list.second.push_back(bond.second);
      while (!list.first.empty() && list.first.size() % static_cast<std::size_t>(width) != 0)
        list.first.push_back(list.first.back()), list.second.push_back(list.second.back());
    }
  }

  Rank& rank_;
  std::vector<List> lists_;
};

}  // namespace

Bond* make_bond_style(LAMMPS* lammps) { return new BondFiberchain(lammps); }

}  // namespace fiberchain::dem::mpi
