#pragma once

#include <algorithm>
#include <vector>

#include "dem/chain/fiber_group.hpp"
#include "dem/chain/sphere_storage.hpp"
#include "dem/contact/contact_history.hpp"
#include "dem/contact/contact_law.hpp"
#include "dem/contact/contact_state.hpp"
#include "dem/contact/contact_sums.hpp"
#include "dem/contact/fiber_bodies.hpp"
#include "dem/contact/inner_pairs.hpp"
#include "dem/contact/kernels/segment_kernel.hpp"
#include "dem/contact/mesh_neighbors.hpp"
#include "dem/contact/neighbor_list.hpp"
#include "dem/contact/pair_list.hpp"
#include "dem/contact/ridge_neighbors.hpp"
#include "dem/contact/wall_neighbors.hpp"
#include "dem/contact/wall_record.hpp"
#include "dem/parallel/force_buffers.hpp"
#include "dem/parallel/thread_pool.hpp"

// All contacts of an assembly: neighbors, contact histories, forces and moments.
namespace fiberchain::dem {

class Contacts {
 public:
  Contacts(const Domain& domain, const ContactOptions& options, double step);

  /// Throws InvalidInput where periods are too short for these fibers beside those there.
  void check_periods(const std::vector<FiberGroup>& more) const;
  /// More fibers, after those that are there.
  void add(const Chain<3>& chain, int count);
  /// Once all have been added: cuts the spheres into parts and builds their neighbor list. Contacts keep
  /// their histories.
  void begin(SphereStorage& rows, Partition parts, double time, ThreadPool& pool);

  std::int64_t spheres() const { return static_cast<std::int64_t>(fiber_.size()); }
  /// By which a fiber touches others: a sphere, or the segment behind it.
  Primitive primitive(std::int64_t sphere) const { return fiber_bodies_.primitive(sphere); }
  /// Largest gap of neighbors beyond the reach of the contact law [m].
  double skin() const { return skin_; }

  /// Spheres of these rows are no longer joined to those of the next: until part_behind() is called again
  /// they may touch, once the neighbor list is built anew.
  void part_behind(const std::vector<std::int64_t>& rows);
  /// What contacts store that go with the segments of smooth fibers whose bonds behind these rows break [J]:
  /// to be asked before part_behind().
  double held_by_segments(const std::vector<std::int64_t>& rows);
  /// What contacts between the spheres on both sides store that have just begun at once [J]; of smooth fibers
  /// those of both ends with anything, and what more of the others these have than before.
  double brought_behind(const std::vector<std::int64_t>& rows) const;

  /// The neighbors of all spheres at these reference positions. Contacts keep their histories.
  void rebuild_neighbor_list(std::vector<Vec<double, 3>> positions, double time, ThreadPool& pool);
  /// The same at the present positions.
  void rebuild_neighbor_list(const SphereStorage& rows, double time, ThreadPool& pool);
  /// Updates the neighbors of spheres that have moved far, where some have. Returns the displacement [m] that
  /// is left to any sphere before the Verlet criterion must be checked again.
  double update_neighbor_list(const SphereStorage& rows, ThreadPool& pool);
  /// Whether a wall has moved so far that spheres near it may be missing: time for rebuild_neighbor_list().
  bool walls_moved_far(double time) const;
  /// Of those that are there, where spheres may meet them [m/s].
  double fastest_wall(double time) const;
  /// As they stand: those that are driven have moved.
  const std::vector<Wall>& walls() const { return domain_.walls; }
  const std::vector<Vec<double, 3>>& reference_positions() const { return neighbors_.reference_positions(); }
  double reference_time() const { return reference_time_; }
  /// When the next neighbor list is built at saved positions.
  void set_reference_time(double time) { reference_time_ = time; }

  /// Spheres of each part have moved on by no more than `paths` [m] since the last work_out(), walls up to
  /// this time.
  void add_displacements(const std::vector<double>& paths, double time);
  const Partition& parts() const { return neighbors_.parts(); }

