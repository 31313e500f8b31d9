"""Trajectories are read frame by frame."""

import unittest

import numpy as np
from common import InDirectory, packing_scene

import fiberchain as fc


class Trajectories(InDirectory):
    def setUp(self):
        super().setUp()
        fc.run(packing_scene(duration="2 ms", output={"samples": 2, "frames": 4, "checkpoints": 0, "contacts": True}),
               name="t.yaml")
        self.trajectory = fc.Trajectory("t.h5")

    def test_frames_are_there_one_by_one(self):
        trajectory = self.trajectory
        self.assertEqual(len(trajectory), 5)
        self.assertEqual([frame.step for frame in trajectory], list(trajectory.steps))
        np.testing.assert_allclose([frame.time for frame in trajectory], trajectory.times)
        last = trajectory[-1]
        self.assertEqual(last.positions.shape, (96, 3))
        self.assertEqual(last.bonds.shape, (84,))
        self.assertEqual(last.contacts.dtype.names, ("first", "second", "kind", "point", "normal", "force"))
        self.assertEqual(last.periodic, (True, True, False))
        self.assertEqual(trajectory.scalars(4)["contacts"], len(last.contacts))
        self.assertIn("version", trajectory.provenance)
        with self.assertRaises(IndexError):
            trajectory[5]

    def test_h5py_reads_the_same(self):
        try:
            import h5py
        except ImportError:
            self.skipTest("h5py is not installed")
        with h5py.File("t.h5") as file:
            np.testing.assert_array_equal(file["particles/fibers/position/value"][2], self.trajectory[2].positions)

    def test_what_is_damaged_is_an_os_error(self):
        with open("t.h5", "r+b") as file:
            file.truncate(3000)
        with self.assertRaisesRegex(OSError, "t.h5"):
            fc.Trajectory("t.h5")[4]


if __name__ == "__main__":
    unittest.main()
