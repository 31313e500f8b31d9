"""A plate comes down on a loose bed and then holds its force: five lines of control between the steps."""

import numpy as np
from _figure import arguments, plt, save

import fiberchain as fc

options = arguments(__doc__)
wanted, top = 0.5, 20e-3  # [N], [m]
fiber = fc.Fiber("1 mm", 10, youngs_modulus="10 MPa", poisson_ratio=0.3, density=1000, bond_damping=0.3)
packing = fc.Packing({
    "scene": "packing",
    "fibers": [fiber.scene_keys(count=60 if options.small else 90)],
    "filling": {"region": {"z": [0, top]}, "seed": 1},
    "periodic": {"x": "14 mm", "y": "14 mm"},
    "walls": {"youngs_modulus": "10 MPa",
              "planes": [{"point": [0, 0, 0], "normal": [0, 0, 1], "name": "floor"},
                         {"point": [0, 0, top], "normal": [0, 0, -1], "name": "plate"}]},
    "contacts": {"restitution": 0.3, "friction": 0.3},
    "duration": 0.1,
})
plate, history = packing.walls["plate"], []
for _ in range(6000 if options.small else 12000):
    packing.step(10)
    force = plate.force[2]
    plate.velocity = (0, 0, np.clip(0.5 * (force - wanted), -0.8, 0.3))  # [m/s]: 0.5 for each N
    history.append((packing.time, force, plate.place[2]))

time, force, height = np.array(history).T
last = force[-len(force) // 5:]
print(f"plate at {1e3 * height[-1]:.2f} mm holds {last.mean():.4f} N, wanted {wanted} N")
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
left.plot(1e3 * time, force, lw=0.6), left.axhline(wanted, color="gray")
left.set_xlabel("time (ms)"), left.set_ylabel("force on the plate (N)")
right.plot(1e3 * time, 1e3 * height)
right.set_xlabel("time (ms)"), right.set_ylabel("height of the plate (mm)")
save(figure, options, "plate-force")
