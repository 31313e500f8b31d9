"""Fig 4 of the paper: the free end's departure from the Elastica, and what it consists of."""

import numpy as np
from _figure import arguments, plt, save

import fiberchain as fc

options = arguments(__doc__)
loads = np.geomspace(0.05, 6, 6 if options.small else 30)
ratios = [6, 10] if options.small else [6, 8, 10, 20]

rows = fc.records(fc.static_table(aspect_ratios=ratios, loads=loads))
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
for ratio in ratios:
    own = rows[rows["aspect_ratio"] == ratio]
    left.semilogx(own["load"], 100 * own["departure_y"], label=f"$r_f$ = {ratio}")
own = rows[rows["aspect_ratio"] == 10]
parts = [f"{part}_y" for part in ("shear", "stretch", "discretization")]
for part in parts:
    right.semilogx(own["load"], 100 * own[part], "--", label=part[:-2])
right.semilogx(own["load"], 100 * own["departure_y"], "k", label="departure")
for axes in (left, right):
    axes.set_xlabel("$PL^2/(EI)$"), axes.set_ylabel("departure of y (%)"), axes.legend()
print(f"r_f = 10: {100 * own['departure_y'][0]:.4f} % at a small load; the sum of its parts is off by "
      f"{max(abs(sum(own[part] for part in parts) - own['departure_y'])):.1e}")
save(figure, options, "fig4-budget")
