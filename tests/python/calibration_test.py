"""Fibers, materials and calibration."""

import json
import unittest

import numpy as np
from common import odd_fiber, program

import fiberchain as fc


class Calibration(unittest.TestCase):
    def test_a_calibrated_fiber_has_the_damping_asked_for(self):
        for target in ({"damping_ratio": 0.013}, {"quality_factor": 1 / 0.026}, {"loss_factor": 0.026},
                       {"log_decrement": 2 * np.pi * 0.013 / np.sqrt(1 - 0.013**2)}):
            found = fc.calibrate(odd_fiber(13), **target)
            self.assertAlmostEqual(fc.calibration_of(found.fiber)["fiber_damping_modes"], 0.013, delta=1e-10)
        # a long chain's (beta_1^2/sqrt(20)) xi_b/(r_f + 1/2)^2, to 0.3 %
        closed = 1.87510407**2 / np.sqrt(20) * found.fiber.bond_damping / 13.5**2
        self.assertAlmostEqual(closed / 0.013, 1, delta=3e-3)

    def test_the_program_finds_the_same(self):
        said = program("calibrate", "--damping-ratio", "0.02", "--aspect-ratio", "13", "--diameter", "1.66e-3",
                       "--youngs-modulus", "3.1e6", "--poisson-ratio", "0.17", "--density", "1130", "--json")
        row = json.loads(said.stdout)["rows"][0]
        found = fc.calibrate(odd_fiber(13), damping_ratio=0.02)
        for column in ("bond_damping", "natural_frequency", "stable_time_step", "fiber_damping_beam"):
            self.assertEqual(found[column], row[column], column)

    def test_a_calibrated_fiber_goes_into_a_scene(self):
        fiber = fc.calibrate(odd_fiber(13), damping_ratio=0.02).fiber
        self.assertEqual(fiber.scene_keys(count=3)["bond"]["damping"], fiber.bond_damping)
        self.assertEqual(fiber.scene_keys(count=3)["count"], 3)
        run = fc.release(fiber, 0.005, periods=12)
        self.assertAlmostEqual(run.table["fiber_damping"][0] / 0.02, 1, delta=0.01)
        retarded = fc.calibrate(odd_fiber(13), damping_ratio=0.02, dashpots="retardation_time").fiber
        self.assertGreater(retarded.retardation_time, 0)
        with self.assertRaisesRegex(ValueError, "retardation_time"):
            retarded.scene_keys()

    def test_one_target_is_needed(self):
        for targets in ({}, {"damping_ratio": 0.1, "loss_factor": 0.2}):
            with self.assertRaisesRegex(ValueError, "exactly one"):
                fc.calibrate(odd_fiber(13), **targets)


class Materials(unittest.TestCase):
    def test_a_material_by_name(self):
        self.assertIn("spruce", fc.materials())
        spruce = fc.material("spruce")
        fiber = fc.Fiber("1 mm", 20, material="spruce")
        self.assertEqual(fiber.youngs_modulus, spruce["youngs_modulus"]["value"])
        self.assertEqual(fiber.density, 405)
        with self.assertRaisesRegex(ValueError, "sprace"):
            fc.material("sprace")

    def test_wood_damps_flat_and_dashpots_do_not(self):
        damped = fc.damp_by_material(fc.Fiber("5 mm", 20, material="spruce"), band=(10, 1e4))
        modes = damped.modes
        self.assertGreater(damped.fiber.branch_count, 4)
        # zeta = tan(delta)/2 over the band, shear's own loss on top of it
        inside = modes["mode_frequency"] < 1e4
        self.assertGreater(inside.sum(), 0)
        np.testing.assert_array_less(0.97 * 0.004, modes["mode_damping"][inside])
        self.assertAlmostEqual(modes["mode_damping_dashpots"][0] / modes["mode_damping"][0], 1, delta=1e-6)
        self.assertGreater(modes["mode_damping_dashpots"][1], 4 * modes["mode_damping"][1])

    def test_a_damped_fiber_is_the_same_in_a_scene(self):
        stick = fc.Fiber("5 mm", 20, material="spruce")
        flat = odd_fiber(13)
        for damped in (fc.damp_by_material(stick), fc.damp_by_material(stick, band=(10, 1e4)),
                       fc.damp_by_material(fc.Fiber("20 um", 20, material="carbon-steel")),
                       fc.damp_by_material(flat, loss_factor=0.03, band=(5, 500))):
            again = damped.fiber.replace()
            self.assertGreater(again.branch_count, 0)
            self.assertEqual(again.branch_count, damped.fiber.branch_count)
            self.assertAlmostEqual(again.youngs_modulus / damped.fiber.youngs_modulus, 1, delta=1e-14)
        self.assertLess(again.youngs_modulus, flat.youngs_modulus)


if __name__ == "__main__":
    unittest.main()
