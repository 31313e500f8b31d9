#pragma once

#include <cstdint>
#include <vector>

namespace fiberchain::dem {

/// Spheres of consecutive numbers, cut into pieces. Where the cuts are follows from the scene alone, so that
/// sums over a part are the same for any number of threads.
class Partition {
 public:
  Partition() = default;
  /// The last number is one past the last sphere, the first one 0.
  explicit Partition(std::vector<std::int32_t> begins);

  int count() const { return static_cast<int>(begins_.size()) - 1; }
  std::int32_t begin(int part) const { return begins_[part]; }
  std::int32_t end(int part) const { return begins_[part + 1]; }
  int of(std::int64_t sphere) const { return part_[sphere]; }

 private:
  std::vector<std::int32_t> begins_{0};
  std::vector<std::uint16_t> part_;  ///< of each sphere
};

/// Which parts what each one does goes to: itself and some later ones.
class PartDependencies {
 public:
  PartDependencies() = default;
  /// The later parts that each one reaches, rising.
  explicit PartDependencies(std::vector<std::vector<int>> reached);

  int count() const { return static_cast<int>(reached_.size()); }
  /// The later parts that this one reaches, rising.
  const std::vector<int>& reached(int part) const { return reached_[part]; }
  /// The earlier parts that reach this one, rising.
  const std::vector<int>& dependencies(int part) const { return dependencies_[part]; }

 private:
  std::vector<std::vector<int>> reached_, dependencies_;
};

/// Spheres of a part that the inner cache holds: some 250 bytes each, a quarter of 2 MB.
inline constexpr std::int64_t cache_sized_part = 2048;

/// Spheres in parts of about as many each.
Partition even_partition(std::int32_t spheres, int count);

/// Cuts that lie nearest to those of parts which the inner cache of a processor holds, with what their
/// contacts and bonds remember; each piece of a scene (`ends`, one past its last sphere, rising) stays whole.
Partition cache_sized_partition(const std::vector<std::int32_t>& ends);

}  // namespace fiberchain::dem
