#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "dem/insertion/insertion_grid.hpp"
#include "dem/model/domain.hpp"
#include "dem/chain/chain_state.hpp"
#include "dem/motion/kernels/chain_kernel.hpp"

// Many fibers that touch each other and walls, marched by the leapfrog: bonds in SIMD lanes across fibers, contacts
// in lanes across pairs. Results do not depend on the number of threads, to the bit.
namespace fiberchain::dem {

/// Fibers of one kind and where they start.
struct FiberGroup {
  Chain<3> chain;                      ///< with `natural` where curved at rest
  std::vector<ChainState<3>> fibers;   ///< one state a fiber
};

struct PackingLaw;

struct AssemblyOptions {
  std::optional<double> step = std::nullopt;  ///< dt [s]; left out: chosen (assembly_time_step)
  BondForm form = BondForm::incremental;
  const PackingLaw* law = nullptr;  ///< of the bonds, from outside of the library (packing_law.hpp), in place of `form`
  Rolling rolling = Rolling::set_valued;  ///< of the bonds, where a fiber has rolling friction
  int threads = 1;
  bool time_parts = false;                ///< measure where the time goes (StepTimes)
  bool account_energy = false;               ///< sum what each mechanism dissipates
  bool orientations = true;               ///< follow the orientations of spheres where the bonds do not need them (incremental form)
  bool placed_anywhere = false;           ///< fibers may start behind walls: their state comes from restore()
  InstructionSet instruction_set = best_instruction_set();
};

/// Where energy is, and what each mechanism has dissipated or given since the start where it is accounted [J].
struct EnergyBalance {
  double kinetic, bonds, contacts, gravity;  ///< stored now
  double bond_damping, bond_friction;        ///< dissipated by the dashpots and by the rolling friction of bonds
  double contact_normal, contact_tangential, contact_rolling;  ///< dissipated by contacts
  double fluid;                              ///< dissipated by the fluid (negative where it drives)
  double wall_work;                          ///< given by walls that move
  double inserted;                           ///< that fibers brought with them
};

/// Where the time of the steps went [s], by the clock on the wall.
struct StepTimes {
  double bonds_and_motion, contacts, search;
};

/// Stored, and dissipated less what was given [J]: constant but for errors of the step.
double total(const EnergyBalance& energy);

/// A bond now.
struct BondState {
  Vec<double, 3> force;  ///< on its first sphere, spring and dashpot [N]
  double bending_angle;  ///< |theta_b| of the bond law, 0 at rest [rad]
};

/// A pair that touches.
struct ContactState {
  std::int64_t first, second;  ///< sphere numbers; second < 0: wall -1 - second
  double overlap;              ///< [m]
  Vec<double, 3> point;        ///< [m]
  Vec<double, 3> force;        ///< on the first [N]
};

class Assembly {
 public:
  /// Throws InvalidInput for what makes no sense or is not built: no fibers, spheres beyond a wall, a fluid that is not free
  /// draining, a step beyond the stable one.
  Assembly(std::vector<FiberGroup> groups, Domain domain, AssemblyOptions options);
  ~Assembly();
  Assembly(Assembly&&) noexcept;

  /// Adds fibers now, as the last group. The step stays: throws InvalidInput if it is beyond what they allow.
  void insert(FiberGroup group);

  /// Throws Diverged with step, time, fiber, sphere and likely cause when the run blows up.
  void march(std::int64_t steps);

  double step() const;           ///< dt [s]
  std::int64_t steps() const;    ///< done
  double time() const;           ///< [s]
  std::int64_t spheres() const;
  int groups() const;
  const Chain<3>& chain(int group) const;
  int fibers(int group) const;  ///< how many
  PlacedSpheres placed() const;  ///< all spheres now, to fill in more beside them

  /// State now of a fiber, velocities of this moment; at the start itself those given to first order in the step where
  /// dashpots act. Orientations are not numbers where they are not followed.
  ChainState<3> state(int group, int fiber) const;
  /// Of a fiber, from its first bond on.
  std::vector<BondState> bonds(int group, int fiber) const;
  /// Bonds that can break (a law with the flag `intact`, laws/breakable.hpp); no others are ever broken. Spheres beside a
  /// broken bond may touch.
  bool is_broken(int group, int fiber, int bond) const;
  /// Breaks a bond for good. Throws InvalidInput where the law has no broken bonds.
  void break_bond(int group, int fiber, int bond);
  /// Of all fibers of a group, at a fraction of the cost of one after the other.
  std::vector<ChainState<3>> states(int group) const;
  std::vector<std::vector<BondState>> bonds(int group) const;
  /// Both of one fiber of a group after the other: little memory, however many there are.
  using FiberVisit = std::function<void(const ChainState<3>& state, const std::vector<BondState>& bonds)>;
  void visit(int group, const FiberVisit& fiber) const;
  /// Sphere numbers go through the groups, fibers and spheres in order.
  std::int64_t first_sphere(int group, int fiber) const;
  std::int64_t touching() const;  ///< contacts now
  std::vector<ContactState> contacts() const;
  EnergyBalance energy() const;
  StepTimes times() const;  ///< since the start; zero unless asked for

  /// The whole state, to go on from to the bit.
  std::vector<double> saved() const;
  /// Throws InvalidInput for numbers that cannot be a state of this assembly.
  void restore(const std::vector<double>& saved);

  struct State;

 private:
  std::unique_ptr<State> state_;
};

/// Part of the largest stable step that is chosen.
inline constexpr double chosen_part = 0.9;

/// The step [s] an assembly takes when none is asked for, and what sets it.
struct StepChoice {
  double step;
  std::string_view set_by;  ///< "bonds", "bond damping" or "contacts"
  double bonds, damped_bonds, contacts;  ///< largest steps each allows [s]
};
StepChoice assembly_time_step(const std::vector<FiberGroup>& groups, const Domain& domain, const AssemblyOptions& options = {});

}  // namespace fiberchain::dem
