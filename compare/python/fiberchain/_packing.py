"""Packings step by step."""

from . import _core
from ._scene_text import settings_of, text_of


class Wall:
    """A wall of a packing. Forces are means over the last step(), by fibers on the wall."""

    def __init__(self, packing, number):
        self._packing = packing
        self._number = number

    def _now(self, key):
        return self._packing._core.wall(self._number)[key]

    @property
    def name(self):
        """As the scene calls it; "" if it does not."""
        return self._now("name")

    @property
    def shape(self):
        """"plane", "cylinder", ..."""
        return self._now("shape")

    @property
    def force(self):
        """(x, y, z) [N]: mean over the last step(n); before any, of this moment."""
        return self._now("force")

    @property
    def moment(self):
        """(x, y, z) [N m] about `place`, likewise."""
        return self._now("moment")

    @property
    def force_peak(self):
        """Size of the largest force in any step of these [N]."""
        return self._now("force_peak")

    @property
    def work(self):
        """Done on fibers since the start [J]."""
        return self._now("work")

    @property
    def active(self):
        """Whether it is there now."""
        return self._now("active")

    @property
    def velocity(self):
        """(x, y, z) [m/s]: its constant velocity, beside turning, oscillation and drive. To be set: from now on."""
        return self._now("velocity")

    @velocity.setter
    def velocity(self, value):
        self._packing._core.set_wall_velocity(self._number, [float(v) for v in value])

    @property
    def place(self):
        """(x, y, z) [m]: the point of its shape, or where it turns. To be set: at once.

        Raises ValueError where the center of a sphere would be behind it.
        """
        return self._now("place")

    @place.setter
    def place(self, value):
        before = self.place
        self._packing._core.shift_wall(self._number, [float(v) - b for v, b in zip(value, before)])

    def __repr__(self):
        return f"<wall {self._number} {self.name!r}: {self.shape} at {self.place}>"


class Walls:
    """The walls of a packing, by number or by name."""

    def __init__(self, packing):
        self._all = [Wall(packing, number) for number in range(packing._core.wall_count)]

    def __len__(self):
        return len(self._all)

    def __iter__(self):
        return iter(self._all)

    def __getitem__(self, which):
        if not isinstance(which, str):
            return self._all[which]
        for wall in self._all:
            if wall.name == which:
                return wall
        names = ", ".join(repr(wall.name) for wall in self._all if wall.name) or "none has a name"
        raise KeyError(f"no wall is called {which!r}: {names}")


class Packing:
    """Many fibers that meet each other and walls, marched a piece at a time: the program's steps, to the bit.

    scene: a path, or a mapping with the keys of `scene: packing`. settings: in place of what it says.
    threads: results do not depend on them. Nothing is written; `duration` only says `total_steps`.
    Raises ValueError for a scene that is not allowed, RuntimeError where fibers find no room.
    """

    def __init__(self, scene, *, settings=None, threads=1, name=None):
        text, own = text_of(scene, name)
        self._core = _core.Packing(text, own, settings_of(settings), threads)
        self._frame = None
        self._walls = Walls(self)

    def step(self, steps=1, *, keep_forces=False):
        """So many steps. Forces on walls are means over them from now on.

        keep_forces: `contacts` have the forces of the last step to round-off, not to first order in the step.
        Raises RuntimeError where the run blows up; KeyboardInterrupt stops it between two steps, and it can go on.
        """
        self._frame = None
        self._core.march(steps, keep_forces)

    def run(self):
        """The steps that are left of the scene's duration."""
        self.step(max(0, self.total_steps - self.steps))

    @property
    def time(self):
        """[s]"""
        return self._core.time

    @property
    def steps(self):
        """Done."""
        return self._core.steps

    @property
    def total_steps(self):
        """Of the scene's duration."""
        return self._core.total_steps

    @property
    def time_step(self):
        """[s]"""
        return self._core.time_step

    @property
    def step_set_by(self):
        """What set the time step: "bonds", "contacts", "restitution", ..."""
        return self._core.step_set_by

    @property
    def messages(self):
        """What the program would have said while the fibers went in."""
        return self._core.messages

    def __len__(self):
        """Number of spheres that are there."""
        return self._core.spheres

    @property
    def gravity(self):
        """(x, y, z) [m/s^2]. To be set: from now on."""
        return self._core.gravity

    @gravity.setter
    def gravity(self, value):
        self._core.gravity = [float(v) for v in value]

    @property
    def walls(self):
        """By number, or by the name that the scene gives: `packing.walls["plate"].force`."""
        return self._walls

    @property
    def positions(self):
        """float64 (spheres, 3) [m], by the numbers of the spheres: fiber after fiber. An array of its own."""
        return self._core.positions

    def frame(self):
        """Everything at this moment, contacts included, as a Frame."""
        if self._frame is None:
            self._frame = self._core.frame(True)
        return self._frame

    @property
    def velocities(self):
        """float64 (spheres, 3) [m/s], of this moment."""
        return self.frame().velocities

    @property
    def radii(self):
        """float64 (spheres,) [m]."""
        return self.frame().radii

    @property
    def fibers(self):
        """int32 (spheres,): the number of each sphere's fiber."""
        return self.frame().fibers

    @property
    def bonds(self):
        """Records (bonds,): first (sphere), force on it [N], bending_angle [rad]."""
        return self.frame().bonds

    @property
    def contacts(self):
        """Records (contacts,): first, second, kind, point [m], normal, force on the first [N]. See Frame."""
        return self.frame().contacts

    def observables(self):
        """A line of the program's log: step, simulated_time [s], contacts, height [m], bending_mean [rad], overlaps, energies [J]."""
        return self._core.measure()

    def structure(self):
        """Contacts of a sphere and a fiber, order of the bonds' directions, as a mapping."""
        return self._core.structure()
