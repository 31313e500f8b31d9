#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dem/assembly/bond_breaks.hpp"
#include "dem/assembly/carried_state.hpp"
#include "dem/assembly/energy_balance.hpp"
#include "dem/assembly/saved_state.hpp"
#include "dem/chain/chain_state.hpp"
#include "dem/chain/fiber_group.hpp"
#include "dem/contact/contact_state.hpp"
#include "dem/contact/wall_record.hpp"
#include "dem/insertion/insertion_grid.hpp"
#include "dem/model/domain.hpp"
#include "dem/model/grip.hpp"
#include "dem/motion/integrator.hpp"
#include "dem/motion/kernels/packing_kernel.hpp"
#include "dem/motion/physics.hpp"
#include "dem/parallel/idle_times.hpp"
#include "dem/simd/instruction_set.hpp"

// Many fibers in contact with each other and with walls, integrated by the leapfrog: bonds in SIMD lanes
// across fibers, contacts in lanes across pairs. Results do not depend on the number of threads, to the bit.
namespace fiberchain::dem {

struct PackingLaw;

/// How far the coefficient of restitution may be off by the step that is chosen.
inline constexpr double usual_restitution_error = 0.01;

struct AssemblyOptions {
  std::optional<double> step = std::nullopt;     ///< dt [s]; left out: chosen (assembly_time_step)
  Integrator integrator = Integrator::leapfrog;  ///< leapfrog, or leapfrog_stiff
  BondForm form = BondForm::incremental;
  const PackingLaw* law =
      nullptr;  ///< of the bonds, from outside of the library (packing_law.hpp), in place of `form`
  Rolling rolling = Rolling::set_valued;  ///< of the bonds, where a fiber has rolling friction
  int threads = 1;
  bool time_parts = false;      ///< measure the parts of a step (StepTimes)
  bool account_energy = false;  ///< sum the energy dissipated or supplied by each mechanism
  bool orientations =
      true;  ///< follow the orientations of spheres where the bonds do not need them (incremental form)
  bool placed_anywhere = false;  ///< fibers may start behind walls: their state comes from restore()
  bool sort_in_space = true;     ///< keep fibers that are neighbors in space near each other in memory
  bool allow_passage = false;    ///< march on where bodies may have passed through each other or a wall
  InstructionSet instruction_set = best_instruction_set();
  std::int64_t steps_before = 0;  ///< done when the assembly begins, which is at steps_before steps and...
  double time_shift = 0;          ///< ... this [s]
  double speed = 0;  ///< that bodies may come to [m/s], for the choice of a step beside those there are
  double restitution_error = usual_restitution_error;  ///< that a chosen step may make
  std::vector<Grip> grips = {};                        ///< what holds, drives or loads spheres
};

/// Wall-clock time of the parts of all steps [s].
struct StepTimes {
  double bonds_and_motion, contacts, search;
};

/// Time that one part of the spheres has cost [s], and the later parts that wait for its contacts.
struct PartTimes {
  double contacts = 0, bonds_and_motion = 0;
  std::vector<int> reached;
};

/// A bond now.
struct BondState {
  Vec<double, 3> force;  ///< on its first sphere, spring and dashpot [N]
  double bending_angle;  ///< |theta_b| of the bond law, 0 at rest [rad]
};

/// Sums over an assembly.
struct AssemblySample {
  EnergyBalance energy;
  double bending;            ///< angles of all bonds that are not broken [rad]
  std::int64_t bonds;        ///< how many
  double overlap;            ///< of contacts, each over its smaller radius
  std::int64_t overlapping;  ///< how many

  /// 0 where none is whole.
  double bending_mean() const { return bonds > 0 ? bending / static_cast<double>(bonds) : 0; }
  /// 0 where nothing touches.
  double overlap_mean() const { return overlapping > 0 ? overlap / static_cast<double>(overlapping) : 0; }
};

/// What an assembly keeps of the steps that led to it, beside its state.
struct MarchRecord {
  double deepest_overlap = 0;      ///< over the smaller radius
  double longest_path = 0;         ///< of a sphere in a step [m]
  std::vector<double> walls = {};  ///< as Contacts::wall_records()
};

/// Whether contact_forces() has those of a march's last step to round-off.
enum class ContactForces { not_kept, kept };

class Assembly {
 public:
  /// Throws InvalidInput for what makes no sense or is not built: no fibers, spheres beyond a wall, a fluid
  /// that is not free draining, a step beyond the stable one.
  Assembly(std::vector<FiberGroup> groups, Domain domain, AssemblyOptions options);
  ~Assembly();
  Assembly(Assembly&&) noexcept;
  Assembly& operator=(Assembly&&) noexcept;

