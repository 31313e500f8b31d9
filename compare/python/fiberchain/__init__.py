"""Flexible fibers as chains of spheres: what the program `fiberchain` does, in Python.

Quantities are SI numbers, or texts with a unit ("2 mm", "2.6 MPa") where they go into a fiber or a scene.
Errors have the program's texts: ValueError for what is not allowed, OSError for files, RuntimeError for what
does not converge, diverges or finds no room. Long calls let other threads run and stop on Ctrl-C.
"""

from ._core import Frame, commit, version as __version__
from ._fiber import Calibration, Fiber, calibrate, calibration_of, damp_by_material, material, materials
from ._identify import Estimate, Identification, identify, read_record
from ._packing import Packing, Wall
from ._rod import LineLoad, Load, Rod, RodEquilibrium, RodPath, SingularPoint, Support
from ._scenes import cantilever, flow, read_table, records, release, run, static_table
from ._trajectory import Trajectory

__all__ = [
    "Calibration", "Estimate", "Fiber", "Frame", "Identification", "LineLoad", "Load", "Packing", "Rod",
    "RodEquilibrium", "RodPath", "SingularPoint", "Support", "Trajectory", "Wall",
    "calibrate", "calibration_of", "cantilever", "commit", "damp_by_material", "flow", "identify", "material",
    "materials", "read_record", "read_table", "records", "release", "run", "static_table",
]
