"""Rods held and loaded in any way: against closed forms and the program."""

import os
import unittest

import numpy as np
from common import SOURCE, InDirectory, odd_fiber, program

import fiberchain as fc

HINGES = [fc.Support("first", turn="xy"), fc.Support("last", place="yz", turn="xy")]


def straight(bonds=24, **more):
    return odd_fiber(bonds, bond_model="corrected", **more)


class ClosedForms(unittest.TestCase):
    def test_an_end_moment_makes_a_circle(self):
        turn = 1.3  # [rad] = M L/(E I): the chain's bonds bend alike, so its spheres lie on an arc to round-off
        rod = fc.Rod(straight(), [fc.Support("first")], loads=[fc.Load("last", reduced_moment=(0, 0, turn))])
        rest = rod.solve()
        positions = rest.positions
        self.assertEqual(positions.shape, (25, 3))
        chords = np.diff(positions, axis=0)
        turns = np.diff(np.arctan2(chords[:, 1], chords[:, 0]))
        np.testing.assert_allclose(turns, turn / 24, rtol=0, atol=1e-9)
        # the end's orientation is turned by M L/(E I) about z; the clamp bears the moment
        w, z = rest.orientations[-1, [0, 3]]
        self.assertAlmostEqual(2 * np.arctan2(z, w), turn, delta=1e-9)
        moment = turn * rod.bending_stiffness / rod.length
        np.testing.assert_allclose(rest.reactions, [[0, 0, 0, 0, 0, -moment]], rtol=0, atol=1e-9 * moment)
        self.assertAlmostEqual(rest.elastic_energy / (moment * turn / 2), 1, delta=1e-9)

    def test_reactions_bear_loads_and_weight(self):
        fiber = straight(13, mass="cylinder")
        rod = fc.Rod(fiber, [fc.Support("first"), fc.Support("last", place="z", turn="none")], dimension="spatial",
                     loads=[fc.Load(5, reduced_force=(0.1, -0.3, 0.2))], gravity=(0, 0, -9.81),
                     line_loads=[fc.LineLoad("3..9", force=(0, 0.01, 0))])
        found = rod.solve(0.7)
        unit = rod.bending_stiffness / rod.length**2
        weight = np.pi / 4 * fiber.diameter**2 * fiber.density * rod.length * 9.81
        loads = 0.7 * unit * np.array([0.1, -0.3, 0.2]) + 0.7 * np.array([0, 0.01 * 6 * rod.length / 13, 0])
        np.testing.assert_allclose(found.reactions[:, :3].sum(axis=0), -loads + [0, 0, weight], rtol=0, atol=1e-9 * unit)
        self.assertEqual(found.stability, "stable")

    def test_a_column_buckles_at_euler_s_load_and_its_branch_is_left_both_ways(self):
        rod = fc.Rod(straight(40), HINGES, loads=[fc.Load("last", reduced_force=(-20, 0, 0))])
        path = rod.trace(control="load", points=10, probe={"sphere": 20, "direction": (0, 1, 0)})
        first, = path.bifurcations
        # the rod shortens: P (1 - P/EA) = pi^2 EI/L^2, with EI/(EA L^2) = 1/(16 r_f^2); finite bonds of fourth order
        euler = np.pi**2 * (1 + np.pi**2 / (16 * 40**2))
        self.assertAlmostEqual(20 * first.load_factor / euler, 1, delta=(np.pi / 40)**4 / 10)
        self.assertEqual(first.crossing, 1)
        spheres = np.linspace(0, 1, 41)
        np.testing.assert_allclose(first.mode[:, 1] / first.mode[20, 1], np.sin(np.pi * spheres), rtol=0, atol=1e-6)
        up, down = path.branch(), path.branch(side="minus")
        np.testing.assert_allclose(up[-1].positions * [1, -1, 1], down[-1].positions, rtol=0, atol=1e-9 * rod.length)
        self.assertAlmostEqual(up.load_factors[-1], 1, delta=1e-12)
        self.assertEqual({point.stability for point in up[2:]}, {"stable"})
        self.assertEqual(path[-1].stability, "unstable")
        self.assertEqual(path[-1].negative_eigenvalues, 1)


