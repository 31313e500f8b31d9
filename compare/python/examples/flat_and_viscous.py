"""A material's flat loss factor against viscous dashpots that meet it in the first mode: both let go."""

import numpy as np
from _figure import arguments, plt, save

import fiberchain as fc

options = arguments(__doc__)
periods = 8 if options.small else 30

fiber = fc.Fiber("2 mm", 12, youngs_modulus="2.6 MPa", poisson_ratio=0.3, density=1000)
first = fc.calibrate(fiber, loss_factor=0.02)["natural_frequency_hertz"]
flat = fc.damp_by_material(fiber, loss_factor=0.02, band=(first / 3, 300 * first))

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
for name, one in (("flat loss factor", flat.fiber), ("dashpots", flat.dashpots)):
    run = fc.release(one, 1.0, periods=periods)
    left.plot(run.time, 1e3 * run.y, label=name)
    print(f"{name}: xi_f = {run.table['fiber_damping_modes'][0]:.5f} by its first mode")
left.set_xlabel("time (s)"), left.set_ylabel("free end (mm)"), left.legend()
modes = flat.modes
right.semilogy(modes["mode"], modes["mode_damping"], "o-", label="flat loss factor")
right.semilogy(modes["mode"], modes["mode_damping_dashpots"], "s--", label="dashpots")
right.set_xticks(np.arange(1, len(modes["mode"]) + 1))
right.set_xlabel("bending mode"), right.set_ylabel("damping ratio"), right.legend()
save(figure, options, "flat-and-viscous")
