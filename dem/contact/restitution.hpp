#pragma once

namespace fiberchain::dem {

/// Coefficient of restitution of a Hertz contact, its dashpot c = 2 zeta sqrt(5/4 m* k sqrt(delta)), that
/// ends when its force has fallen to zero (contacts do not pull). With y = 4/5 delta^(5/4) and time counted
/// by delta^(1/4) the motion is that of a linear oscillator of damping ratio zeta (Antypov & Elliott, EPL 94
/// (2011) 50004), whose force ends at w t = 2 acos(zeta): e = exp(-2 zeta acos(zeta) / sqrt(1 - zeta^2)).
/// Throws InvalidInput unless zeta >= 0.
double restitution_of(double damping_ratio);

/// The damping ratio zeta that gives a coefficient of restitution. The common -ln e / sqrt(pi^2 + ln^2 e) is
/// for a contact that pulls until its overlap is gone; it turns 0.4 into 0.47 here. Throws InvalidInput
/// unless 0 < e <= 1.
double damping_ratio_for(double restitution);

}  // namespace fiberchain::dem
