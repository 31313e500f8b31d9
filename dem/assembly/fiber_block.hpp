#pragma once

#include <vector>

#include "dem/assembly/sphere_rows.hpp"
#include "dem/assembly/stripe_loads.hpp"
#include "dem/assembly/surroundings.hpp"
#include "dem/motion/chain_state.hpp"
#include "dem/motion/lanes/row_kernel.hpp"
#include "dem/motion/state.hpp"

namespace fiberchain::dem {

/// What all blocks of fibers of one kind share.
struct FiberKind {
  Chain<3> chain;
  Physics physics;
  const RowKernel* kernel;
  MarchParameters<double, 3> parameters;
  LaneArray histories;  ///< of the bonds, block after block
  LaneArray lane_parameters, lane_natural;  ///< parameters and natural ends of the chain, the same in every lane
  StokesDrag drag;          ///< zero without fluid
  Vec<double, 3> weight;    ///< of a sphere [N]
  double mass, inertia;     ///< of a sphere [kg], [kg m^2]

  int spheres() const { return chain.fiber.aspect_ratio + 1; }
  /// Numbers of a block's history.
  std::size_t history_size() const {
    return chain.fiber.aspect_ratio * numbers_of<BondHistory<double, 3>> * static_cast<std::size_t>(kernel->width);
  }
};

FiberKind fiber_kind(const Chain<3>& chain, std::size_t fibers, const Physics& physics, const Surroundings& surroundings, double step,
                     InstructionSet set);

/// A block's spheres at this moment: forces of bonds, contacts and weight with them, the bonds' strains moved on to now.
struct BlockLook {
  LaneArray spheres, history;
};

/// Up to `width` fibers of one kind side by side: what their bonds remember. Their spheres lie in rows.
class FiberBlock {
 public:
  /// Block `number` of its kind: fibers with consecutive rows from `first` on, which are set from the states.
  FiberBlock(FiberKind& kind, int group, int number, std::int64_t first, const std::vector<ChainState<3>>& fibers, bool booked,
             SphereRows& rows);

  int group() const { return group_; }
  int lanes() const { return lanes_; }
  bool moved() const { return led_ > 0; }  ///< has made a step
  std::int64_t first(int lane) const { return first_[lane]; }
  std::int64_t end(const FiberKind& kind) const { return first_[lanes_ - 1] + kind.spheres(); }

  /// Velocities were those of the start's moment: half a step back they go.
  void start(const FiberKind& kind, SphereRows& rows, LoadRange loads, const double* gradient, const Gradient& A);

  /// One step; the loads have acted and are zero then. Returns the square of the largest speed. `next` is stepped after it,
  /// if any.
  double step(const FiberKind& kind, SphereRows& rows, LoadRange loads, LaneArray& scratch, const double* gradient,
              const FiberBlock* next, std::int64_t rows_ahead);
  /// Before a step: books what the bonds took in the last one.
  void book(const FiberKind& kind, SphereRows& rows, LaneArray& scratch);

  BlockLook look(const FiberKind& kind, const SphereRows& rows, LoadRange loads, const double* gradient) const;
  MovingSphere<double, 3> sphere(const FiberKind& kind, const BlockLook& look, int lane, int index) const;
  BondHistory<double, 3> history(const FiberKind& kind, const BlockLook& look, int lane, int bond) const;

  double bond_damping() const;   ///< taken so far [J]
  double bond_friction() const;  ///< taken so far [J]
  double fluid_taken() const { return fluid_taken_; }  ///< so far [J]
  void add_fluid_taken(double energy) { fluid_taken_ += energy; }

  /// The numbers that its rows do not hold.
  std::size_t saved_size() const;
  void save(std::vector<double>& to) const;
  const double* restore(const double* from);

 private:
  RowBlock view(const FiberKind& kind, SphereRows& rows, LoadRange loads, LaneArray& scratch, const double* gradient);

  int group_, lanes_;
  double* history_;  ///< in the kind's histories
  std::size_t history_size_;
  double led_ = 0, fluid_taken_ = 0;
  std::vector<std::int64_t> first_;
  LaneArray workspace_, kept_, taken_;
};

}  // namespace fiberchain::dem
