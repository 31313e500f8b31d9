"""A column that buckles, the two branches it may take, and a fiber that snaps through: rods along their equilibria."""

from _figure import arguments, plt, save

import fiberchain as fc

options = arguments(__doc__)
bonds = 24 if options.small else 80
fiber = fc.Fiber("0.2 mm", bonds, material="music-wire", bond_model="corrected")

figure, (left, middle, right) = plt.subplots(1, 3, figsize=(12, 3.6))
ends = [fc.Support("first", turn="xy"), fc.Support("last", place="yz", turn="xy")]
column = fc.Rod(fiber, ends, loads=[fc.Load("last", reduced_force=(-15, 0, 0))])
straight = column.trace(control="load", points=10, probe={"sphere": bonds // 2, "direction": (0, 1, 0)})
critical = straight.bifurcations[0]
print(f"buckles at {15 * critical.load_factor:.4f} EI/L^2; Euler: 9.8696")
for side in ("plus", "minus"):
    branch = straight.branch(side=side)
    left.plot(branch.probe_displacements / column.length, 15 * branch.load_factors, label=f"branch, {side}")
    middle.plot(*(1e3 * branch.positions[-1, :, :2]).T)
left.plot(straight.probe_displacements / column.length, 15 * straight.load_factors, "k:", label="straight")

arc = {"arc": -1.6, "turn": {"axis": (0, 0, 1), "angle": 0.8}}
arch = fc.Rod(fiber, [fc.Support(end, turn="xy") for end in ("first", "last")], shape=arc,
              loads=[fc.Load(bonds // 2, reduced_force=(0, -60, 0))])
path = arch.trace(control="arc-length", points=30, end_displacement=0.4 * arch.length, largest_step=0.1,
                  probe={"sphere": bonds // 2, "direction": (0, -1, 0)})
right.plot(path.probe_displacements / arch.length, 60 * path.load_factors)
for point in path.limit_points:
    right.plot(point.equilibrium.probe_displacement / arch.length, 60 * point.load_factor, "o")
left.set_xlabel("displacement of the middle / L"), left.set_ylabel("$FL^2/(EI)$"), left.legend()
middle.set_xlabel("x (mm)"), middle.set_ylabel("y (mm)"), middle.set_aspect("equal")
middle.set_title("under 15 EI/L²")
right.set_xlabel("drop of the arch's top / L"), right.set_ylabel("$FL^2/(EI)$")
save(figure, options, "column")
