"""What the tests of the module share."""

import os
import subprocess
import tempfile
import unittest

import fiberchain as fc

SOURCE = os.environ["FIBERCHAIN_SOURCE_DIR"]
PROGRAM = os.environ["FIBERCHAIN_PROGRAM"]

# Odd values: R, E and rho are not 1.
ODD = dict(diameter=1.66e-3, youngs_modulus=3.1e6, poisson_ratio=0.17, density=1130)


def odd_fiber(aspect_ratio=13, **more):
    return fc.Fiber(**{**ODD, "aspect_ratio": aspect_ratio, **more})


def packing_scene(count=12, duration="8 ms", **more):
    """Fibers that fall onto a floor between periodic sides, a plate above."""
    return {
        "scene": "packing",
        "fibers": [odd_fiber(7, bond_damping=0.4).scene_keys(count=count)],
        "filling": {"region": {"z": [0, "25 mm"]}, "velocity": [0, 0, -0.8], "seed": 3},
        "periodic": {"x": "14 mm", "y": "15 mm"},
        "walls": {"youngs_modulus": "5 MPa", "poisson_ratio": 0.3,
                  "planes": [{"point": [0, 0, 0], "normal": [0, 0, 1], "name": "floor"},
                             {"point": [0, 0, "25 mm"], "normal": [0, 0, -1], "name": "plate"}]},
        "gravity": [0, 0, -9.81],
        "contacts": {"restitution": 0.5, "friction": 0.3},
        "duration": duration,
        **more,
    }


def program(*arguments, **more):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, **more)


class InDirectory(unittest.TestCase):
    """In a directory of its own."""

    def setUp(self):
        self.before = os.getcwd()
        own = tempfile.TemporaryDirectory()
        self.addCleanup(own.cleanup)
        self.addCleanup(os.chdir, self.before)
        os.chdir(own.name)
