"""Spruce in bending: what its loss factor is to a chain, and what dashpots alone make of it."""

from _figure import arguments, plt, save

import fiberchain as fc

options = arguments(__doc__)
ratios = (8, 16) if options.small else (8, 12, 16, 24, 32, 48, 64)

stick = fc.Fiber("5 mm", 32, material="spruce", mass="cylinder")
damped = fc.damp_by_material(stick, band=(10, 10e3))
print(f"E = {damped['relaxed_modulus'] / 1e9:.3f} GPa relaxed, {damped.fiber.branch_count} Maxwell branches a bond")
print(f"dashpots alone: xi_b = {damped.dashpots.bond_damping:.4g}")

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
modes = damped.modes
left.loglog(modes["mode_frequency"], modes["mode_damping"], "o-", label="Maxwell branches")
left.loglog(modes["mode_frequency"], modes["mode_damping_dashpots"], "s--", label="dashpots alone")
left.axhline(0.5 * fc.material("spruce")["loss_factor"]["value"], color="gray", lw=0.8, label="half the loss factor")
left.set_xlabel("frequency of the mode (Hz)"), left.set_ylabel("damping ratio"), left.legend()

settings = [fc.calibrate(stick.replace(aspect_ratio=r), loss_factor=0.008).fiber.bond_damping for r in ratios]
right.loglog(ratios, settings, "o-")
right.set_xlabel("aspect ratio"), right.set_ylabel("ξ_b for a loss factor of 0.008")
save(figure, options, "calibrate-wood")
