#pragma once

#include <vector>

#include "dem/assembly/assembly.hpp"
#include "dem/assembly/contact_parameters.hpp"
#include "dem/assembly/sphere_rows.hpp"
#include "dem/assembly/team.hpp"
#include "dem/contact/neighbors.hpp"
#include "dem/contact/view.hpp"

// All contacts of an assembly: which spheres are close, what their contacts remember, and their loads.
namespace fiberchain::dem {

/// What a touching pair remembers, by sphere numbers, to be kept when the pairs are listed anew or written to a file.
/// second < 0: wall -1 - second.
struct KeptContact {
  std::int64_t first, second;
  double spring[3];  ///< on the first
  double overlap, opening;
  double work[work_numbers] = {};  ///< booked only
};

/// The same of many contacts, row by row.
struct ContactMemory {
  LaneArray rows, work;
  std::vector<std::uint8_t> touched;
  bool booked = false;

  /// That many contacts that do not touch.
  void reset(std::size_t size);
  KeptContact at(std::size_t i, std::int64_t first, std::int64_t second) const;
  void put(std::size_t i, const KeptContact& contact);
};

class ContactSet {
 public:
  ContactSet(const Surroundings& surroundings, const AssemblyOptions& options, double step);

  /// More fibers, after those that are there.
  void add(const Fiber& fiber, int count);
  /// Once all have been added: sets what stands behind the spheres' rows.
  void pad(SphereRows& rows);

  std::int64_t spheres() const { return static_cast<std::int64_t>(fiber_.size()); }
  double skin() const { return skin_; }

  /// Lists the pairs that are close at these positions anew; contacts that touch keep what they remember.
  void list_pairs(std::vector<Vec<double, 3>> positions, double time, Team& team);
  /// The same at the rows' positions.
  void list_pairs(const SphereRows& rows, double time, Team& team);
  /// How far any sphere is from where it was listed [m].
  double farthest_moved(const SphereRows& rows, Team& team) const;
  /// Whether a wall has moved so far since then that spheres near it may be missing.
  bool walls_moved_far(double time) const;
  const std::vector<Vec<double, 3>>& listed_at() const { return listed_at_; }
  double listed_time() const { return listed_time_; }

  int stripes() const { return static_cast<int>(stripes_.size()); }
  /// Loads of a stripe's pairs and walls; what leaves the stripe waits for gather_loads().
  void work_out(int stripe, SphereRows& rows, double time);
  /// Adds what other stripes have for this one, in their order.
  void gather_loads(int stripe, SphereRows& rows);

  std::int64_t touching() const;
  /// Since the start up to this moment [J]: half of what the kick takes that is centered on it.
  ContactBook<double> taken() const;
  double wall_work() const;           ///< likewise [J]
  /// The kick centered on the start's moment began before it.
  void begin_books();
  double stored_energy() const;       ///< in the springs now [J]

  std::vector<ContactState> states(const SphereRows& rows, double time) const;
  std::vector<KeptContact> kept() const;
  void forget();
  void remember(const std::vector<KeptContact>& contacts);
  /// Sums that go on when a saved state is gone on with: stripe by stripe.
  std::vector<double> sums() const;
  static constexpr int sums_a_stripe = 9;
  void set_sums(const double* from);

 private:
  /// Spheres of a stripe near a wall and what those contacts remember.
  struct NearWall {
    std::vector<std::int32_t> slots;
    ContactMemory memory;
  };
  struct Stripe {
    std::vector<std::int32_t> first, second, touching;
    ContactMemory memory;
    std::vector<DeferredForce> deferred;
    std::vector<NearWall> walls;
    std::vector<std::vector<std::int32_t>> for_stripe;  ///< places in deferred
    std::int64_t contacts = 0;
    ContactBook<double> book{}, power{};
    double wall_work = 0, wall_power = 0;
  };

  void fill_stripe(int stripe);
  void list_walls(int stripe);
  void remember(int stripe, const std::vector<KeptContact>& contacts);
  std::vector<KeptContact> kept_in(int stripe) const;
  double energy_of(const KeptContact& contact) const;  ///< stored in its springs [J]
  /// A wall that is gone takes what its contacts stored.
  void drop(NearWall& near, int wall, Stripe& stripe) const;
  int kind_of(const ContactBody& body);
  ContactView view(Stripe& stripe, SphereRows& rows);
  WallView wall_view(int wall, NearWall& near, double time) const;

  Surroundings surroundings_;
  bool booked_;
  InstructionSet instruction_set_;
  std::vector<ContactBody> bodies_;  ///< of each kind
  std::vector<ContactParameters<double>> pair_parameters_, wall_parameters_;
  std::vector<double> radius_;
  std::vector<std::int32_t> fiber_, kind_of_sphere_;
  double step_, skin_ = 0;
  const ContactKernel* kernel_ = nullptr;
  std::vector<std::int32_t> stripe_begin_;
  std::vector<std::vector<ClosePair>> pairs_;
  std::vector<Vec<double, 3>> listed_at_;
  double listed_time_ = 0;
  std::vector<Stripe> stripes_;
};

}  // namespace fiberchain::dem
