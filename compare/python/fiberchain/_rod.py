"""Rods in space: held and loaded in any way, their equilibria and paths of them."""

from dataclasses import dataclass, fields

import numpy

from . import _core
from ._scene_text import settings_of, text_of


class _Keys:
    """A mapping of a scene, whose keys are the fields."""

    def scene_keys(self):
        """The mapping in a scene: what is None is left out."""
        own = {one.name: getattr(self, one.name) for one in fields(self)}
        return {key: value for key, value in own.items() if value is not None}


@dataclass(frozen=True)
class Support(_Keys):
    """What holds a sphere: all of it, a clamp, where nothing else is said."""

    sphere: int | str  #: "first", "last" or a number from 0
    place: str | None = None  #: axes along which its place is held: "xyz", "yz", ..., "none"
    turn: str | None = None  #: axes about which its turns are held: "xyz" clamp, "xy" hinge about z, "none" ball
    axes: dict | None = None  #: the support's axes: the global ones turned, {"axis": (0, 0, 1), "angle": 0.3} [rad]
    move: tuple | None = None  #: its held place goes so far at load factor 1 [m]
    rotate: tuple | None = None  #: a clamp turns by this rotation vector at load factor 1 [rad]


@dataclass(frozen=True)
class Load(_Keys):
    """A force and a moment on one sphere."""

    sphere: int | str  #: "first", "last" or a number from 0
    force: tuple | None = None  #: [N]
    moment: tuple | None = None  #: [N m]
    reduced_force: tuple | None = None  #: F L^2/(E I) [1], adds to force
    reduced_moment: tuple | None = None  #: M L/(E I) [1], adds to moment
    direction: str | None = None  #: "dead" (fixed in space, the default), or "following" (turns with its sphere)
    steady: bool | None = None  #: acts in full, not times the load factor


@dataclass(frozen=True)
class LineLoad(_Keys):
    """A force per length of the rod."""

    spheres: str = "all"  #: "all", or "N..M"
    force: tuple | None = None  #: [N/m]
    reduced_force: tuple | None = None  #: w L^3/(E I) [1], adds to force
    direction: str | None = None  #: "dead" (the default) or "following"
    steady: bool | None = None  #: acts in full, not times the load factor


@dataclass(frozen=True)
class RodEquilibrium:
    """An equilibrium of a rod."""

    load_factor: float  #: [1]
    positions: numpy.ndarray  #: float64 (spheres, 3) [m]
    orientations: numpy.ndarray  #: float64 (spheres, 4): quaternions w, x, y, z from the global axes
    reactions: numpy.ndarray  #: float64 (supports, 6): force [N] and moment [N m] that each support puts on the rod
    probe_displacement: float  #: [m]
    elastic_energy: float  #: [J]
    work: float  #: of loads and moved supports since the path began [J]
    path_length: float  #: arc length of the path since it began [1]
    negative_eigenvalues: int  #: of the tangent
    stability: str  #: "stable", "neutral", "unstable"; "undecided" where the loads have no potential
    iterations: int  #: of Newton


@dataclass(frozen=True)
class SingularPoint:
    """Where a path turns or another one crosses."""

    kind: str  #: "limit point" or "bifurcation"
    after: int  #: number of the path's point before it
    crossing: int  #: change of negative eigenvalues over it
    mode: numpy.ndarray  #: float64 (spheres, 6): displacements [L] and rotations [rad] that it goes by, largest 1
    equilibrium: RodEquilibrium

    @property
    def load_factor(self):
        """[1]"""
        return self.equilibrium.load_factor


