#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "dem/assembly/packing_law.hpp"
#include "dem/bond/laws/failing_bond.hpp"
#include "dem/chain/chain_state.hpp"
#include "dem/chain/sphere_storage.hpp"
#include "dem/model/domain.hpp"
#include "dem/motion/half_step.hpp"
#include "dem/motion/kernels/packing_kernel.hpp"
#include "dem/motion/moving_sphere.hpp"
#include "dem/parallel/force_buffers.hpp"

namespace fiberchain::dem {

/// Shared by all blocks of a group: physics, kernel and parameters.
struct GroupKind {
  Chain<3> chain;
  const PackingLaw* law;  ///< of its bonds
  const PackingKernel* kernel;
  MarchParameters<double, 3> parameters;
  LaneArray histories;      ///< of the bonds, block after block
  LaneArray lane_branches;  ///< Maxwell branches of a bond, the same in every lane
  MemoryView memory;        ///< of a bond
  LaneArray lane_parameters,
      lane_natural;             ///< parameters and natural ends of the chain, the same in every lane
  StokesDrag drag;              ///< zero without fluid
  Vec<double, 3> weight;        ///< of a sphere that is not an end [N]
  double mass, inertia;         ///< of a sphere that is not an end [kg], [kg m^2]
  double bearable_tension = 0;  ///< of bonds that are solved for, at this step [N]
  HalfStep half, end_half;      ///< of a sphere that is not an end, of one that is

  int spheres() const { return chain.fiber.aspect_ratio + 1; }
  double share(int sphere) const { return mass_share(chain.fiber, sphere); }
  const HalfStep& half_of(int sphere) const {
    return sphere == 0 || sphere == chain.fiber.aspect_ratio ? end_half : half;
  }
  /// Numbers of a block's history.
  std::size_t history_size() const {
    return chain.fiber.aspect_ratio * memory.bond * static_cast<std::size_t>(kernel->width);
  }
  /// The history of a bond in a block's histories, its numbers `kernel->width` apart.
  template <class Number>
  Number* history_of(Number* block, int lane, int bond) const {
    return block + bond * memory.bond * static_cast<std::size_t>(kernel->width) + lane;
  }
};

/// Throws InvalidInput where the physics of these fibers is not built.
GroupKind group_kind(const Chain<3>& chain, std::size_t fibers, const AssemblyOptions& options,
                     const Domain& domain, double step);

/// A block's spheres at this moment: forces of bonds, contacts and weight with them, the bonds' strains moved
/// on to now.
struct BlockSnapshot {
  LaneArray spheres, history;
  LaneArray workspace;  ///< of the kernel
};

/// Up to `width` fibers of one group in the lanes of a kernel, with their bond histories; spheres are in
/// SphereStorage.
class FiberBlock {
 public:
  /// Block `number` of its kind: fibers with consecutive rows from `first` on, which are set from the states;
  /// `numbers` are those that they have in the group.
  FiberBlock(GroupKind& kind, int group, int number, std::int64_t first,
             const std::vector<ChainState<3>>& fibers, const std::vector<std::int32_t>& numbers,
             bool accounted, SphereStorage& rows);

  int group() const { return group_; }
  int lanes() const { return lanes_; }
  bool moved() const { return previous_step_ > 0; }  ///< has made a step
  std::int64_t first(int lane) const { return first_[lane]; }
  std::int64_t end(const GroupKind& kind) const { return first_[lanes_ - 1] + kind.spheres(); }

  /// Sets the velocities, given at this moment, half a step back.
  void start(const GroupKind& kind, SphereStorage& rows, LoadRange loads, const double* gradient,
             const Gradient& A);

  /// One step; the loads have acted and are zero then. Returns the square of the largest speed. `next` is
  /// stepped after it, if any.
  double step(const GroupKind& kind, SphereStorage& rows, LoadRange loads, LaneArray& scratch,
              const double* gradient, const FiberBlock* next, std::int64_t rows_ahead);
  /// Before a step: accounts the energy dissipated by the bonds in the last one.
  void account(const GroupKind& kind, SphereStorage& rows, LaneArray& scratch);

