#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "dem/assembly/assembly.hpp"
#include "dem/assembly/held_kick.hpp"
#include "dem/contact/wall_record.hpp"
#include "dem/model/grip.hpp"

namespace fiberchain::dem {

/// Spheres that grips hold or load. Between the kick and the next forces their velocities and places are set
/// to those of the grip, and what that takes of impulse is the grip's: outside of the lanes, and only for
/// blocks that have such spheres. Where bonds are solved for, a fiber that is held is solved for once more
/// with what is held given.
class HeldSpheres {
 public:
  HeldSpheres() = default;
  /// Throws InvalidKey for spheres that are not there, held twice, or by a grip that cannot hold them.
  HeldSpheres(std::vector<Grip> grips, const std::vector<FiberGroup>& groups, double step);

  bool any() const { return !spheres_.empty(); }
  /// Finds the blocks and parts that they are in now.
  void locate(const Assembly::State& s);
  bool in_block(std::size_t block) const { return any() && !of_block_[block].empty(); }

  /// To the kick at the present time: grips that have come take hold of their spheres where they are.
  void grasp(const Assembly::State& s);
  /// At the start, once it has loads: of fibers that are held, velocities half a step back.
  void before_start(const Assembly::State& s);
  /// Puts them in place of those of free fibers.
  void start(Assembly::State& s);
  /// Spheres that are held have the velocities of their grips half a step back.
  void set_speeds(Assembly::State& s) const;
  /// Records begin now.
  void begin_accounts(const Assembly::State& s);

  /// Adds the loads of now to those of a part's spheres.
  void add_loads(int part, LoadRange loads) const;
  /// The same where they are not among these rows, into the loads of all.
  void add_loads(const Assembly::State& s, const std::set<std::int64_t>& but,
                 std::vector<double>& loads) const;

  /// Around the step of a block by its kernel.
  void before_step(const Assembly::State& s, std::size_t block);
  /// The square of the largest speed.
  double after_step(Assembly::State& s, std::size_t block);
  /// Once all blocks have made the kick at `time`.
  void end_kick();

  /// Whether the velocities of a fiber now are other than its forces alone make them; then puts them in
  /// place of the state's. `spheres` with their forces now.
  bool correct(const Assembly::State& s, int block, int lane, std::vector<MovingSphere<double, 3>>& spheres,
               ChainState<3>& state) const;

  /// Of each grip over the interval up to now.
  std::vector<WallSample> samples(const Assembly::State& s) const;
  void begin_interval(const Assembly::State& s);
  double work(const Assembly::State& s) const;  ///< done by all since the start [J]

  std::vector<double> saved() const;
  void restore(const double* from);
  /// Of each sphere that is loaded: its number, force and moment now.
  std::vector<double> applied_loads(const Assembly::State& s) const;

 private:
  /// A sphere of a grip.
  struct Held {
    int grip;
    SphereAddress at;
    Vec<double, 3> body{};  ///< its place against the grip's center, turned back with that [m]
    // of the last kick
    Vec<double, 3> place{};            ///< [m]
    Vec<double, 3> force{}, moment{};  ///< impulses of the grip on it [N s], [N m s]
    double work = 0;                   ///< of them [J]
    std::int64_t row = 0;
  };

  /// A fiber with such spheres.
  struct HeldFiber {
    int group, fiber;
    std::vector<int> spheres;  ///< in the order of their numbers
    int block = 0, lane = 0;
    std::vector<MovingSphere<double, 3>> before =
        {};  ///< all where it is solved for, else those that are held
    HeldKick kick = {};
  };

  /// A grip at the kick now.
  struct Motion {
    bool active = false;
    Vec<double, 3> center_next{}, center_before{};  ///< at the step's end, at the step before [m]
    Quaternion<double> turn_next{1, {}}, turn_before{1, {}};
    Vec<double, 3> spin{}, spin_before{};  ///< that lead to the step's end, and here [1/s]
    double load = 0;                       ///< part of force and moment
  };

  /// Of a grip over the steps.
  struct Record {
    WallLoad impulse;  ///< on it since the interval began, half a kick before counted off [N s], [N m s]
    double force_peak = 0, moment_peak = 0;
    double interval_begin = 0;
    double work = 0;  ///< on spheres, half of the first kick counted off [J]
  };

  /// On a grip in one kick.
  struct Now {
    WallLoad load;            ///< [N], [N m]
    double work = 0;          ///< on spheres [J]
    Vec<double, 3> center{};  ///< mean place of its spheres [m]
  };

  bool is_solved(const Assembly::State& s) const;
  Motion motion_at(const Grip& grip, double time) const;
  /// What is held of a fiber's spheres at the kick now, from their velocities and places; `back`: at the
  /// start, from those half a step back that the grips have.
  std::vector<HeldChange> changes(const HeldFiber& fiber, const std::vector<MovingSphere<double, 3>>& spheres,
                                  bool back) const;
  /// All spheres of a fiber as they are, with their forces.
  std::vector<MovingSphere<double, 3>> spheres_of(const Assembly::State& s, const HeldFiber& fiber,
                                                  const BlockSnapshot& snapshot) const;
  /// Impulses of its grips and their work, of a sphere whose velocity and spin go over.
  void account(Held& held, const SixNumbers& impulse, const MovingSphere<double, 3>& before,
               const SixNumbers& change) const;
  double after_explicit(Assembly::State& s, HeldFiber& fiber);
  double after_solved(Assembly::State& s, HeldFiber& fiber);
  void put(Assembly::State& s, std::int64_t row, const HeldFiber& fiber, int sphere,
           const MovingSphere<double, 3>& before, const SixNumbers& change) const;
  std::vector<Now> sums(const std::vector<Held>& spheres) const;
  /// Of the kick to come.
  std::vector<Now> now(const Assembly::State& s) const;

  std::vector<Grip> grips_;
  double step_ = 0;
  std::vector<Held> spheres_;
  std::vector<HeldFiber> fibers_;
  std::vector<Motion> motions_;
  std::vector<Record> records_;
  std::vector<std::vector<int>> of_block_, loaded_in_part_;
};

}  // namespace fiberchain::dem
