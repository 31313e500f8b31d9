#pragma once

#include <algorithm>
#include <vector>

#include "dem/chain/fiber_group.hpp"
#include "dem/chain/sphere_storage.hpp"
#include "dem/contact/contact_history.hpp"
#include "dem/contact/contact_law.hpp"
#include "dem/contact/contact_state.hpp"
#include "dem/contact/neighbor_list.hpp"
#include "dem/parallel/force_buffers.hpp"
#include "dem/parallel/thread_pool.hpp"

// All contacts of an assembly: which spheres are close, what their contacts restore, and their loads.
namespace fiberchain::dem {

struct ContactOptions {
  bool account_energy = false;  ///< sum the work dissipated by contacts and done by walls
  InstructionSet instruction_set = best_instruction_set();
};

class Contacts {
 public:
  Contacts(const Domain& domain, const ContactOptions& options, double step);

  /// Throws InvalidInput where periodic sides are too near for these fibers beside those there.
  void check_periods(const std::vector<FiberGroup>& more) const;
  /// More fibers, after those that are there.
  void add(const Fiber& fiber, int count);
  /// Once all have been added: cuts the spheres into parts and lists them; contacts that touch keep what they
  /// restore.
  void begin(SphereStorage& rows, Partition parts, double time, ThreadPool& pool);

  std::int64_t spheres() const { return static_cast<std::int64_t>(fiber_.size()); }
  /// Gap that a listed pair may have beyond the reach of the contact law [m]: bodies may come nearer by that
  /// before others do.
  double skin() const { return skin_; }

  /// Lists all spheres at these position_radius, who is close to whom; contacts that touch keep what they
  /// restore.
  void rebuild_neighbor_list(std::vector<Vec<double, 3>> position_radius, double time, ThreadPool& pool);
  /// The same at the rows' position_radius.
  void rebuild_neighbor_list(const SphereStorage& rows, double time, ThreadPool& pool);
  /// Lists spheres that have come far rebuilt, where some have; how far any may move before it must be asked
  /// again [m].
  double follow(const SphereStorage& rows, ThreadPool& pool);
  /// Whether a wall has moved so far that spheres near it may be missing: time for rebuild_neighbor_list().
  bool walls_moved_far(double time) const;
  const std::vector<Vec<double, 3>>& reference_positions() const { return close_.position_radius(); }
  double reference_time() const { return reference_time_; }
  /// When the next neighbor list is built at saved positions.
  void set_reference_time(double time) { reference_time_ = time; }

  /// Spheres of each part move on by no more than `paths` [m] before the next work_out().
  void add_displacements(const std::vector<double>& paths);
  const Partition& parts() const { return close_.parts(); }

  /// Of which parts' spheres the contacts of each read, and for which they have loads.
  const PartDependencies& reach() const { return reach_; }
  /// Adds the loads of a part's contacts to its own; what leaves the part waits for reduce_halo_forces().
  void work_out(int part, const SphereStorage& rows, double time, LoadRange loads);
  /// Adds what earlier parts have for this one, in their order.
  void reduce_halo_forces(int part, LoadRange loads);
  /// Both for all parts, none of which has loads.
  void work_out(const SphereStorage& rows, double time, ForceBuffers& loads, ThreadPool& pool);

  std::int64_t touching() const;
  double deepest() const;  ///< largest overlap over the smaller radius since this was made
  /// Since the start up to this moment [J]: half of what the kick takes that is centered on it.
  ContactAccount<double> dissipated() const;
  double wall_work() const;  ///< likewise [J]
  /// The kick centered on the start's moment began before it.
  void begin_accounts();
  double stored_energy() const;  ///< in the springs now [J]

  std::vector<ContactState> states(const SphereStorage& rows, double time) const;
  std::vector<SavedContact> saved() const;
  void clear();
  void restore(const std::vector<SavedContact>& contacts);
  /// Sums that go on when a saved state is gone on with: part by part.
  std::vector<double> accumulators() const;
  static constexpr int accumulators_per_part = 9;
  void set_accumulators(const double* from);

