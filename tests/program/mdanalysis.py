"""Opens NAME.h5md of a run by MDAnalysis's ordinary reader and holds it against NAME.h5's own numbers (h5py).
Exit status 77 with the reason where one of both is not installed."""

import sys
import warnings

warnings.simplefilter("ignore")
try:
    import h5py
    import MDAnalysis
    import numpy as np
except ImportError as error:
    print(f"skipped: {error} (Debian packages python3-mdanalysis, python3-h5py)")
    sys.exit(77)

path = sys.argv[1]
with h5py.File(path + ".h5") as file:
    fibers = file["particles/fibers"]
    position, velocity, ids = (fibers[name]["value"][:] for name in ("position", "velocity", "id"))
    time, step = fibers["position/time"][:], fibers["position/step"][:]
    edges, angles = fibers["box/edges/value"][:], file["observables/bending_angle/value"][:]
    bonds = file["connectivity/bonds"].shape[0]
    units = {name: file[name].attrs["unit"] for name in ("particles/fibers/position/time",
             "particles/fibers/velocity/value", "particles/fibers/box/edges/value", "observables/bond_force/value")}

universe = MDAnalysis.Universe.empty(position.shape[1], trajectory=True)
universe.load_new(path + ".h5md", convert_units=False)
assert type(universe.trajectory).__name__ == "H5MDReader", universe.trajectory
assert list(units.values()) == ["s", "m s-1", "m", "N"], units
assert universe.atoms.n_atoms == position.shape[1], universe.atoms.n_atoms
assert universe.trajectory.n_frames == len(time) > 2, universe.trajectory.n_frames
absent = 0
for n, frame in enumerate(universe.trajectory):
    assert frame.time == time[n] and frame.data["step"] == step[n]
    there = ids[n] >= 0
    absent += np.count_nonzero(~there)
    assert np.isnan(frame.positions[~there]).all() and np.isnan(frame.velocities[~there]).all()
    np.testing.assert_allclose(frame.positions[there], position[n][there], rtol=1e-6)
    np.testing.assert_array_equal(frame.velocities[there], velocity[n][there])
    np.testing.assert_allclose(frame.dimensions, [*np.diag(edges[n]), 90, 90, 90], rtol=1e-6)
    np.testing.assert_array_equal(frame.data["bending_angle"], angles[n])
    assert frame.data["bond_force"].shape == (bonds, 3) and np.isfinite(frame.data["contacts"])
assert absent > 0, "no sphere comes later"
last = universe.trajectory[-1]
assert np.ptp(last.positions[ids[-1] >= 0], axis=0).max() < 1, "meters"
print(f"MDAnalysis {MDAnalysis.__version__}: {universe.trajectory.n_frames} frames of {universe.atoms.n_atoms} spheres")
