#pragma once

#include "dem/chain/chain.hpp"
#include "dem/model/loads.hpp"

namespace fiberchain::compare {

struct RootSearchTip {
  dem::Vec<double, 2> tip;  ///< over L
  double error;             ///< distance of the answers from two starts, over L
};

/// Free end of a cantilevered chain by GSL's scaled hybrid method with differences in place of a Jacobian, on
/// the forces of the bond law alone: shares with dem::solve_equilibrium the law, and neither its tangent nor
/// its iteration. Started from the Elastica at `load` = P L^2/(E I) and from the one at nine tenths of it.
/// Throws reference::NoConvergence.
RootSearchTip equilibrium_by_root_search(const dem::Chain<2>& chain, const dem::Boundary<2>& boundary,
                                         double load);

}  // namespace fiberchain::compare
