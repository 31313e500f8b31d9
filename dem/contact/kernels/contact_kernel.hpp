#pragma once

#include <cstdint>

#include "dem/contact/laws/contact_action.hpp"
#include "dem/contact/periodic_box.hpp"
#include "dem/model/shapes/wall_shape.hpp"
#include "dem/simd/instruction_set.hpp"
#include "dem/simd/storage_layout.hpp"

// What the contact loops read and write: plain arrays, so that one compiled copy an instruction set serves
// all.
namespace fiberchain::dem {

/// Reserve that arrays need behind their end, so that whole vectors can be read or written there.
inline constexpr int lanes_beyond = 16;

/// What a contact loop has. A template argument: what a scene lacks is not compiled into it.
struct ContactPhysics {
  bool uniform;    ///< one radius and one set of parameters for all spheres
  bool periodic;   ///< some side is periodic
  bool rolling;    ///< rolling friction
  bool accounted;  ///< sums of the energy that each mechanism dissipates
};

/// Every combination that is built, of each law.
inline constexpr int contact_combinations = 16;
constexpr ContactPhysics contact_physics(int n) {
  return {(n & 1) != 0, (n & 2) != 0, (n & 4) != 0, (n & 8) != 0};
}
/// Number of a kernel in the table of a list of laws, of which this is the law's number.
constexpr int contact_index(const ContactPhysics& p, int law) {
  return law * contact_combinations + (p.uniform ? 1 : 0) + (p.periodic ? 2 : 0) + (p.rolling ? 4 : 0) +
         (p.accounted ? 8 : 0);
}

/// All spheres by number, behind them some that pad whole vectors ("slots"), and the pairs that are close.
struct ContactView {
  const double *position_radius, *velocity_spin;
  const std::int32_t* kind;  ///< of each slot
  double radius;             ///< of all, where it is uniform
  const std::int32_t* first;
  const std::int32_t* second;
  std::int32_t* contact;     ///< of each pair that touched a step before: its number; 0 of others
  double* histories;         ///< a row a number
  double* work;              ///< accounted: a row a number, the powers of the step before
  const double* parameters;  ///< the law's Parameters of kinds a and b, number a * kinds + b
  std::int32_t kinds;
  PeriodicBox periods;
  double step;
  double reach;  ///< gap up to which the law acts, where it acts beyond touch [m]
};

/// Pairs pruned from the neighbor list, padded to whole vectors.
struct InnerPairs {
  std::int32_t *pair, *first, *second, *contact;
  std::uint8_t* touches;  ///< whether it has a number: 1 or 0
};

/// What a pair does to a sphere of a later part, which that part adds up itself.
struct HaloForce {
  double load[6];
  std::int64_t slot;
};

/// A wall as it is now, and the spheres of a part near it.
struct WallView {
  int shape_index;                         ///< of its shape in the kernels' list; behind them all: of meshes
  double shape[wall_shape_size];           ///< numbers of its shape
  double center[3], velocity[3], spin[3];  ///< of its motion half a step before, about a center now
  const std::int32_t* slots;
  std::int32_t count;        ///< padded to whole vectors
  const double* nearest;     ///< of meshes: directions x, y, z and distances, a row of `count` each
  std::int32_t* contact;     ///< as of pairs
  const double* parameters;  ///< the law's Parameters of each kind
};

/// One part of slots, its pairs, and what came of them. A part is worked on by one thread; its results do not
/// depend on which.
struct ContactTask {
  InnerPairs inner;
  std::int32_t inner_count;  ///< padded to whole vectors
  std::int32_t slots_begin, slots_end;
  double* loads;           ///< of these slots
  std::int32_t* touching;  ///< inner pairs that touch; capacity for all and lanes_beyond
  std::int32_t* free;      ///< numbers for contacts that begin, those that end give them back
  std::int32_t free_count;
  HaloForce* halo;  ///< capacity for all inner pairs with a sphere of a later part
  std::int32_t halo_count;
  std::int64_t contacts;  ///< counted
  ContactAccount<double> account;
  ContactAccount<double> power;          ///< of this moment [W]
  double wall_force[3], wall_moment[3];  ///< on the wall, about its center: summed
  double deepest;                        ///< largest overlap over the (smaller) radius so far
};

/// Spheres in some order, with lanes_beyond behind them.
struct SortedSpheres {
  const double* x[3];
  const double* radius;
  const std::int32_t* sphere;  ///< number
  const std::int32_t* fiber;
};

struct SlotRange {
  std::int32_t begin, end;
};

/// A sphere whose neighbors are asked for.
struct NeighborQuery {
  double x[3];
  double reach;  ///< its radius and the largest gap of a neighbor
  std::int32_t sphere, fiber;
  PeriodicBox periods;
};

struct ContactKernel {
  int width;
  /// Appends those of these pairs, whole vectors of them, that have a gap below `gap` [m] or touched the step
  /// before to the first `found`; how many then.
  std::int32_t (*prune)(const ContactView&, std::int32_t begin, std::int32_t end, double gap,
                        const InnerPairs&, std::int32_t found);
  void (*pairs)(const ContactView&, ContactTask&);
  void (*wall)(const ContactView&, const WallView&, ContactTask&);
  /// Neighbors in these runs of sorted spheres, without those bonded to the asking one: written to `found`,
  /// counted.
  std::int32_t (*query_neighbors)(const SortedSpheres&, const SlotRange* runs, int count,
                                  const NeighborQuery&, std::int32_t* found);
};

/// Kernels of one instruction set for a list of laws and one of wall shapes, in the order of contact_index().
template <class Laws, class Shapes, InstructionSet set>
struct ContactKernels {
  static const ContactKernel* table();
};

template <class Laws, class Shapes>
struct ContactKernelFamily {
  template <InstructionSet set>
  using Of = ContactKernels<Laws, Shapes, set>;
};

}  // namespace fiberchain::dem
