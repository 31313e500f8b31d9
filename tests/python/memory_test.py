"""Arrays share memory with what they are of, keep it alive, and give it back."""

import gc
import resource
import sys
import unittest
import weakref

import numpy as np
from common import packing_scene

import fiberchain as fc


def resident():
    """Memory of the process now [bytes]."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize()


class Memory(unittest.TestCase):
    def test_arrays_of_a_frame_are_views_and_keep_it(self):
        packing = fc.Packing(packing_scene())
        packing.step(3)
        frame = packing.frame()
        positions, again, bonds = frame.positions, frame.positions, frame.bonds
        self.assertIs(positions.base, frame)
        self.assertEqual(positions.__array_interface__["data"], again.__array_interface__["data"])
        self.assertIs(bonds.base, frame)
        self.assertTrue(positions.flags.c_contiguous)
        kept = positions.copy()
        del packing, frame, again, bonds
        gc.collect()
        np.testing.assert_array_equal(positions, kept)

    def test_references_are_counted(self):
        packing = fc.Packing(packing_scene())
        packing.run()
        frame = packing.frame()
        self.assertGreater(len(frame.contacts), 0)
        before = sys.getrefcount(frame)
        arrays = [frame.positions, frame.bonds, frame.contacts, frame.radii]
        self.assertEqual(sys.getrefcount(frame), before + len(arrays))
        del arrays
        self.assertEqual(sys.getrefcount(frame), before)
        positions = packing.positions
        self.assertEqual(sys.getrefcount(positions), 2)
        gone = weakref.ref(positions)
        del positions
        self.assertIsNone(gone())

    def test_big_arrays_are_given_back(self):
        packing = fc.Packing(packing_scene(count=1000, duration=1e-4, periodic={"x": "80 mm", "y": "80 mm"}))
        packing.step(2)
        size = packing.positions.nbytes
        self.assertEqual(size, 1000 * 8 * 3 * 8)
        for _ in range(20):
            packing.positions, packing._core.frame(True), packing.structure()
        before = resident()
        for _ in range(100):
            packing.positions, packing._core.frame(True).bonds
        # one that is kept each time would be 200 times as much
        self.assertLess(resident() - before, 20 * size)


if __name__ == "__main__":
    unittest.main()