class AgainstTheProgram(InDirectory):
    def test_a_scene_s_path_is_the_program_s_to_the_bit(self):
        scene = os.path.join(SOURCE, "data", "scenes", "rod-frame.yaml")
        self.assertEqual(program("run", scene, "--set", "path.points=20", "--out", "out", "--no-figures").returncode, 0)
        own = fc.records(fc.read_table("out/rod-frame-path.csv"))
        rod = fc.Rod.of_scene(scene, settings={"path.points": 20})
        path = rod.trace()
        points = own[own["path_event"] == ""]
        self.assertEqual(len(path), len(points))
        np.testing.assert_array_equal(path.load_factors, points["load_factor"])
        np.testing.assert_array_equal(path.records["elastic_energy"], points["elastic_energy"])
        np.testing.assert_array_equal(path.positions[:, -1, 0] / rod.length, points["end_x"])
        self.assertEqual([one.load_factor for one in path.singular], list(own[own["path_event"] != ""]["load_factor"]))
        self.assertEqual([one.kind for one in path.limit_points], ["limit point"] * 2)
        self.assertEqual(path.reactions.shape, (len(path), 2, 6))
        # and what is asked of the path here goes before what the scene says
        self.assertEqual(len(rod.trace(control="load", points=4, end_factor=0.15)), 5)

    def test_a_rod_built_here_is_that_of_the_same_scene(self):
        fiber = straight(9)
        built = fc.Rod(fiber, [fc.Support("first")], shape={"corner": 4}, dimension="spatial",
                       loads=[fc.Load("last", force=(0, 0, 2e-3), direction="following")])
        text = {"scene": "rod", "dimension": "spatial", "fiber": fiber._keys, "bond": {"model": "corrected"},
                "shape": {"corner": 4}, "supports": [{"sphere": "first"}],
                "loads": [{"sphere": "last", "force": [0, 0, 2e-3], "direction": "following"}]}
        other = fc.Rod.of_scene(text)
        np.testing.assert_array_equal(built.solve().positions, other.solve().positions)
        np.testing.assert_array_equal(built.rest_positions[4], [4 * fiber.diameter, 0, 0])
        self.assertFalse(built.has_potential)
        self.assertEqual(built.solve().stability, "undecided")


class Errors(unittest.TestCase):
    def check_refused(self, text, call):
        with self.assertRaisesRegex(ValueError, text):
            call()

    def test_what_is_not_allowed_is_named(self):
        fiber = straight(8)
        rod = fc.Rod(fiber, HINGES, loads=[fc.Load("last", reduced_force=(-5, 0, 0))])
        self.check_refused("supports", lambda: fc.Rod(fiber, [fc.Support(3, turn="none")]))
        self.check_refused("'9' is not allowed; allowed: first, last or a sphere of 0 to 8",
                           lambda: fc.Rod(fiber, [fc.Support(9)]))
        self.check_refused("loads.*moment", lambda: fc.Rod(fiber, [fc.Support(0)], loads=[fc.Load(8)]))
        self.check_refused("control.*arc-length", lambda: rod.trace(control="arc"))
        self.check_refused("path.pionts", lambda: rod.trace(pionts=3))
        self.check_refused("factor", lambda: rod.solve(float("nan")))
        self.check_refused("end_factor = 0", lambda: rod.solve(0))
        self.check_refused("the path has 0 bifurcations", lambda: rod.trace(points=2).branch())
        self.check_refused("another kind", lambda: fc.Rod.of_scene(
            os.path.join(SOURCE, "data", "scenes", "release.yaml")))
        with self.assertRaises(FileNotFoundError):
            fc.Rod.of_scene("none.yaml")

    def test_a_load_that_cannot_be_borne_is_a_runtime_error(self):
        rod = fc.Rod.of_scene(os.path.join(SOURCE, "data", "scenes", "rod-frame.yaml"))
        with self.assertRaisesRegex(RuntimeError, "no equilibrium found beyond"):
            rod.trace(control="load", points=5, end_factor=2.2)


if __name__ == "__main__":
    unittest.main()
