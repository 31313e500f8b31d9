"""Young's modulus and damping of a fiber from a noisy ring-down that the chain made."""

import numpy as np
from _figure import arguments, plt, save

import fiberchain as fc

options = arguments(__doc__)
truth = fc.Fiber("2 mm", 10, youngs_modulus="2.6 MPa", poisson_ratio=0.3, density=1000, bond_damping=1)
run = fc.release(truth, 0.02, periods=20 if options.small else 60,
                 time={"integrator": "leapfrog", "step_ratio": 0.05})
noise = 0.01 * np.abs(run.y).max() * np.random.default_rng(5).standard_normal(run.y.size)

known = truth.replace(youngs_modulus="1 MPa", bond_damping=0)  # what is sought is not read
found = fc.identify(run.time, run.y + noise, fiber=known, of="chain")
for name, true in (("youngs_modulus", 2.6e6), ("bond_damping", 1.0)):
    value, low, high = getattr(found, name)
    print(f"{name}: {value:.5g} in {low:.5g} to {high:.5g}; made with {true:g}")
print(f"loss factor {found.loss_factor.value:.4g}, {found.modes} modes, {found.doubts or 'no doubts'}")

figure, (above, below) = plt.subplots(2, 1, figsize=(7, 5), sharex=True)
above.plot(run.time, 1e3 * (run.y + noise), ".", ms=1, label="record")
above.plot(run.time, 1e3 * (run.y + noise - found.residuals), lw=0.8, label="fit")
above.set_ylabel("free end (mm)"), above.legend()
below.plot(run.time, 1e6 * found.residuals, ".", ms=1)
below.set_xlabel("time (s)"), below.set_ylabel("left (µm)")
save(figure, options, "invert-ring-down")
