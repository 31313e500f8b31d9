#pragma once

#include "dem/bond/laws/breakable.hpp"

namespace fiberchain::dem {

inline constexpr BondForm breakable_form{101};
template <>
struct BondLawOf<breakable_form> {
  using type = Breakable<IncrementalBond>;
};

}  // namespace fiberchain::dem