 private:
  /// Close pairs, in order, padded to whole vectors.
  struct PairList {
    std::vector<std::int32_t> first, second, contact;  ///< spheres, and numbers in the histories
    std::size_t count = 0;                             ///< without pads
    int last_part = -1;                                ///< of a second sphere

    void clear();
  };
  /// Those of the pairs that may touch soon.
  struct InnerPairList {
    std::vector<std::int32_t> pair, first, second, contact;
    std::vector<std::uint8_t> touches;
    std::int32_t count = 0;
    double displacement_since = 0;  ///< what other pairs may have come displacement_since since [m]
    bool stale = true;              ///< to be made before it is used

    void reserve(std::size_t numbers);
    InnerPairs view() { return {pair.data(), first.data(), second.data(), contact.data(), touches.data()}; }
  };
  /// Spheres near a wall, likewise.
  struct WallNeighbors {
    std::vector<std::int32_t> slots, contact;
    std::size_t count = 0;
  };
  struct Part {
    PairList pairs, next_pairs;  ///< those to come while they are made
    InnerPairList near;
    std::vector<WallNeighbors> walls;
    WallNeighbors next_wall;
    ContactHistories histories;  ///< of the pairs and at the walls
    std::vector<std::int32_t> touching;
    std::vector<HaloForce> halo;
    std::vector<std::vector<std::int32_t>> halo_of_part;  ///< position_radius in halo
    std::int64_t contacts = 0;
    double deepest = 0;
    ContactAccount<double> account{}, power{};
    double wall_work = 0, wall_power = 0;
  };

  /// Sets what stands behind the spheres' rows.
  void pad(SphereStorage& rows) const;
  void set_parameters();
  /// As many parts, the accumulators of all in the first.
  void cut(int parts);
  double inner_cutoff() const;  ///< [m]
  /// The near pairs of a part from now on.
  void prune(Part& part, std::int32_t part_end, const SphereStorage& rows);
  void renew(ThreadPool& pool);
  void renew_pairs(int part);
  void renew_wall(int part, int wall);
  /// Numbers of the law's Parameters.
  const double* parameters_of(const SavedContact& contact) const;
  double energy_of(const SavedContact& contact) const;  ///< stored in its springs [J]
  /// At which its normal spring is pressed [W]. A kick lasts from half a step before to half a step after.
  double closing_power(const SavedContact& contact) const;
  /// What a wall that has just come stores in contacts at once [J].
  double brought_by(const WallNeighbors& near, const Part& part) const;
  /// A wall that is gone takes what its contacts stored.
  void drop(WallNeighbors& near, int wall, Part& part) const;
  int kind_of(const ContactBody& body);
  /// Largest gap at which any of these bodies and walls act on each other [m].
  double law_reach(const std::vector<ContactBody>& bodies) const;
  TouchingPair<double> pair_at(const SavedContact& contact, const SphereStorage& rows, double time,
                               double& arm) const;
  ContactView view(Part& part, const SphereStorage& rows);
  WallView wall_view(int wall, WallNeighbors& near, double time) const;
  /// Numbers in the histories that a step may need.
  std::size_t may_begin(const Part& part) const;

  Domain domain_;
  const ContactLaw& law_;
  std::vector<int> shapes_;  ///< of each wall: number among those of the law's loops
  PeriodicBox periods_;
  bool accounted_;
  InstructionSet instruction_set_;
  std::vector<ContactBody> bodies_;  ///< of each kind
  std::vector<double> pair_parameters_,
      wall_parameters_;  ///< of the law, numbers of each pair of kinds, of each kind
  std::vector<double> radius_;
  std::vector<std::int32_t> fiber_, kind_of_sphere_;
  double step_;
  double skin_ = 0, law_reach_ = 0;  ///< [m]
  const ContactKernel* kernel_ = nullptr;
  NeighborList close_;
  double reference_time_ = 0;
  std::vector<Part> parts_;
  PartDependencies reach_;
};

}  // namespace fiberchain::dem