  /// The parts whose spheres the contacts of each part read and load.
  const PartDependencies& reach() const { return reach_; }
  /// Adds the loads of a part's contacts to its own; what leaves the part waits for reduce_halo_forces().
  void work_out(int part, const SphereStorage& rows, double time, LoadRange loads);
  /// Once the forces of all parts are worked out: what they do to the walls, and a kick of driven ones.
  void end_forces(double time);
  /// Driven walls to the next moment, together with the spheres.
  void move_walls();
  /// Another constant velocity of a wall from now on [m/s]: it goes on from where it is.
  void set_wall_velocity(std::size_t wall, const Vec<double, 3>& velocity, double time);
  /// Puts a wall elsewhere at once.
  void shift_wall(std::size_t wall, const Vec<double, 3>& by);
  /// Whether it may stand where the neighbor list does not know it: time for rebuild_neighbor_list().
  bool is_listed_elsewhere(std::size_t wall, double time) const;
  /// Of each wall over the interval up to now.
  std::vector<WallSample> wall_samples(double time) const;
  /// A new interval for all walls.
  void begin_wall_interval(double time);
  /// Adds what earlier parts have for this one, in their order.
  void reduce_halo_forces(int part, LoadRange loads);
  /// Both for all parts, none of which has loads.
  void work_out(const SphereStorage& rows, double time, ForceBuffers& loads, ThreadPool& pool);

  std::int64_t touching() const;
  double deepest() const;  ///< largest overlap over the smaller radius since the start
  void set_deepest(double overlap);
  /// Since the start up to this moment [J]: half of what the kick takes that is centered on it.
  ContactAccount<double> dissipated() const;
  double wall_work() const;  ///< likewise [J]
  /// The kick centered on the start's moment began before it.
  void begin_accounts();
  ContactSums sums() const;  ///< now

  /// Forces of the moment, to first order in the step: those of the step extrapolate velocities from the one
  /// before.
  std::vector<ContactState> states(const SphereStorage& rows, double time) const;
  /// What the next forces start from: to be had before work_out().
  ContactMemory memory() const { return {saved(), domain_.walls}; }
  /// Forces as the last work_out() had them, to round-off: the law once more for each contact, behind what
  /// the memory `before` it holds.
  std::vector<ContactState> last_forces(ContactMemory before, const SphereStorage& rows, double time) const;
  /// Where each contact's history is, part by part in the order of their keys, which those that give
  /// contacts one after the other follow.
  std::vector<ContactPlace> places() const;
  SavedContact saved(const ContactPlace& place) const {
    return parts_[place.part].histories.at(place.number, place.key);
  }
  std::vector<SavedContact> saved() const;
  /// Spheres lie in other rows now: `new_row` of each old one, within spheres of a kind. Contacts keep their
  /// histories, the neighbor list is built anew.
  void reorder_rows(const std::vector<std::int32_t>& new_row, const SphereStorage& rows, double time,
                    ThreadPool& pool);
  /// Part of the neighbor pairs that join spheres of different parts.
  double cross_part_fraction() const;
  /// The same with each row's sphere in its new row.
  double cross_part_fraction(const std::vector<std::int32_t>& new_row) const;
  void clear();
  void restore(const std::vector<SavedContact>& contacts);
  /// The ContactAccumulators of all parts as numbers of a saved state.
  std::vector<double> accumulators() const;
  static constexpr int accumulators_per_part = 7;
  void set_accumulators(const double* from);
  /// The same of the walls' records.
  std::vector<double> wall_records() const;
  void set_wall_records(const double* from);
  /// Where driven walls stood when the neighbor list was built [m]; 0 of others.
  std::vector<double> reference_shifts() const { return reference_shifts_; }
  /// Puts driven walls there.
  void set_drive_shifts(const std::vector<double>& shifts);

 private:
  /// visit(place) for every contact, part by part, pairs before walls.
  template <class Visit>
  void each_place(const Visit& visit) const;

  struct Part {
    PairList pairs;
    InnerPairList inner;
    std::vector<WallNeighbors> walls;
    std::vector<WallLoad> wall_loads;    ///< of each now
    std::vector<double> wall_brought;    ///< work of each as it came or went, waiting for end_forces() [J]
    std::vector<MeshNeighbors> meshes;   ///< of walls that are meshes, by the walls' numbers
    std::vector<RidgeNeighbors> ridges;  ///< of walls with edges among smooth fibers, likewise
    double path = 0;                     ///< sum of add_displacements() [m]
    ContactHistories histories;          ///< of the pairs and at the walls
    std::vector<std::int32_t> touching;
    std::vector<std::int32_t> segment_pairs;  ///< memory of SegmentView: four lists
    LaneArray segment_places;                 ///< likewise
    std::vector<HaloForce> halo;
    std::vector<std::vector<std::int32_t>> halo_of_part;  ///< numbers in halo, by the part they are for
    double deepest = 0;
    ContactAccumulators sums;
  };

  /// Lists change places with these, whose memory goes from part to part.
  struct UpdateScratch {
    PairList pairs;
    WallNeighbors wall;
    MeshNeighbors mesh;
    RidgeNeighbors ridges;
  };

