#include "dem/material/merge.hpp"

#include <algorithm>
#include <functional>

namespace fiberchain::dem {

PronySeries merge(const PronySeries& a, const PronySeries& b) {
  check(a);
  check(b);
  PronySeries all = a;
  all.insert(all.end(), b.begin(), b.end());
  std::erase_if(all, [](const MaxwellBranch& branch) { return branch.strength == 0; });
  std::ranges::stable_sort(all, std::greater{}, &MaxwellBranch::time);
  PronySeries merged;
  for (const MaxwellBranch& branch : all) {
    if (!merged.empty() && merged.back().time == branch.time) {
      merged.back().strength += branch.strength;
    } else {
      merged.push_back(branch);
    }
  }
  return merged;
}

PronySeries tidy(const PronySeries& series) { return merge(series, {}); }

}  // namespace fiberchain::dem
