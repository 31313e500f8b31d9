#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "dem/assembly/sphere_rows.hpp"
#include "dem/assembly/stripes.hpp"
#include "dem/assembly/team.hpp"
#include "dem/contact/cell_runs.hpp"

// Which spheres are close. Every sphere is listed at a place; who is close follows from these places alone. A sphere that has
// moved far from its place is listed at a new one, and only its neighbors are searched anew.
namespace fiberchain::dem {

struct ClosePair {
  std::int32_t first, second;  ///< sphere numbers, first < second
  auto operator<=>(const ClosePair&) const = default;
};

/// Spheres by number.
struct SphereSet {
  std::vector<double> radius;       ///< [m]
  std::vector<std::int32_t> fiber;  ///< neighbors along a fiber have consecutive numbers and do not contact
  Vec<double, 3> period;            ///< [m]; 0: not periodic
};

class CloseList {
 public:
  CloseList() = default;
  /// Pairs with a gap below `skin` [m] are close. `kernel` is that of the scene's contacts (periodic or not).
  CloseList(SphereSet spheres, double skin, Stripes stripes, const ContactKernel& kernel);

  double skin() const { return skin_; }
  const SphereSet& spheres() const { return spheres_; }
  const Stripes& stripes() const { return stripes_; }
  const std::vector<Vec<double, 3>>& places() const { return places_; }

  /// Lists all spheres at these places. Throws InvalidInput for places that are not finite, and where a periodic side is
  /// shorter than twice 2 R + skin.
  void list(std::vector<Vec<double, 3>> places, Team& team);
  /// How far any sphere is from its place [m].
  double farthest_moved(const SphereRows& rows, Team& team) const;
  /// Lists those that are farther than `distance` [m] from their places where they are now; throws as list().
  void relist(const SphereRows& rows, double distance, Team& team);

  /// Spheres of a stripe that the last call has listed anew, by rising number.
  const std::vector<std::int32_t>& listed_anew(int stripe) const { return searches_[stripe].anew; }
  bool is_anew(std::int32_t sphere) const { return anew_[sphere] != 0; }
  /// Close pairs with one of these or two, whose first sphere is of the stripe, in order.
  std::vector<ClosePair> found(int stripe) const;

 private:
  /// What has come of a stripe's spheres.
  struct Search {
    std::vector<std::int32_t> anew;
    std::vector<std::vector<ClosePair>> found;  ///< by the stripe of the first
  };
  void sort();
  void check_finite() const;
  void search(Team& team);
  void search(int stripe);

  SphereSet spheres_;
  double skin_ = 0;
  std::vector<Vec<double, 3>> places_;
  std::vector<std::uint8_t> anew_;
  Stripes stripes_;
  std::vector<Search> searches_;
  const ContactKernel* kernel_ = nullptr;
  std::optional<CellRuns> sorted_;
  double slack_ = 0;  ///< what spheres may move from where they were sorted [m]
};

}  // namespace fiberchain::dem