class RodPath:
    """Equilibria along a path: `path[n]` is one, `for point in path` all; or arrays over all of them."""

    def __init__(self, rod, found):
        self._rod = rod
        self._points = [RodEquilibrium(**point) for point in found["points"]]
        self._singular = [SingularPoint(one["kind"], one["after"], one["crossing"], one["mode"],
                                        RodEquilibrium(**one["equilibrium"])) for one in found["singular"]]
        self._forks = [one["core"] for one in found["singular"] if one["kind"] == "bifurcation"]

    def __len__(self):
        return len(self._points)

    def __getitem__(self, number):
        """A RodEquilibrium; negative numbers from the end."""
        return self._points[number]

    def __iter__(self):
        return iter(self._points)

    def __repr__(self):
        ends = ", ".join(f"{self._points[n].load_factor:.6g}" for n in (0, -1))
        return f"RodPath({len(self)} points, load factors {ends} at its ends, {len(self._singular)} singular points)"

    @property
    def singular(self):
        """Its limit points and bifurcations in order: a list of SingularPoint."""
        return list(self._singular)

    @property
    def bifurcations(self):
        """Those of `singular` where another path crosses."""
        return [one for one in self._singular if one.kind == "bifurcation"]

    @property
    def limit_points(self):
        """Those of `singular` where the load factor turns."""
        return [one for one in self._singular if one.kind == "limit point"]

    @property
    def load_factors(self):
        """float64 (points,) [1]."""
        return numpy.array([point.load_factor for point in self._points])

    @property
    def probe_displacements(self):
        """Of the probe along its direction, float64 (points,) [m]."""
        return numpy.array([point.probe_displacement for point in self._points])

    @property
    def positions(self):
        """float64 (points, spheres, 3) [m]."""
        return numpy.array([point.positions for point in self._points])

    @property
    def reactions(self):
        """Of the supports on the rod, float64 (points, supports, 6): forces [N], moments [N m]."""
        return numpy.array([point.reactions for point in self._points])

    @property
    def records(self):
        """A structured array, a record a point: every number and word of RodEquilibrium, by the same names."""
        names = [one.name for one in fields(RodEquilibrium)
                 if not isinstance(getattr(self._points[0], one.name), numpy.ndarray)]
        columns = [numpy.array([getattr(point, name) for point in self._points]) for name in names]
        rows = numpy.empty(len(self), dtype=[(name, column.dtype) for name, column in zip(names, columns)])
        for name, column in zip(names, columns):
            rows[name] = column
        return rows

    def branch(self, bifurcation=1, *, side="plus", amplitude=0.02):
        """From a bifurcation onto the path that crosses there, led by the arc length: a RodPath.

        bifurcation: its number along this path from 1. side: "plus", the way of its mode, or "minus".
        amplitude: largest of the mode's displacements / L and rotations [rad] at the first point.
        The first point is the bifurcation itself. Ends as this path was asked to.
        Raises ValueError for a bifurcation that is not there, RuntimeError where no branch is found.
        """
        if side not in ("plus", "minus"):
            raise ValueError(f"side = {side} is not allowed; allowed: plus, minus")
        if not 1 <= bifurcation <= len(self._forks):
            raise ValueError(f"bifurcation = {bifurcation}: the path has {len(self._forks)} bifurcations")
        sign = 1 if side == "plus" else -1
        return RodPath(self._rod, self._rod._branch(self._forks[bifurcation - 1], sign, amplitude))


class Rod(_core.Rod):
    """A fiber of any shape, held and loaded in any way. A value: it never changes.

    fiber: a Fiber; its bonds' length, number and stiffness are the rod's.
    supports: of Support (or mappings of a scene), together such that the rod cannot move as a whole.
    loads, line_loads: of Load and LineLoad. They go with the load factor, 1 in full.
    shape: the rod at rest, straight along x where left out: {"arc": "45 degree"}, {"corner": 60} (along y from that
    sphere on), {"points": [{"at": (0, 0, 0)}, ...]}, each with {"turn": {"axis": ..., "angle": ...}} beside.
    dimension: "planar" or "spatial". gravity: (3,) [m/s^2]: the rod's weight, in full from load factor 0 on.
    line_load_rule: "consistent" or "lumped". path: how it is followed, where trace() is not told else.

    Rod.of_scene() takes one from a file. Raises ValueError for what is not allowed, with the program's texts.
    """

    def __init__(self, fiber, supports, *, loads=(), line_loads=(), shape=None, dimension="planar", gravity=None,
                 line_load_rule=None, path=None):
        bond = {key: value for key, value in fiber._bond.items() if key == "model" and value is not None}
        lists = {"loads": list(loads) or None, "line_loads": list(line_loads) or None}
        scene = {"scene": "rod", "dimension": dimension, "fiber": fiber._keys, "bond": bond or None, "shape": shape,
                 "supports": list(supports), **lists, "line_load_rule": line_load_rule, "gravity": gravity,
                 "path": path}
        self._take(*text_of(scene, "rod"), [])

    def _take(self, text, name, settings):
        super().__init__(text, name, settings)
        self._text, self._name, self._settings = text, name, settings

    @classmethod
    def of_scene(cls, scene, *, settings=None, name=None):
        """The rod of a scene: a path, or a mapping with the keys of `scene: rod`.

        settings: {"fiber.aspect_ratio": 40, ...} in place of what it says. name: of a mapping.
        Raises ValueError for another kind of scene.
        """
        rod = cls.__new__(cls)
        rod._take(*text_of(scene, name), settings_of(settings))
        return rod

    def __repr__(self):
        return f"Rod({self._name!r}, bonds={self.bonds}, length={self.length!r})"

    def solve(self, factor=1.0):
        """The equilibrium at a load factor (not 0): a RodEquilibrium.

        By load steps as large as converge, by the arc length where none do: the first time that the factor is
        reached. Raises RuntimeError where it is not.
        """
        return RodEquilibrium(**self._solve(factor))

    def trace(self, **path):
        """The path of equilibria from load factor 0 on: a RodPath.

        path: keys of a scene's `path`, in place of the rod's own: control ("load", "displacement", "arc-length"),
        points, end_factor, end_displacement [m], probe={"sphere": "last", "direction": (0, 1, 0)}, most_points,
        largest_step, tolerance, singular_points.
        Raises RuntimeError where the path cannot be followed: the load factor cannot pass a limit point.
        """
        probe = path.pop("probe", None) or {}
        asked = {**{f"path.{key}": value for key, value in path.items() if value is not None},
                 **{f"path.probe.{key}": value for key, value in probe.items()}}
        rod = self if not asked else Rod.__new__(Rod)
        if asked:
            rod._take(self._text, self._name, self._settings + settings_of(asked))
        return RodPath(rod, rod._trace())
