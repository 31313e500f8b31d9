#pragma once

#include "dem/math/near_one.hpp"

namespace fiberchain::dem {

/// A contact as share_of_kick() sees it.
template <class Real>
struct KickInContact {
  Real held;    ///< 1 where it was there the step before, else 0
  Real last;    ///< what share_of_kick() gave then
  Real since;   ///< overlap over that at the touch [m]
  Real left;    ///< overlap over that at the end [m]
  Real opened;  ///< the way in a step, positive as bodies part [m]
};

/// Part of a kick, which lasts from half a step before its moment to half a step after, in which a force is
/// there that comes with the touch and goes with the end of contact at once: 1/2 and the part of a step since
/// the touch, or until the end. Negative where the end was foreseen; where it did not come, because the
/// bodies were slowed down, the next kick makes up for it.
template <class Real>
Real share_of_kick(const KickInContact<Real>& c) {
  using std::max;
  const Real zero(0.0), one(1.0), half(0.5), tiny(1e-300);
  const auto held = c.held > half, ends = c.left < c.opened;
  // bodies that begin overlapped have not closed by their overlap
  const Real since = c.since / max(zero - c.opened, tiny);
  const Real begin = select(held, one, select(since < Real(1.000001), since + half, one));
  const Real end = select(ends, c.left / max(c.opened, tiny) + half, one);
  const Real owed = select(held, select(c.last < zero, one + c.last, zero), zero);
  const Real moved = select(c.opened > zero, one, select(c.opened < zero, one, zero));
  const Real share = begin + end - one + moved * owed;
  return select(ends, zero - share, share);
}

/// Its size.
template <class Real>
Real size_of_share(const Real& share) {
  using std::max;
  return max(share, Real(0.0) - share);
}

}  // namespace fiberchain::dem
