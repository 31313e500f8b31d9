#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "dem/contact/contact_law.hpp"
#include "dem/contact/inner_pairs.hpp"
#include "dem/contact/wall_neighbors.hpp"
#include "dem/contact/wall_record.hpp"
#include "dem/contact/wall_view.hpp"
#include "dem/lammps/plan.hpp"
#include "dem/lammps/rows.hpp"

// Contacts of a rank's spheres by the engine's own loops: pairs that LAMMPS lists, walls.
namespace fiberchain::dem::mpi {

/// A pair of slots, the first one of this rank's own.
struct SlotPair {
  std::int32_t first, second;
};

class RankContacts {
 public:
  RankContacts(const Plan& plan, InstructionSet set);

  /// Contacts leave the lists for their spheres: these may then change slots and ranks. `number` of each
  /// slot.
  void unlist(Rows& rows, int own, const std::function<std::int64_t(int)>& number);
  /// Lists of these pairs, and of own spheres near walls at this time; contacts come back from their spheres.
  void list(Rows& rows, int own, int all, const std::vector<SlotPair>& pairs, double time,
            const std::function<std::int64_t(int)>& number);
  bool listed() const { return listed_; }
  /// How far spheres of any rank are from where walls turn, at most [m]: the same on all, who must agree on
  /// when to list anew.
  void set_turn_reach(double reach) { turn_reach_ = reach; }

  /// Spheres have moved by no more than `path` [m] since.
  void add_path(double path);
  /// Whether spheres have moved so far that work_out() wants prune() before.
  bool stale() const { return inner_.stale; }
  /// The pairs that may touch before the next pruning; all loads are then 0.
  void prune(Rows& rows, int all);
  /// Slots of those pairs and of spheres near walls, rising: of all others work_out() needs no rows.
  const std::vector<std::int32_t>& near() const { return near_slots_; }
  /// Loads of these; only own spheres' are whole.
  void work_out(Rows& rows, int all, double time);
  /// Those that have loads then, each once: of all others they are 0.
  const std::vector<std::int32_t>& loaded() const { return loaded_; }

  /// Forces and moments on the walls by this rank's spheres at the last work_out(): force, moment of each.
  const std::vector<double>& wall_loads() const { return wall_loads_; }
  /// With the forces of all ranks: records and driven walls move on, as Contacts::end_forces() and
  /// move_walls() have it.
  void end_forces(const std::vector<double>& loads_of_all, double time);
  void move_walls();
  /// Whether a wall has moved so far that spheres near it may not be listed.
  bool walls_moved_far() const;

  std::vector<double> wall_records() const;
  void set_wall_records(const std::vector<double>& records);
  const std::vector<Wall>& walls() const { return walls_; }
  double deepest() const { return deepest_; }
  void set_deepest(double overlap) { deepest_ = overlap; }

  /// use(first slot, second slot or -1 - wall, history) for each contact.
  using UseContact = std::function<void(std::int32_t, std::int64_t, const double*)>;
  void each(const UseContact& use) const;

 private:
  ContactView view(Rows& rows);
  void find_near_slots(int all);
  void find_loaded(int touching);
  void touch_walls(const ContactView& contacts, double time, ContactTask& task);
  double inner_cutoff() const;

  const Plan& plan_;
  const ContactLaw& law_;
  const ContactKernel& kernel_;
  std::vector<Wall> walls_;
  std::vector<int> shapes_;
  std::vector<WallRecord> records_;
  std::vector<double> wall_loads_, wall_paths_;  ///< paths since the lists were made [m]
  double turn_reach_ = 0;                        ///< [m]
  std::vector<std::int32_t> first_, second_, contact_;
  std::int32_t pairs_ = 0;  ///< without pads
  InnerPairList inner_;
  std::vector<WallNeighbors> near_;
  ContactHistories histories_;
  std::vector<std::int32_t> touching_, near_slots_, loaded_;
  std::vector<std::uint8_t> is_near_, is_loaded_;  ///< by slot
  double deepest_ = 0;
  bool listed_ = false;
};

}  // namespace fiberchain::dem::mpi
