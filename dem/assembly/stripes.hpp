#pragma once

#include <cstdint>
#include <vector>

namespace fiberchain::dem {

/// Spheres of consecutive numbers, cut into pieces. Where the cuts are follows from the scene alone, so that sums over a
/// stripe are the same for any number of threads.
class Stripes {
 public:
  Stripes() = default;
  /// The last number is one past the last sphere, the first one 0.
  explicit Stripes(std::vector<std::int32_t> begins);

  int count() const { return static_cast<int>(begins_.size()) - 1; }
  std::int32_t begin(int stripe) const { return begins_[stripe]; }
  std::int32_t end(int stripe) const { return begins_[stripe + 1]; }
  int of(std::int64_t sphere) const { return stripe_[sphere]; }

 private:
  std::vector<std::int32_t> begins_{0};
  std::vector<std::uint16_t> stripe_;  ///< of each sphere
};

/// How far what stripes do goes: each to later ones, up to a last one.
class StripeReach {
 public:
  StripeReach() = default;
  /// The last stripe that each one reaches, itself or a later one.
  explicit StripeReach(std::vector<int> last);

  int count() const { return static_cast<int>(last_.size()); }
  int last(int stripe) const { return last_[stripe]; }
  /// The first stripe that reaches this one. Not all behind it need do.
  int first_to_reach(int stripe) const { return first_[stripe]; }

 private:
  std::vector<int> last_, first_;
};

/// Spheres of a stripe that the inner cache holds: some 250 bytes each, a quarter of 2 MB.
inline constexpr std::int64_t cached_spheres = 2048;

/// Spheres in stripes of about as many each.
Stripes even_stripes(std::int32_t spheres, int count);

/// Cuts that lie nearest to those of stripes which the inner cache of a processor holds, with what their contacts and bonds
/// remember; each piece of a scene (`ends`, one past its last sphere, rising) stays whole.
Stripes cached_stripes(const std::vector<std::int32_t>& ends);

}  // namespace fiberchain::dem