  /// Fills the rows behind those of the spheres, for the lanes that pad vectors.
  void pad(SphereStorage& rows) const;
  void set_parameters();
  /// So many parts, the sums of all in the first.
  void cut(int count);
  double inner_cutoff() const;  ///< [m]
  /// The inner pairs of a part.
  void prune(Part& part, std::int32_t part_end, const SphereStorage& rows);
  /// Neighbor pairs and wall neighbors of all parts, of one part.
  void update_parts(ThreadPool& pool);
  void update_part(int part, UpdateScratch& scratch);
  void update_wall(int part, std::size_t wall, UpdateScratch& scratch);
  bool is_mesh(std::size_t wall) const { return shapes_[wall] == std::ssize(law_->shapes); }
  void update_mesh(int part, std::size_t wall, UpdateScratch& scratch);
  bool has_ridges(std::size_t wall) const { return !ridges_.empty() && ridges_[wall].mesh != nullptr; }
  /// Gap beyond the reach of the law up to which nodes at a wall with ridges are looked at [m].
  double near_gap(std::size_t wall) const;
  void update_ridges(int part, std::size_t wall, UpdateScratch& scratch);
  /// The surface of a wall that is a mesh, or taken for one: a solid box among smooth fibers.
  MeshShape mesh_at(const Wall& now, std::size_t wall, const WallPose& pose) const;
  /// By the parts that a part's halo forces are for.
  void sort_halo(int part, std::int32_t count);
  /// Numbers of the law's Parameters.
  const double* parameters_of(const SavedContact& contact) const;
  const double* wall_parameters(std::size_t wall, std::size_t kind) const {
    return wall_parameters_.data() + (wall * bodies_.size() + kind) * law_->parameters_size;
  }
  void exchange_bodies(SavedContact& contact) const;
  double energy_of(const SavedContact& contact) const;  ///< stored in its springs [J]
  double smaller_radius(const ContactKey& key) const;   ///< [m]
  /// At which its normal spring is pressed [W]. A kick lasts from half a step before to half a step after.
  double closing_power(const SavedContact& contact) const;
  /// What a wall that has just come stores in contacts at once [J].
  double brought_by(std::size_t wall, const Part& part) const;
  /// A wall that is gone takes what its contacts stored.
  void drop(std::size_t wall, Part& part) const;
  /// visit(key, number) for the contacts of a part's bodies with a wall.
  template <class Visit>
  void each_at_wall(const Part& part, std::size_t wall, const Visit& visit) const;
  int kind_of(const ContactBody& body);
  /// Largest gap at which any of these bodies and walls act on each other [m].
  double law_reach(const std::vector<ContactBody>& bodies) const;
  /// The law once more for each contact, with walls as these; history_before(contact) is what it starts from.
  template <class History>
  std::vector<ContactState> forces(const std::vector<Wall>& walls, const SphereStorage& rows, double time,
                                   double step, const History& history_before) const;
  /// A contact between segments that has begun, as the loop begins it (source_of, kernels/segments.hpp): with
  /// the history of one of these, by rising keys.
  SavedContact handed_on(const ContactKey& key, const std::vector<SavedContact>& before) const;
  bool is_there(const ContactKey& key) const;  ///< of two bodies
  /// Share and stiffness of the moment in the history before.
  static void set_shares(SavedContact& before, const SavedContact& now);
  /// With walls as these.
  /// Of the first body `arm` is the distance of the contact from `center`.
  TouchingPair<double> pair_at(const SavedContact& contact, const std::vector<Wall>& walls,
                               const SphereStorage& rows, double time, double& arm,
                               Vec<double, 3>& center) const;
  SegmentView view(Part& part, const SphereStorage& rows);
  /// Memory for as many pairs as the inner ones of a part.
  void reserve_segments(Part& part) const;
  /// Of two fibers.
  TouchingPair<double> fiber_pair_at(const SavedContact& contact, const SphereStorage& rows, double& arm,
                                     Vec<double, 3>& center) const;
  WallView wall_view(int wall, WallNeighbors& neighbors, double time) const;
  /// All loads of a part's spheres at the walls.
  void touch_walls(Part& part, const ContactView& contacts, double time, ContactTask& task);
  /// What of the meshes that are there each sphere of a part touches now.
  void find_mesh_contacts(Part& part, const SphereStorage& rows, double time);
  /// Of a wall with edges, that segments may touch.
  struct EdgedWall {
    std::shared_ptr<const TriangleMesh> mesh;
    MeshRidges ridges;
  };
  void find_walls_ridges();
  /// What segments touch of the ridges of walls that are there, behind find_mesh_contacts().
  void find_ridge_contacts(Part& part, const SphereStorage& rows, double time);
  /// The law for these, and for the nodes at such walls.
  void touch_ridges(Part& part, std::size_t wall, const ContactView& contacts, double time,
                    ContactTask& task);
  void put_ridge_contact(Part& part, const SavedContact& contact);
  TouchingPair<double> ridge_pair_at(const SavedContact& contact, const std::vector<Wall>& walls,
                                     const SphereStorage& rows, double time, double& arm,
                                     Vec<double, 3>& center) const;
  /// A contact that is known already, behind those of its part that come before it.
  void put_mesh_contact(Part& part, const SavedContact& contact);
  void add_mesh_ways(double time);
  /// Counts where a wall stands from another place at t = 0, without moving it or where it was listed.
  void count_from(std::size_t wall, const Vec<double, 3>& offset);
  /// How far its surface may be, where spheres are, from where it was when the list was built [m].
  double wall_displacement(std::size_t wall, double time) const;
  void measure_turn_reach();
  void keep_wall_poses(double time);
  /// Contacts that may begin in a step, at most.
  std::size_t most_new_contacts(const Part& part) const;

