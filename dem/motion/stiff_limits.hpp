#pragma once

#include "dem/model/fiber.hpp"
#include "dem/motion/implicit_bond.hpp"

// What limits the step of a leapfrog whose springs are solved for within it (implicit_kick.hpp). The unloaded
// straight chain at rest knows no limit. dem/README.md derives both.
namespace fiberchain::dem {

/// Largest tension of the bonds [N] that a step of `dt` [s] bears: the straight chain drawn by it is stable,
/// M + dt^2 (beta K_0 - (K + G)/4) positive definite, G its geometric stiffness, which stays explicit. Free
/// ends bear half of what an endless chain does, as a beam on an elastic bed (Hetenyi 1946). Compression has
/// no such limit. At most what draws a bond to twice its length. Throws InvalidInput as check() does.
double largest_tension(const Fiber& fiber, double dt, double beta = stiff_beta,
                       Clamps clamps = {false, false});

/// The largest step [s] that bears a tension [N]; infinite without tension.
double step_for_tension(const Fiber& fiber, double tension, double beta = stiff_beta,
                        Clamps clamps = {false, false});

/// Turn of a bond in a step [rad] up to which chains that spin or swing freely stay stable, and that steps
/// are chosen for: spheres go along straight lines, which stretches a bond by beta phi^2 as long as it turns.
inline constexpr double safe_turn = 0.05;

/// Turn of a bond in a step [rad] beyond which a run is stopped: chains that turn as fast grow without bound
/// within some periods (measured from 0.06 on for chains that spin freely, 0.3 for those let go suddenly).
inline constexpr double largest_turn = 0.2;

/// Period of the first bending of a free straight fiber, 2 pi (L/4.730)^2 sqrt(m / (K_bend l^2)) by the Euler
/// beam [s]. Throws InvalidInput as check() does.
double free_bending_period(const Fiber& fiber);

/// Part of a period of bending that a step takes at most where the motion of bending is wanted: a damping
/// ratio off by 0.2 %, a frequency by 0.12 %.
inline constexpr double followed_period_part = 1.0 / 60;

}  // namespace fiberchain::dem
