"""Scenes run as the program runs them; tables."""

import os
from types import SimpleNamespace

import numpy

from . import _core
from ._scene_text import settings_of, text_of


def run(scene, *, settings=None, directory=".", threads=1, earlier="refuse", name=None, fiber=None):
    """Runs a scene as `fiberchain run` does, with the same results to the bit.

    scene: a path, or a mapping with the keys of a scene. settings: {"contacts.friction": 0.4, ...} in place of
    what it says. name: of a mapping; files that it names are beside that, a packing's own files are called so.
    A packing writes its files into `directory` as it goes; earlier: "refuse", "resume" or "replace" a run that is
    there. Ctrl-C stops it at a checkpoint.
    fiber: takes the place of the scene's one fiber.

    Returns a namespace with `kind`, `table` (columns by name: arrays of length 1) and
      cantilever: positions (spheres, 3) [m], angles [rad], residual, stability, shape (a table);
      release: time [s], y, z (samples,) [m], energy [J], period [s], time_step [s], history (a table), failure;
      rod: positions (spheres, 3) [m] at the end of the path or its branch, path and shapes (tables);
      flow: history (a table), shapes (moments, spheres, 3) [m], shape_times [s], failure;
      packing: directory, name, messages, failure.
    """
    text, own = text_of(scene, name)
    return SimpleNamespace(**_core.run(text, own, settings_of(settings), fiber, os.fspath(directory), threads,
                                       earlier))


def _of_fiber(fiber, kind, keys):
    scene = {"scene": kind, "fiber": fiber._keys, **keys}
    bond = {key: value for key, value in fiber._bond.items() if value is not None}
    if kind != "release":
        bond.pop("rolling_friction", None)
    scene["bond"] = {**bond, **(keys.get("bond") or {})} or None
    return run(scene, name=kind, fiber=fiber)


def cantilever(fiber, load, *, direction=None, **keys):
    """The fiber clamped at one end under a dead load P at the other, at rest.

    load: P L^2/(E I). direction: of the load, (0, 1, 0); the fiber lies along x. keys: further ones of
    `scene: cantilever`: dimension="spatial", gravity=(0, 0, -9.81), method="march", bond={"form": "total"}, ...
    Returns a namespace as run(): positions (spheres, 3) [m]: x along the straight fiber, y along the load's part
    across it, z across both.
    Raises RuntimeError where the iteration does not converge or the equilibrium is unstable.
    """
    return _of_fiber(fiber, "cantilever", {"load": {"reduced": load, "direction": direction}, **keys})


def release(fiber, load, *, direction=None, periods=10, **keys):
    """The cantilever held under its load, then let go, for so many periods of its first mode.

    keys: further ones of `scene: release`: time={"integrator": "implicit"}, dimension="spatial", ...
    Returns a namespace as run(): time [s], y, z of the free end (samples,) [m], energy [J], table, failure.
    """
    return _of_fiber(fiber, "release", {"load": {"reduced": load, "direction": direction}, "periods": periods,
                                        **keys})


def flow(fiber, fluid, *, strain, start=None, **keys):
    """A free fiber in a creeping flow.

    fluid: the keys of a scene's fluid: {"viscosity": "50 Pa s", "flow": "shear", "rate": 1}. strain: length of the
    run, time times rate. start: {"direction": (0, 1, 0), "bend": 0.01, ...}. keys: further ones of `scene: flow`:
    samples, shapes, motion, dimension.
    Returns a namespace as run(): history (a table), shapes (moments, spheres, 3) [m], shape_times [s].
    """
    return _of_fiber(fiber, "flow", {"fluid": fluid, "strain": strain,
                                     "start": start or {"direction": (0, 1, 0)}, **keys})


def static_table(*, aspect_ratios, loads, poisson_ratios=(0.3,), bond_models=("paper",), jobs=1):
    """The chain's free end against the Elastica's, and what the departure consists of (Figs 3 and 4).

    Every combination is a row. Columns as `fiberchain columns` explains them: departure_y, budget_shear, ...
    """
    return _core.static_table(list(aspect_ratios), [float(load) for load in loads],
                              [float(nu) for nu in poisson_ratios], list(bond_models), jobs)


def read_table(path):
    """A CSV file of the program: columns by name, float64 (NaN where missing), int64 or str."""
    if not os.path.exists(path):
        raise FileNotFoundError(f"{os.fspath(path)}: there is no such file")
    return _core.read_table(os.fspath(path))


def records(table):
    """A table as one structured array: a record a row."""
    arrays = [numpy.asarray(column) for column in table.values()]
    rows = numpy.empty(len(arrays[0]) if arrays else 0,
                       dtype=[(name, array.dtype) for name, array in zip(table, arrays)])
    for name, array in zip(table, arrays):
        rows[name] = array
    return rows
