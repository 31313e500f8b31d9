"""Fibers, materials, calibration."""

from dataclasses import dataclass, field

from . import _core
from ._scene_text import text_of

_MEASURES = ("damping_ratio", "log_decrement", "quality_factor", "loss_factor")


class Fiber(_core.Fiber):
    """A straight fiber: bonds of length `diameter` (times `spacing`) join its spheres. A value: it never changes.

    Quantities are numbers in SI or texts with a unit.

    diameter: d = 2 R [m]; aspect_ratio: r_f = L/d; spacing: length of a bond over d [1].
    material: a name of `materials()`, or a path of a .yaml file, for the moduli and the density that are not given.
    youngs_modulus: E [Pa]; poisson_ratio or shear_modulus [Pa]; density [kg/m^3].
    bond_model: "paper" or "corrected"; bond_damping: xi_b (Eqs 7-10); rolling_friction: xi_r (Eq 21).
    mass: "spheres" (two thirds of the fiber, as the paper) or "cylinder" (the fiber's own).
    material_damping: "from-material", or a mapping of the scene's keys: Maxwell branches beside the springs.

    Raises ValueError for what is not allowed.
    """

    def __init__(self, diameter, aspect_ratio, *, material=None, youngs_modulus=None, poisson_ratio=None,
                 shear_modulus=None, transverse_modulus=None, density=None, mass=None, material_damping=None,
                 bond_model=None, bond_damping=None, rolling_friction=None, spacing=None):
        self._keys = {
            "diameter": diameter, "aspect_ratio": aspect_ratio, "material": material,
            "youngs_modulus": youngs_modulus, "poisson_ratio": poisson_ratio, "shear_modulus": shear_modulus,
            "transverse_modulus": transverse_modulus, "density": density, "mass": mass,
            "material_damping": material_damping, "spacing": spacing,
        }
        self._bond = {"model": bond_model, "damping": bond_damping, "rolling_friction": rolling_friction}
        scene = {"scene": "release", "fiber": self._keys, "bond": self._bond, "load": {"reduced": 1},
                 "periods": 1}
        super().__init__(text_of(scene, "fiber")[0])

    @classmethod
    def _of(cls, value, like, **changes):
        """A fiber of the engine, with the keys of another one and these changes of its bonds."""
        fiber = cls.__new__(cls)
        _core.Fiber.__init__(fiber, value)
        fiber._keys = dict(like._keys)
        fiber._bond = {**like._bond, **changes}
        return fiber

    def scene_keys(self, **more):
        """The mapping of this fiber in a scene of a packing, with more keys beside (`count=200`).

        Raises ValueError where a scene has no words for its dashpots.
        """
        if self.dashpots != "bond_damping":
            raise ValueError(f"scenes have no key for dashpots set by {self.dashpots}")
        return {**self._keys, "bond": self._bond, **more}

    def replace(self, **changes):
        """The same fiber with other arguments of its constructor."""
        names = {"bond_model": "model", "bond_damping": "damping", "rolling_friction": "rolling_friction"}
        before = {**self._keys, **{key: self._bond[name] for key, name in names.items()}}
        return Fiber(**{**before, **changes})

    def __repr__(self):
        return (f"Fiber(diameter={self.diameter!r}, aspect_ratio={self.aspect_ratio!r}, "
                f"youngs_modulus={self.youngs_modulus!r}, shear_modulus={self.shear_modulus!r}, "
                f"density={self.density!r}, bond_damping={self.bond_damping!r})")


@dataclass(frozen=True)
class Calibration:
    """What a calibration found: the fiber to use, and every number that the program's table has."""

    fiber: Fiber  #: with its dashpots set, or with the Maxwell branches of its material
    table: dict  #: one row: column name to array of length 1
    modes: dict = field(default_factory=dict)  #: of a material's own damping: a row a mode
    branches: dict = field(default_factory=dict)  #: likewise: a row a Maxwell branch
    dashpots: Fiber | None = None  #: likewise: dashpots alone that meet mode 1; None where there are none

    def __getitem__(self, column):
        """The value in a column of the table."""
        return self.table[column][0]


def calibrate(fiber, *, damping_ratio=None, log_decrement=None, quality_factor=None, loss_factor=None, amplitude=0.0,
              step_ratio=None, dashpots="bond_damping"):
    """The damping of the bonds that gives the fiber the damping asked for, exactly, in its first bending mode.

    One target: damping_ratio xi_f, log_decrement, quality_factor or loss_factor. amplitude: expected y/L of the
    free end, for what that does to xi_f. dashpots: "bond_damping", "retardation_time", "bending_only".
    Returns a Calibration. Raises ValueError for a target that cannot be reached.
    """
    targets = dict(zip(_MEASURES, (damping_ratio, log_decrement, quality_factor, loss_factor)))
    given = {name: value for name, value in targets.items() if value is not None}
    if len(given) != 1:
        raise ValueError(f"give exactly one of {', '.join(_MEASURES)}")
    if dashpots not in _core.Dashpots.__members__:
        raise ValueError(f"dashpots = {dashpots} is not allowed; allowed: {', '.join(_core.Dashpots.__members__)}")
    (name, value), = given.items()
    found = _core.calibrate(fiber, name.replace("_", " "), value, amplitude, step_ratio,
                            _core.Dashpots.__members__[dashpots])
    value = found["fiber"]
    return Calibration(Fiber._of(value, fiber, damping=value.bond_damping), found["table"])


def calibration_of(fiber, *, amplitude=0.0, step_ratio=None):
    """The reverse: what the fiber's own dashpots give. Raises ValueError without any, and where overdamped."""
    found = _core.calibration_of(fiber, amplitude, step_ratio)
    return Calibration(fiber, found["table"])


def damp_by_material(fiber, material=None, *, loss_factor=None, band=None):
    """A fiber damped by its material: by the data of `material`, or a loss factor that is flat over `band` [Hz].

    material: a name, left out: the one the fiber was made of. Returns a Calibration whose fiber has Maxwell
    branches, with `modes` (its damping of five bending modes, and dashpots' beside), `branches` and `dashpots`.
    """
    name = material or fiber._keys.get("material")
    found = _core.damp_by_material(fiber, name, loss_factor, band)
    damped = Fiber._of(found["fiber"], fiber)
    damping = {"from_material": True if name else None, "loss_factor": loss_factor, "band": found["band"]}
    damped._keys.update(material=name, material_damping=damping)
    only = found["dashpots"]
    dashpots = None if only is None else Fiber._of(only, fiber, damping=only.bond_damping)
    return Calibration(damped, found["table"], found["modes"], found["branches"], dashpots)


def materials():
    """The names of the materials that come with fiberchain."""
    return _core.material_names()


def material(name):
    """A material's data in SI: of each property a mapping with value, range, source and note, or None."""
    return _core.material(name)
