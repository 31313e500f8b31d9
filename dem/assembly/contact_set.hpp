#pragma once

#include <algorithm>
#include <vector>

#include "dem/assembly/assembly.hpp"
#include "dem/assembly/close_list.hpp"
#include "dem/assembly/contact_memory.hpp"
#include "dem/assembly/contact_parameters.hpp"
#include "dem/assembly/sphere_rows.hpp"
#include "dem/assembly/stripe_loads.hpp"
#include "dem/assembly/team.hpp"
#include "dem/contact/view.hpp"

// All contacts of an assembly: which spheres are close, what their contacts remember, and their loads.
namespace fiberchain::dem {

class ContactSet {
 public:
  ContactSet(const Surroundings& surroundings, const AssemblyOptions& options, double step);

  /// Throws InvalidInput where periodic sides are too near for these fibers beside those there.
  void check_periods(const std::vector<FiberGroup>& more) const;
  /// More fibers, after those that are there.
  void add(const Fiber& fiber, int count);
  /// Once all have been added: cuts the spheres into stripes and lists them; contacts that touch keep what they remember.
  void begin(SphereRows& rows, Stripes stripes, double time, Team& team);

  std::int64_t spheres() const { return static_cast<std::int64_t>(fiber_.size()); }
  double skin() const { return close_.skin(); }

  /// Lists all spheres at these places, who is close to whom; contacts that touch keep what they remember.
  void list_pairs(std::vector<Vec<double, 3>> places, double time, Team& team);
  /// The same at the rows' places.
  void list_pairs(const SphereRows& rows, double time, Team& team);
  /// Lists spheres that have come far anew, where some have; how far any may move before it must be asked again [m].
  double follow(const SphereRows& rows, Team& team);
  /// Whether a wall has moved so far that spheres near it may be missing: time for list_pairs().
  bool walls_moved_far(double time) const;
  const std::vector<Vec<double, 3>>& listed_at() const { return close_.places(); }
  double listed_time() const { return listed_time_; }

  /// Spheres of each stripe move on by no more than `paths` [m] before the next work_out().
  void count_paths(const std::vector<double>& paths);
  const Stripes& stripes() const { return close_.stripes(); }

  /// Of which stripes' spheres the contacts of each read, and for which they have loads.
  const StripeReach& reach() const { return reach_; }
  /// Adds the loads of a stripe's contacts to its own; what leaves the stripe waits for gather_loads().
  void work_out(int stripe, const SphereRows& rows, double time, LoadRange loads);
  /// Adds what earlier stripes have for this one, in their order.
  void gather_loads(int stripe, LoadRange loads);
  /// Both for all stripes, none of which has loads.
  void work_out(const SphereRows& rows, double time, StripeLoads& loads, Team& team);

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
  /// Close pairs, in order, padded to whole vectors.
  struct PairList {
    std::vector<std::int32_t> first, second, contact;  ///< spheres, and numbers in the memory
    std::size_t count = 0;  ///< without pads
    int last_stripe = -1;   ///< of a second sphere

    void clear();
  };
  /// Those of the pairs that may touch soon.
  struct NearList {
    std::vector<std::int32_t> pair, first, second, contact;
    std::vector<std::uint8_t> touches;
    std::int32_t count = 0;
    double closer = 0;   ///< what other pairs may have come closer since [m]
    bool is_old = true;  ///< to be made before it is used

    void make_room(std::size_t numbers);
    NearPairs view() { return {pair.data(), first.data(), second.data(), contact.data(), touches.data()}; }
  };
  /// Spheres near a wall, likewise.
  struct NearWall {
    std::vector<std::int32_t> slots, contact;
    std::size_t count = 0;
  };
  struct Stripe {
    PairList pairs, next_pairs;  ///< those to come while they are made
    NearList near;
    std::vector<NearWall> walls;
    NearWall next_wall;
    ContactMemory memory;  ///< of the pairs and at the walls
    std::vector<std::int32_t> touching;
    std::vector<DeferredForce> deferred;
    std::vector<std::vector<std::int32_t>> for_stripe;  ///< places in deferred
    std::int64_t contacts = 0;
    ContactBook<double> book{}, power{};
    double wall_work = 0, wall_power = 0;
  };

  /// Sets what stands behind the spheres' rows.
  void pad(SphereRows& rows) const;
  void set_parameters();
  /// As many stripes, the sums of all in the first.
  void cut(int stripes);
  double near_gap() const;  ///< [m]
  /// The near pairs of a stripe from now on.
  void choose_near(Stripe& stripe, std::int32_t stripe_end, const SphereRows& rows);
  void renew(Team& team);
  void renew_pairs(int stripe);
  void renew_wall(int stripe, int wall);
  double energy_of(const KeptContact& contact) const;  ///< stored in its springs [J]
  const ContactParameters<double>& parameters_of(const KeptContact& contact) const;
  /// At which its normal spring is pressed [W]. A kick lasts from half a step before to half a step after.
  double closing_power(const KeptContact& contact) const;
  /// What a wall that has just come stores in contacts at once [J].
  double brought_by(const NearWall& near, const Stripe& stripe) const;
  /// A wall that is gone takes what its contacts stored.
  void drop(NearWall& near, int wall, Stripe& stripe) const;
  int kind_of(const ContactBody& body);
  ContactView view(Stripe& stripe, const SphereRows& rows);
  WallView wall_view(int wall, NearWall& near, double time) const;
  /// Numbers in the memory that a step may need.
  std::size_t may_begin(const Stripe& stripe) const;

  Surroundings surroundings_;
  Periods periods_;
  bool booked_;
  InstructionSet instruction_set_;
  std::vector<ContactBody> bodies_;  ///< of each kind
  std::vector<ContactParameters<double>> pair_parameters_, wall_parameters_;
  std::vector<double> radius_;
  std::vector<std::int32_t> fiber_, kind_of_sphere_;
  double step_;
  const ContactKernel* kernel_ = nullptr;
  CloseList close_;
  double listed_time_ = 0;
  std::vector<Stripe> stripes_;
  StripeReach reach_;
};

}  // namespace fiberchain::dem
