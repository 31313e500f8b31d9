"""How high a bed stands by friction, with the spread of seeds."""

import numpy as np
from _figure import arguments, plt, save

import fiberchain as fc

options = arguments(__doc__)
frictions = [0.0, 0.5] if options.small else [0.0, 0.1, 0.2, 0.4, 0.6]
seeds = range(1, 3) if options.small else range(1, 6)
fiber = fc.Fiber("2 mm", 8, youngs_modulus="2.6 MPa", poisson_ratio=0.3, density=1000, bond_damping=1)
scene = {
    "scene": "packing",
    "fibers": [fiber.scene_keys(count=20 if options.small else 60)],
    "filling": {"region": {"z": ["2 mm", "50 mm"]}, "velocity": [0, 0, -0.5]},
    "walls": {"youngs_modulus": "2.6 MPa", "box": {"x": "20 mm", "y": "20 mm", "lid": "open"}},
    "gravity": [0, 0, -9.81],
    "contacts": {"restitution": 0.4, "friction": 0.3},
    "duration": "40 ms" if options.small else "200 ms",
}
heights = np.empty((len(frictions), len(seeds)))
for i, friction in enumerate(frictions):
    for j, seed in enumerate(seeds):
        packing = fc.Packing(scene, settings={"contacts.friction": friction, "filling.seed": seed})
        packing.run()
        heights[i, j] = packing.observables()["height"]
    print(f"friction {friction}: height {1e3 * heights[i].mean():.2f} +- {1e3 * heights[i].std(ddof=1):.2f} mm")
figure, axes = plt.subplots(figsize=(5, 3.6))
axes.errorbar(frictions, 1e3 * heights.mean(axis=1), 1e3 * heights.std(axis=1, ddof=1), fmt="o-", capsize=3)
axes.plot(frictions, 1e3 * heights, ".", color="gray")
axes.set_xlabel("friction"), axes.set_ylabel("height of 95 % of the spheres (mm)")
save(figure, options, "sweep-with-seeds")