  BlockSnapshot snapshot(const GroupKind& kind, const SphereStorage& rows, LoadRange loads,
                         const double* gradient) const;
  /// Into the arrays of another one, which are kept if they fit. With `may_break` bonds break in it as they
  /// will in the next step.
  void snapshot(const GroupKind& kind, const SphereStorage& rows, LoadRange loads, const double* gradient,
                BlockSnapshot& into, bool may_break = false) const;
  MovingSphere<double, 3> sphere(const GroupKind& kind, const BlockSnapshot& snapshot, int lane,
                                 int index) const;
  /// Velocities of a snapshot half a step on where those of a fiber's spheres depend on each other; else they
  /// stay and each follows from its sphere's forces (move_half_step).
  void to_this_moment(const GroupKind& kind, const SphereStorage& rows, LoadRange loads,
                      const double* gradient, BlockSnapshot& snapshot) const;

  /// Histories of its bonds at the last step.
  const double* histories() const { return history_; }
  double* histories() { return history_; }
  /// Whether a bond is broken; never where the law has no broken bonds.
  bool is_broken(const GroupKind& kind, int lane, int bond) const {
    return kind.law->intact_place >= 0 && *intact(kind, kind.history_of(history_, lane, bond)) == 0;
  }
  /// Breaks a bond for good, one of the library's laws in the next step. Throws InvalidInput where the law
  /// has no broken bonds.
  void break_bond(const GroupKind& kind, int lane, int bond);
  /// Whether bonds have broken in the last step.
  bool has_breaks() const { return has_breaks_; }
  /// A bond that has.
  struct Broken {
    int lane, bond;
    BondFailure<double> failure;
  };
  /// Those, which are broken from then on: lane by lane along the fibers.
  std::vector<Broken> settle_breaks(const GroupKind& kind);
  /// Plastic work counts from now on; how many of its bonds are broken.
  std::int64_t begin_failures(const GroupKind& kind);
  /// What bonds of the lanes bear, of fibers with these numbers; strengths that are given anew.
  void put_limits(const GroupKind& kind, const std::vector<std::int32_t>& numbers);

  /// Since the start, up to this moment but for half of the kick that is centered on it [J].
  struct Taken {
    double damping, friction, scheme;
  };
  Taken taken(const GroupKind& kind, const SphereStorage& rows) const;
  /// Of its bonds since this was asked last.
  BondExtremes take_extremes() { return std::exchange(extremes_, {}); }
  double fluid_dissipation() const { return fluid_dissipated_; }  ///< so far [J]
  void add_fluid_dissipation(double energy) { fluid_dissipated_ += energy; }

  /// All state beyond the spheres' rows: previous step, energy dissipated by the fluid, bond histories,
  /// workspace, loads of the previous step for the energy account, dissipated energies.
  std::array<std::span<double>, 6> saved_arrays();
  /// Those of them that lie in lanes and that fibers take with them to another place. What they have
  /// dissipated stays: only its sum counts.
  static constexpr std::array moved_arrays{2, 3, 4};

 private:
  static double* intact(const GroupKind& kind, double* history) {
    return history + kind.law->intact_place * static_cast<std::size_t>(kind.kernel->width);
  }
  BondFailure<double> failure(const GroupKind& kind, int lane, int bond) const;
  void put(const GroupKind& kind, int lane, int bond, const BondFailure<double>& failure);
  bool look_for_breaks(const GroupKind& kind) const;
  PackingBlock snapshot_view(const GroupKind& kind, const SphereStorage& rows, LoadRange loads,
                             const double* gradient, BlockSnapshot& into) const;
  PackingBlock view(const GroupKind& kind, SphereStorage& rows, LoadRange loads, LaneArray& scratch,
                    const double* gradient);

  int group_, lanes_;
  double* history_;  ///< in the kind's histories
  std::size_t history_size_;
  double previous_step_ = 0, fluid_dissipated_ = 0;
  std::vector<std::int64_t> first_;
  bool has_breaks_ = false;
  BondExtremes extremes_;
  LaneArray workspace_, previous_, dissipated_;
};

}  // namespace fiberchain::dem
