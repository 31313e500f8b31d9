"""Scenes of one fiber against the program, bit by bit; errors with its texts; tables."""

import json
import os
import unittest

import numpy as np
from common import SOURCE, InDirectory, odd_fiber, program

import fiberchain as fc

CANTILEVER = os.path.join(SOURCE, "data", "scenes", "cantilever-spatial.yaml")
RELEASE = os.path.join(SOURCE, "data", "scenes", "release.yaml")
# of one machine and moment
OF_THE_MOMENT = {"run_time"}


class AgainstTheProgram(InDirectory):
    def check_same(self, path, run, table, mine):
        self.assertEqual(program("run", path, "--out", "out", "--no-figures").returncode, 0)
        name = os.path.basename(path)[:-len(".yaml")]
        own = fc.read_table(f"out/{name}{table}.csv")
        self.assertEqual(list(own), list(mine))
        for column, values in own.items():
            if column not in OF_THE_MOMENT:
                np.testing.assert_array_equal(values, mine[column], err_msg=column)

    def test_a_cantilever(self):
        run = fc.run(CANTILEVER)
        self.check_same(CANTILEVER, run, "", run.table)
        self.check_same(CANTILEVER, run, "-shape", run.shape)

    def test_a_release(self):
        run = fc.run(RELEASE, settings={"periods": 2})
        self.assertEqual(program("run", RELEASE, "--set", "periods=2", "--out", "out", "--no-figures").returncode, 0)
        own = fc.read_table("out/release-history.csv")
        np.testing.assert_array_equal(own["tip_y"], run.history["tip_y"])
        np.testing.assert_array_equal(own["energy"], run.history["energy"])

    def test_a_flow(self):
        scene = {"scene": "flow", "fiber": odd_fiber(7), "fluid": {"viscosity": 3, "flow": "shear", "rate": 0.7},
                 "start": {"direction": [-1, 0.3, 0]}, "strain": 2, "samples": 8, "shapes": 4}
        # the mapping of a fiber in a packing has its bonds inside: here they stand beside
        scene["fiber"] = odd_fiber(7)._keys
        run = fc.run(scene, name="f.yaml")
        with open("f.yaml", "w") as file:
            json.dump({**scene, "fiber": {k: v for k, v in scene["fiber"].items() if v is not None}}, file)
        self.check_same("f.yaml", run, "-history", run.history)
        self.assertEqual(run.shapes.shape, (5, 8, 3))


class FromPython(unittest.TestCase):
    def test_a_cantilever_under_a_small_load_drops_as_small_deflection_has_it(self):
        fiber = odd_fiber(13)
        load = 1e-3
        rest = fc.cantilever(fiber, load)
        self.assertEqual(rest.positions.shape, (14, 3))
        # y = load L/3 (Eq 12), the chain's own error 3E/(16G) - 1/4 over r_f^2
        error = (3 * fiber.youngs_modulus / (16 * fiber.shear_modulus) - 0.25) / 13**2
        expected = load / 3 * fiber.length * (1 + error)
        self.assertAlmostEqual(rest.positions[-1, 1] / expected, 1, delta=1e-6)
        self.assertEqual(rest.stability, "stable")

    def test_marching_and_solving_agree(self):
        fiber = odd_fiber(5)
        solved, marched = fc.cantilever(fiber, 2.0), fc.cantilever(fiber, 2.0, method="march")
        np.testing.assert_allclose(marched.positions, solved.positions, rtol=0, atol=1e-9 * fiber.length)

    def test_a_release_swings_with_the_frequency_of_its_calibration(self):
        fiber = odd_fiber(9, bond_damping=0.7)
        run = fc.release(fiber, 0.01, periods=12)
        known = fc.calibration_of(fiber)
        damped = known["natural_frequency"] * np.sqrt(1 - known["fiber_damping_modes"]**2)
        self.assertAlmostEqual(2 * np.pi / run.period / damped, 1, delta=1e-9)
        self.assertAlmostEqual(run.table["frequency"][0] / damped, 1, delta=2e-3)
        self.assertEqual(run.y.shape, run.time.shape)

    def test_the_static_study_has_the_known_error_at_small_loads(self):
        rows = fc.records(fc.static_table(aspect_ratios=[10, 6], loads=[1e-3], bond_models=["paper"]))
        self.assertEqual(rows.dtype.names[0], "aspect_ratio")
        for ratio, percent in ((10, 0.2375), (6, 0.6597)):
            own, = rows[rows["aspect_ratio"] == ratio]
            self.assertAlmostEqual(100 * own["departure_y"], percent, delta=2e-4)

    def test_the_end_is_a_quantity_with_a_unit_or_a_number(self):
        one = fc.Fiber("2 mm", 10, youngs_modulus="2.6 MPa", poisson_ratio=0.3, density="1 g/cm^3")
        other = fc.Fiber(2e-3, 10, youngs_modulus=2.6e6, poisson_ratio=0.3, density=1000)
        self.assertAlmostEqual(one.bending_stiffness / other.bending_stiffness, 1, delta=1e-14)
        self.assertAlmostEqual(one.mass / (11 * 4 / 3 * np.pi * 1e-9 * 1000), 1, delta=1e-12)


class Errors(InDirectory):
    def test_what_is_not_allowed_is_a_value_error_with_the_program_s_text(self):
        with open("odd.yaml", "w") as file:
            file.write("scene: cantilever\nlaod: 1\n")
        said = program("run", "odd.yaml")
        self.assertEqual(said.returncode, 2)
        with self.assertRaises(ValueError) as caught:
            fc.run("odd.yaml")
        self.assertIn(str(caught.exception), said.stderr)
        self.assertIn("odd.yaml:2", str(caught.exception))
        with self.assertRaisesRegex(ValueError, "aspect_ratio"):
            odd_fiber(0)
        with self.assertRaisesRegex(ValueError, "poisson_ratio"):
            odd_fiber(5, poisson_ratio=0.7)
        with self.assertRaisesRegex(ValueError, "xi_f"):
            fc.calibrate(odd_fiber(5), damping_ratio=1.5)

    def test_files_are_os_errors(self):
        with self.assertRaises(FileNotFoundError):
            fc.run("none.yaml")
        with self.assertRaises(OSError):
            fc.Trajectory("none.h5")
        with self.assertRaises(FileNotFoundError):
            fc.read_table("none.csv")

    def test_what_does_not_come_to_an_end_is_a_runtime_error(self):
        with self.assertRaisesRegex(RuntimeError, "not at rest"):
            fc.cantilever(odd_fiber(6), 1.0, method="march", march={"max_periods": 0.01})
        with self.assertRaises(TypeError):
            fc.Fiber("2 mm", 10, youngs_modulus=object(), poisson_ratio=0.3, density=1000)


if __name__ == "__main__":
    unittest.main()
