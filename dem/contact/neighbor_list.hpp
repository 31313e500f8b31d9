#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "dem/chain/sphere_storage.hpp"
#include "dem/contact/fiber_bodies.hpp"
#include "dem/contact/size_classes.hpp"
#include "dem/parallel/partition.hpp"
#include "dem/parallel/thread_pool.hpp"

// The Verlet list. Neighbors follow from each sphere's reference position alone. A sphere that has moved far
// from it gets a new one, and only its neighbors are searched again.
namespace fiberchain::dem {

struct Pair {
  std::int32_t first, second;  ///< sphere numbers, first < second
  auto operator<=>(const Pair&) const = default;
};

class NeighborList {
 public:
  NeighborList() = default;
  /// Pairs with a gap below `skin` [m] are neighbors. `kernel` is that of the scene's contacts (periodic or
  /// not).
  NeighborList(SphereSet spheres, double skin, Partition parts, const ContactKernel& kernel);
  /// The same of the bodies of smooth fibers, which outlive the list: those are searched by the spheres
  /// around them, and are neighbors where they are closer themselves. Their nodes have the reference
  /// positions, so that what holds of spheres holds of them: no point of a segment moves farther than one of
  /// its ends. Searching throws InvalidInput for a segment that is stretched beyond its bounding sphere.
  NeighborList(SphereSet bounds, double skin, Partition parts, const ContactKernel& kernel,
               const FiberBodies& bodies);

  double skin() const { return skin_; }
  const SphereSet& spheres() const { return spheres_; }
  const Partition& parts() const { return parts_; }
  const std::vector<Vec<double, 3>>& reference_positions() const { return reference_positions_; }

  /// Other numbers of fibers, for the next build().
  void set_fibers(const std::vector<std::int32_t>& fiber) { spheres_.fiber = fiber; }
  /// The neighbors of all spheres, which stand at these positions. Throws InvalidInput for positions that are
  /// not finite, and where a period is shorter than twice 2 R + skin.
  void build(std::vector<Vec<double, 3>> positions, ThreadPool& pool);
  /// Largest displacement of a sphere from its reference position [m].
  double farthest_moved(const SphereStorage& rows, ThreadPool& pool) const;
  /// Those displaced by more than `distance` [m] get new reference positions and neighbors; throws as
  /// build().
  void update(const SphereStorage& rows, double distance, ThreadPool& pool);

  /// Spheres of a part whose neighbors the last call has searched, by rising number.
  const std::vector<std::int32_t>& rebuilt(int part) const { return searches_[part].rebuilt; }
  bool is_rebuilt(std::int32_t sphere) const { return rebuilt_[sphere] != 0; }
  /// Neighbor pairs with one of these or two, whose first sphere is of the part, in order.
  std::vector<Pair> found(int part) const;

 private:
  /// Result of the search around a part's spheres.
  struct Search {
    std::vector<std::int32_t> rebuilt;
    std::vector<Pair> own;      ///< whose first sphere is of the part
    std::vector<Pair> earlier;  ///< whose first sphere is of an earlier part, in order
    std::uint32_t strayed = 0;  ///< classes of size to be sorted again, bit by bit
    std::uint32_t staying = 0;  ///< those with spheres that are not searched
  };
  /// Pairs of a part that the search of a later part found.
  struct Incoming {
    int part;
    std::size_t begin, end;  ///< in its `earlier`
  };
  /// What a search of a part goes on with from sphere to sphere.
  struct Scratch;
  void check_finite() const;
  /// Where bodies are searched: at the reference positions of spheres, in the middle of segments.
  const std::vector<Vec<double, 3>>& places() const {
    return bodies_ != nullptr ? middles_ : reference_positions_;
  }
  bool set_middle(std::int32_t body);
  /// Whether two bodies are neighbors whose bounding spheres are.
  bool are_close(std::int32_t a, std::int32_t b) const;
  SegmentNodes<double> reference_nodes(std::int32_t body) const;
  bool has_moved(const SphereStorage& rows, std::int32_t sphere, double distance) const;
  void search(ThreadPool& pool);
  void search(int part);
  /// Calls found(number) for the neighbors of a sphere in its own class or a larger one, in a smaller one.
  template <class Found>
  void search_near(std::int32_t sphere, int size_class, Scratch& scratch, const Found& found) const;
  template <class Found>
  void search_within(std::int32_t sphere, int size_class, Scratch& scratch, const Found& found) const;
  template <class Found>
  void query(std::int32_t sphere, int size_class, const SlotRange* runs, int count, Scratch& scratch,
             const Found& found) const;
  void collect_incoming();

  SphereSet spheres_;
  double skin_ = 0;
  std::vector<Vec<double, 3>> reference_positions_;
  const FiberBodies* bodies_ = nullptr;  ///< of smooth fibers
  std::vector<Vec<double, 3>> middles_;  ///< of their bodies
  std::vector<std::uint8_t> rebuilt_;
  Partition parts_;
  std::vector<Search> searches_;
  std::vector<std::vector<Incoming>> incoming_;  ///< of each part
  const ContactKernel* kernel_ = nullptr;
  PeriodicBox periods_{};
  SizeClasses sorted_;
  std::uint32_t staying_ = 0;  ///< of all parts
};

}  // namespace fiberchain::dem