  Domain domain_;
  const ContactLaw* law_;
  std::vector<int> shapes_;              ///< of each wall: number among those of the law's loops
  std::vector<std::size_t> mesh_walls_;  ///< by rising number
  PeriodicBox periods_;
  bool accounted_;
  InstructionSet instruction_set_;
  std::vector<ContactBody> bodies_;  ///< of each kind
  std::vector<double> pair_parameters_,
      wall_parameters_;  ///< of the law, numbers of each pair of kinds, of each wall and kind
  std::vector<double> radius_;
  std::vector<std::int32_t> fiber_, kind_of_sphere_;
  double step_;
  double skin_ = 0, law_reach_ = 0;  ///< [m]
  const ContactKernel* kernel_ = nullptr;
  FiberBodies fiber_bodies_;
  std::vector<std::pair<ContactKey, double>> shares_before_;  ///< of what ends at breaks had in contacts
  double brought_between(std::int64_t first, std::int64_t second) const;
  ContactKernel smooth_kernel_{};                  ///< of scenes with smooth fibers
  const SegmentKernel* segment_kernel_ = nullptr;  ///< likewise
  std::vector<EdgedWall> ridges_;                  ///< of each wall; empty without smooth fibers
  NeighborList neighbors_;
  double reference_time_ = 0;
  std::vector<WallPose> reference_poses_;  ///< of the walls when the list was built
  std::vector<double> reference_shifts_;   ///< of those that are driven [m]
  std::vector<double>
      turn_reach_;  ///< of each: distance of spheres from where it turns; 0 unless visibly [m]
  std::vector<WallPose> mesh_poses_;  ///< of walls at the last add_displacements(); empty without meshes
  std::vector<double> mesh_ways_;     ///< bound of what each mesh went since whenever, where spheres are [m]
  std::vector<WallRecord> records_;
  std::vector<Part> parts_;
  std::vector<UpdateScratch> scratch_;  ///< one a thread
  PartDependencies reach_;
};

template <class Visit>
void Contacts::each_at_wall(const Part& part, std::size_t w, const Visit& visit) const {
  const Primitive facet = facet_primitive(static_cast<std::int64_t>(w));
  const WallNeighbors& neighbors = part.walls[w];
  for (std::size_t n = 0; n < neighbors.count; ++n) {
    if (neighbors.contact[n] == 0) continue;
    visit(ContactKey{sphere_primitive(neighbors.slots[n]), facet, neighbors.key_slot(n)},
          neighbors.contact[n]);
  }
  if (!has_ridges(w)) return;
  const RidgeContacts& ridges = part.ridges[w].contacts();
  for (std::size_t n = 0; n < ridges.count; ++n)
    visit(ContactKey{segment_primitive(ridges.bodies[n]), facet, ridges.features[n]}, ridges.contact[n]);
}

template <class Visit>
void Contacts::each_place(const Visit& visit) const {
  for (std::int32_t k = 0; const Part& part : parts_) {
    const PairList& pairs = part.pairs;
    for (std::size_t p = 0; p < pairs.count; ++p) {
      if (pairs.contact[p] == 0) continue;
      visit(ContactPlace{{fiber_bodies_.primitive(pairs.first[p]), fiber_bodies_.primitive(pairs.second[p])},
                         k,
                         pairs.contact[p]});
    }
    for (std::size_t w = 0; w < part.walls.size(); ++w)
      each_at_wall(part, w, [&](const ContactKey& key, std::int32_t number) {
        visit(ContactPlace{key, k, number});
      });
    ++k;
  }
}

}  // namespace fiberchain::dem