  /// Adds fibers now, as the last group. The step stays: throws InvalidInput if it is beyond what they allow.
  void insert(FiberGroup group);

  /// At the start: the fibers of its first groups go on from where they were carried from, with the strains
  /// of their bonds and the histories of contacts that are there still, at walls those of the same overlap.
  /// Their energies are accounted from here on. Throws InvalidInput where they are not as many fibers of as
  /// many spheres.
  CarriedLosses take_over(const CarriedState& carried);

  /// Throws Diverged with step, time, fiber, sphere and likely cause when the run blows up, and where bodies
  /// may have passed through each other or a wall: an overlap beyond the smaller radius, a path of a step
  /// beyond half of the smallest.
  void march(std::int64_t steps, ContactForces at_end = ContactForces::not_kept);

  double step() const;  ///< dt [s]
  Integrator integrator() const;
  std::int64_t steps() const;  ///< done
  double time() const;         ///< [s]
  std::int64_t spheres() const;
  int groups() const;
  const Chain<3>& chain(int group) const;
  int fibers(int group) const;   ///< how many
  PlacedSpheres placed() const;  ///< all spheres by their numbers now, obstacles of further insertion

  /// Of all sphere centers along a direction, in no order, into memory that is kept if it fits.
  void coordinates(const Vec<double, 3>& direction, std::vector<double>& all) const;

  /// State now of a fiber, velocities of this moment; at the start itself those given to first order in the
  /// step where dashpots act. Orientations are not numbers where they are not followed.
  ChainState<3> state(int group, int fiber) const;
  /// Of a fiber, from its first bond on.
  std::vector<BondState> bonds(int group, int fiber) const;
  /// Bonds that can break (a law with the flag `intact`, laws/breakable.hpp); no others are ever broken.
  /// Spheres beside a broken bond may touch.
  bool is_broken(int group, int fiber, int bond) const;
  /// Breaks a bond for good, of a fiber with strengths or yielding in the next step, as if it were beyond its
  /// strength. Throws InvalidInput where the law has no broken bonds.
  void break_bond(int group, int fiber, int bond);
  /// Those that broke since this was asked last, in the order of time, groups and places in memory.
  std::vector<BondBreak> take_breaks();
  std::int64_t pieces() const;  ///< fibers, and one more for each broken bond
  /// Of all fibers of a group, at a fraction of the cost of one after the other.
  std::vector<ChainState<3>> states(int group) const;
  std::vector<std::vector<BondState>> bonds(int group) const;
  /// Both of one fiber of a group after the other: little memory, however many there are. All threads call
  /// it, for different fibers, in no order. Orientations that are not followed mean nothing.
  using FiberVisit =
      std::function<void(int fiber, const ChainState<3>& state, const std::vector<BondState>& bonds)>;
  void visit(int group, const FiberVisit& visitor) const;
  /// Sphere numbers go through the groups, fibers and spheres in order.
  std::int64_t first_sphere(int group, int fiber) const;
  std::int64_t touching() const;   ///< contacts now
  double deepest_overlap() const;  ///< over the smaller radius, largest since the start
  double longest_path() const;     ///< of a sphere in a step over the smallest radius, likewise
  /// Largest turn of a bond in a step [rad] since the start, or more; 0 where bonds are not solved for.
  double largest_turn() const;
  /// By the numbers of their spheres. Forces are of this moment to first order in the step.
  std::vector<ContactState> contacts() const;
  /// The same with the forces of the last step, to round-off those that move spheres and walls, where march()
  /// has kept them; else as contacts(). They are of the spheres that were there when the march ended.
  std::vector<ContactState> contact_forces() const;
  /// Forces and moments on each wall over the interval that ends now, which began at the start or at the last
  /// begin_wall_interval(). The mean force times the interval is what the wall's contacts have given it to
  /// round-off.
  std::vector<WallSample> wall_samples() const;
  void begin_wall_interval();
  /// The same of each grip: what its spheres do to it, moments about their mean place, which is `center`.
  std::vector<WallSample> held_samples() const;
  void begin_held_interval();
  const std::vector<Grip>& grips() const;

