#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "dem/assembly/assembly.hpp"
#include "dem/motion/physics.hpp"

namespace fiberchain::dem {

/// How the numbers of a group lie in a saved state: whoever reads it needs not know the assembly.
struct GroupLayout {
  std::int64_t fibers, spheres;            ///< of the group, of each fiber
  std::int64_t width;                      ///< fibers of a block
  std::int64_t law_numbers, bond_numbers;  ///< of a bond: those of its law, those with its branches
  BondForm form;

  std::int64_t blocks() const { return (fibers + width - 1) / width; }
  bool makes_sense() const {
    constexpr std::int64_t most = 2'000'000'000;
    const auto fits = [](std::int64_t n) { return n > 0 && n <= most; };
    return fits(fibers) && fits(spheres) && spheres > 1 && fibers * spheres <= most && fits(width) &&
           law_numbers >= 0 && bond_numbers >= law_numbers && bond_numbers < 100'000;
  }
};

/// Of an assembly's groups.
std::vector<GroupLayout> group_layouts(const Assembly::State& state);

inline constexpr std::string_view layout_field = "group_layout";

/// As the numbers of a field, and back.
inline std::vector<std::int64_t> to_numbers(const std::vector<GroupLayout>& groups) {
  std::vector<std::int64_t> all;
  for (const GroupLayout& g : groups) {
    all.insert(all.end(), {g.fibers, g.spheres, g.width, g.law_numbers, g.bond_numbers,
                           static_cast<std::int64_t>(g.form)});
  }
  return all;
}
inline std::vector<GroupLayout> group_layouts_in(const std::vector<std::int64_t>& numbers) {
  std::vector<GroupLayout> all;
  for (std::size_t n = 0; n + 6 <= numbers.size(); n += 6) {
    const std::int64_t* g = numbers.data() + n;
    all.push_back({g[0], g[1], g[2], g[3], g[4], static_cast<BondForm>(g[5])});
  }
  return all;
}

}  // namespace fiberchain::dem
