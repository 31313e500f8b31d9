#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "dem/assembly/assembly.hpp"
#include "dem/assembly/fiber_block.hpp"
#include "dem/assembly/fiber_order.hpp"
#include "dem/assembly/held_spheres.hpp"
#include "dem/contact/contacts.hpp"
#include "dem/parallel/thread_pool.hpp"
#include "dem/parallel/wavefront_schedule.hpp"

namespace fiberchain::dem {

/// Splits wall-clock time among the parts of a step: a lap adds the time since the last one.
struct StopWatch {
  using Clock = std::chrono::steady_clock;

  bool on = false;
  StepTimes times{};
  Clock::time_point last = Clock::now();
  double contacts_before = 0, both_before = 0;  ///< of all parts [s]

  void lap(double StepTimes::*part) {
    if (!on) return;
    const Clock::time_point now = Clock::now();
    if (part != nullptr) times.*part += std::chrono::duration<double>(now - last).count();
    last = now;
  }

  /// Divides it in proportion to what the threads have spent in either since the last lap.
  void lap(const std::vector<PartTimes>& parts) {
    if (!on) return;
    const Clock::time_point now = Clock::now();
    double contacts = 0, both = 0;
    for (const PartTimes& part : parts)
      contacts += part.contacts, both += part.contacts + part.bonds_and_motion;
    const double all = std::chrono::duration<double>(now - last).count(),
                 share = (contacts - contacts_before) / (both - both_before);
    times.contacts += share * all;
    times.bonds_and_motion += (1 - share) * all;
    last = now, contacts_before = contacts, both_before = both;
  }
};

/// Adds its lifetime [s] to a sum.
class TimedPart {
 public:
  TimedPart(bool on, double& sum) : sum_(on ? &sum : nullptr) {
    if (on) start_ = StopWatch::Clock::now();
  }
  ~TimedPart() {
    if (sum_ != nullptr) *sum_ += std::chrono::duration<double>(StopWatch::Clock::now() - start_).count();
  }
  TimedPart(const TimedPart&) = delete;
  TimedPart& operator=(const TimedPart&) = delete;

 private:
  double* sum_;
  StopWatch::Clock::time_point start_;
};

/// Storage of the spheres, blocks of fibers that move them, contacts between them.
struct Assembly::State {
  Domain domain;
  AssemblyOptions options;
  double step;
  std::int64_t steps = 0;
  std::vector<GroupKind> kinds;         ///< one a group
  std::vector<int> fibers;              ///< in each group
  std::vector<FiberOrder> order;        ///< of each group's fibers in blocks and rows
  double best_cross_part_fraction = 1;  ///< least since fibers were sorted or it was tried, or some came
  std::int64_t sort_count = 0;          ///< how often they were sorted
  std::vector<int> first_block;         ///< of each group
  std::vector<FiberBlock> blocks;
  std::vector<int> part_blocks;  ///< the first block of each part of spheres, and one past the last
  SphereStorage rows;
  ForceBuffers loads;  ///< of contacts at this moment
  ThreadPool pool;
  Contacts contacts;
  LaneArray gradient;                 ///< fluid: A now, lane by lane
  std::vector<LaneArray> scratch;     ///< one a thread
  double longest_path = 0;            ///< of all since the start [m]
  double largest_turn = 0;            ///< of a bond that is solved for in a step since the start [rad]
  std::vector<double> paths;          ///< largest displacement in the last step, one a part [m]
  std::vector<PartTimes> part_times;  ///< without `reached`
  WavefrontSchedule wavefront{0};
  double displacement_budget = 0;  ///< displacement left before the Verlet criterion must be checked [m]
  StopWatch watch;
  double inserted = 0;                                   ///< energy supplied with inserted fibers [J]
  std::optional<std::vector<ContactState>> last_forces;  ///< by rows, where the last march has kept them
  HeldSpheres held;                                      ///< by grips
  bool may_break = false;                                ///< fibers there have bonds that break
  double released = 0;  ///< energy that bonds stored as they broke, less that of contacts between
                        ///< what they joined as these began [J]
  std::int64_t broken_bonds = 0;
  std::vector<BondBreak> breaks;     ///< since they were asked for
  std::vector<std::int64_t> parted;  ///< rows before bonds broken in the last step: contacts begin there