  /// From the next step on; the rest of a run is as if it had begun so. None of these is in a saved state.
  /// Throws InvalidInput for numbers that are not finite and walls that are not there.
  void set_gravity(const Vec<double, 3>& gravity);  ///< [m/s^2]
  /// Another constant velocity of a wall [m/s], which goes on from where it is; beside its other motion.
  void set_wall_velocity(int wall, const Vec<double, 3>& velocity);
  /// Puts a wall elsewhere at once [m]. Throws InvalidInput also where the center of a sphere would be behind
  /// it, and where energies are accounted: what contacts gain by it is nobody's.
  void shift_wall(int wall, const Vec<double, 3>& by);
  const Vec<double, 3>& gravity() const;  ///< [m/s^2]

  const std::vector<Wall>& walls() const;  ///< those that are driven stand where they are now
  std::int64_t sort_count() const;         ///< how often fibers have been sorted in space since the start
  EnergyBalance energy() const;
  AssemblySample sample() const;              ///< the same and the bending, in one pass
  StepTimes times() const;                    ///< since the start; zero unless asked for
  IdleTimes idle_times() const;               ///< of the threads, likewise
  std::vector<PartTimes> part_times() const;  ///< likewise; `reached` now

  MarchRecord record() const;
  /// Of steps that another engine has made: dem/lammps.
  void adopt(const MarchRecord& record);

  /// The whole state by named fields: a restored assembly continues bit for bit.
  SavedState saved() const;
  /// The same field by field, each made when it is used and gone behind it.
  void each_saved(const UseField& use) const;
  /// Throws InvalidInput naming the field that is missing, unknown, of another version, type or size.
  void restore(const SavedState& saved);

  struct State;

 private:
  std::unique_ptr<State> state_;
};

/// Part of the largest stable step that is chosen.
inline constexpr double chosen_part = 0.9;

/// Part of the smallest radius that the fastest sphere may go in a step that is chosen.
inline constexpr double chosen_path = 0.1;

/// Parts of the first period of bending of a free fiber, and of an impact between single spheres, that a step
/// in which bonds are solved for takes at most: packings at rest are the same within the spread of seeds up
/// to 1/3.7 and 1/16 (bench --case stiff-packing), and the coefficient of restitution is off by 1 %.
inline constexpr double bending_part = 1.0 / 4.5, impact_part = 1.0 / 20;

/// The step [s] an assembly takes when none is asked for, and what sets it.
struct StepChoice {
  double step;
  /// "bonds", "bond damping", "contacts", "restitution" or "speed"; where bonds are solved for also
  /// "bending", "impacts" or "turning"
  std::string_view set_by;
  double bonds, damped_bonds, contacts;  ///< largest steps that each is stable with [s]
  double restitution;  ///< that keeps the coefficient of restitution at `speed` [s]; infinite without speed
  double path;         ///< with which `speed` goes chosen_path [s]; infinite without speed
  double speed;        ///< of bodies towards each other, now or later [m/s]
  double bending = 0;  ///< where bonds are solved for: a part of the first period of bending [s]
  double impact = 0;   ///< likewise: a part of an impact at `speed` [s]
  double turning = 0;  ///< likewise: with which bonds turn by safe_turn at `speed` [s]
  std::string integrator_reason = {};  ///< why the integrator was chosen, if it was
  double restitution_error = 0;  ///< of the coefficient of restitution at `speed` with the step that is taken
};

/// The longest step that the bonds of a choice are stable with [s].
double largest_bond_step(const StepChoice& choice);

/// By stability alone: what the speeds of bodies and the restitution want is left out.
StepChoice stable_time_step(const std::vector<FiberGroup>& groups, const Domain& domain,
                            const AssemblyOptions& options = {});

StepChoice assembly_time_step(const std::vector<FiberGroup>& groups, const Domain& domain,
                              const AssemblyOptions& options = {});

/// How far the coefficient of restitution is off at this step where two spheres, or a sphere and a wall, meet
/// head on at `speed` [m/s]: the largest of all pairs of bodies (restitution_error.hpp).
double restitution_error(const std::vector<FiberGroup>& groups, const Domain& domain, double speed,
                         double step);

}  // namespace fiberchain::dem
