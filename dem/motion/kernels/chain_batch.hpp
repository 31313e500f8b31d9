#pragma once

#include <vector>

#include "dem/chain/chain_state.hpp"
#include "dem/model/fluid.hpp"
#include "dem/model/loads.hpp"
#include "dem/motion/kernels/chain_kernel.hpp"
#include "dem/simd/lane_array.hpp"

// Chains of equal length marched side by side, one a lane.
namespace fiberchain::dem {

/// A block of up to `width` chains that march together. Unused lanes repeat the last chain. One chain alone
/// lies along the lanes where that is built; it then differs from the same chain among others by round-off.
template <int Dim>
class ChainBatch {
 public:
  /// Starts the chains from rest at their own poses. All must have the same number of bonds, and all be
  /// straight at rest or none. Throws InvalidInput otherwise.
  ChainBatch(const std::vector<Chain<Dim>>& chains, Clamps clamps, const std::vector<double>& steps,
             const std::vector<double>& drag, const Physics& physics, InstructionSet set);

  int lanes() const { return lanes_; }
  int width() const { return kernel_.width; }

  /// From the next step on the end loads go from `from` to `to` in `ramp_steps` steps.
  void set_ramp(int lane, const Boundary<Dim>& from, const Boundary<Dim>& to, double ramp_steps);

  /// The fluid around a lane's spheres and the time of its flow now [s]; without, a lane with fluid marches
  /// as in vacuum. Free draining only. Throws InvalidInput for a fluid that makes no sense or a physics
  /// without fluid.
  void set_fluid(int lane, const Fluid& fluid, double time = 0);
  /// Dead loads on any spheres of a lane with fluid, beside the ramp.
  void set_loads(int lane, const Boundary<Dim>& boundary);
  /// Goes on with another step: velocities move half the old one forward and half the new one back.
  void set_step(int lane, double step);

  /// Steps all lanes; ramp steps count from the last restart_ramp().
  void march(int steps);
  void restart_ramp() { steps_on_ramp_ = 0; }

  MovingSphere<double, Dim> sphere(int lane, int index) const { return sphere_in(spheres_, lane, index); }
  /// All of a lane with the velocities of this moment: half a step forward under the forces and the fluid at
  /// hand.
  std::vector<MovingSphere<double, Dim>> spheres_now(int lane) const;
  /// Sets pose, velocity and forces of a sphere; a clamped one gets no velocity.
  void set_sphere(int lane, int index, const MovingSphere<double, Dim>& sphere);
  /// Summed strain of a bond, its history in the incremental form; zero in another.
  BondHistory<double, Dim> history(int lane, int bond) const;
  void set_history(int lane, int bond, const BondHistory<double, Dim>& history);
  /// Histories of bonds that start in this state, whatever their law; Maxwell branches have relaxed.
  void start_histories(int lane, const Chain<Dim>& chain, const ChainState<Dim>& state);
  /// Numbers of a bond in the form's own layout: its history, then the strains of its Maxwell branches
  /// (dem/bond/laws/viscoelastic_bond.hpp).
  std::vector<double> bond_numbers(int lane, int bond) const;
  void set_bond_numbers(int lane, int bond, const std::vector<double>& numbers);

  /// Forces at the states now; then, with the loads of this moment and the velocities taken as those of this
  /// moment, moves the velocities half a step back, where the leapfrog wants them.
  void synchronize();
  Poses<Dim> poses(int lane) const;

  /// The whole state, to go back to; not past a set_step().
  std::vector<double> saved() const;
  void restore(const std::vector<double>& saved);

 private:
  /// What drags a lane's spheres, and the flow's time at a step.
  struct LaneFluid {
    StokesDrag drag{};
    Flow flow;
    double time = 0, step = 0;
  };

  ChainBatchView view();
  void start();
  /// Spheres with velocities half a step on, or back, where those of a chain depend on each other.
  LaneArray half_kicked(bool back) const;
  MovingSphere<double, Dim> sphere_in(const LaneArray& spheres, int lane, int index) const;
  int used(int lane) const { return lane < lanes_ ? lane : lanes_ - 1; }
  void put_parameters(int lane);
  /// Room for what bonds with branches keep.
  void start_memory(const Fiber& fiber);
  /// Branches of a lane in steps of dt. Throws InvalidInput where lanes do not have as many.
  void put_branches(int lane, double step);
  /// Gradients of the steps to come; one stands for all of a steady flow.
  void fill_gradients(int steps);
  Gradient gradient_now(int lane, int steps_ahead) const;
  EndLoad<double, Dim> load_now(int lane, int index) const;
  /// `s` half a step on, or back, under its forces and the loads and fluid of this moment.
  void move_half_step(int lane, int index, MovingSphere<double, Dim>& s, bool back) const;
  bool fixed(int sphere) const {
    return (sphere == 0 && clamps_.first) || (sphere == bonds_ && clamps_.last);
  }
  /// Places `stride` apart hold the numbers of element `i` (sphere, bond) of a lane, `size` numbers each.
  std::size_t place(int lane, int i, std::size_t size) const {
    return along_ ? i : i * size * kernel_.width + lane;
  }
  std::size_t stride() const { return along_ ? bonds_ + 2 : kernel_.width; }

  ChainKernel kernel_;
  BondForm form_;
  int lanes_;
  int bonds_;
  bool viscoelastic_;
  MemoryView memory_;
  Clamps clamps_;
  bool along_;
  bool fluid_, loaded_ = false, steady_ = true;
  double steps_on_ramp_ = 0, steps_in_fluid_ = 0;
  std::vector<Fiber> fibers_;
  std::vector<LaneFluid> fluids_;
  std::vector<MarchParameters<double, Dim>> parameters_of_;
  LaneArray spheres_, history_, natural_, parameters_, mobile_, loads_, workspace_, dead_, gradients_,
      branches_;
};

}  // namespace fiberchain::dem