  State(Domain around, AssemblyOptions how, double dt)
      : domain(std::move(around)),
        options(std::move(how)),
        step(dt),
        steps(options.steps_before),
        pool(options.threads),
        contacts(domain, {options.account_energy, options.instruction_set}, step) {
    watch.on = options.time_parts;
  }

  double time() const { return static_cast<double>(steps) * step + options.time_shift; }
  /// Numbers of spheres go through groups, fibers and spheres; rows through groups, places and spheres.
  std::int64_t group_begin(int group) const { return blocks[first_block[group]].first(0); }
  std::int64_t first_sphere(int group, int fiber) const {
    return group_begin(group) + static_cast<std::int64_t>(fiber) * kinds[group].spheres();
  }
  /// Row of a fiber's first sphere.
  std::int64_t first_row(int group, int fiber) const {
    return first_sphere(group, order[group].place(fiber));
  }
  int group_of(std::int64_t row) const;
  std::int64_t number_of(std::int64_t row) const;
  std::int64_t row_of(std::int64_t number) const;
  struct Slot {
    int block, lane;
  };
  Slot slot(int group, int fiber) const {
    const int width = kinds[group].kernel->width, place = order[group].place(fiber);
    return {first_block[group] + place / width, place % width};
  }

  /// Enlarges the storage, sets the groups' spheres and builds the neighbor list; returns the first new
  /// block.
  int add(const std::vector<FiberGroup>& groups);
  /// Sets the velocities of blocks from this one on half a step back, as the leapfrog stores them.
  void start_blocks(int from);

  int part_of(const FiberBlock& block) const { return contacts.parts().of(block.first(0)); }
  Gradient gradient_now() const;
  void set_gradient();
  void rebuild_neighbor_list();
  void touch();
  /// The same, and keeps the forces of each contact.
  void touch_and_keep();
  /// Sorts fibers in space where they have mixed. No loads are waiting.
  void sort_where_mixed();
  /// Fibers to the places of this order, bonds, contacts and their histories with them.
  void move_to(std::vector<FiberOrder> after, const std::vector<std::int32_t>& new_row);
  /// The row in this order of each row now.
  std::vector<std::int32_t> rows_in(const std::vector<FiberOrder>& after) const;
  /// Those of a group as they lie now.
  FiberOrder order_now(int group) const;
  void march(std::int64_t count, ContactForces at_end);
  /// Bonds that have broken in the last step are gone, and spheres beside them may touch.
  void settle_breaks();
  /// The pieces of fibers as their bonds are; the neighbor list is built anew behind it.
  void part_pieces();
  /// Bonds of the first groups that were broken elsewhere stay so, what they bear is this assembly's.
  void adopt_failures(int groups);
  /// Once contacts are worked out: what those store that begin between spheres parted in the last step.
  void account_parted();
  AssemblySample sample();
  std::string place_of(std::int64_t sphere) const;  ///< "fiber 3, sphere 0"
  std::int64_t fastest_sphere() const;
  double smallest_radius() const;  ///< [m]

 private:
  bool march_some(int count, ContactForces at_end);
  Partition partition_of_blocks();
  void move();
  void touch_and_move();
  void has_moved();
  void move_part(int part, int thread);
  bool update_neighbor_list();
  std::int64_t rows_ahead(std::int64_t end) const;
  /// Throws Diverged where bodies may have passed through each other.
  void check_passage(std::int64_t from) const;
  /// Throws Diverged where bonds that are solved for are beyond what steps bear.
  void check_stiff(std::int64_t from);
  double step_block(std::size_t number, LoadRange own_loads, LaneArray& own_scratch);
  double fluid_dissipation(const FiberBlock& block, const BlockSnapshot& before) const;
  std::int64_t broken() const;
  [[noreturn]] void fail(std::int64_t sphere, std::int64_t from) const;
};

}  // namespace fiberchain::dem
