"""Ctrl-C stops long calls; others run meanwhile."""

import os
import signal
import threading
import time
import unittest

from common import InDirectory, odd_fiber, packing_scene

import fiberchain as fc


class Interrupt(InDirectory):
    def check_stops(self, call):
        """By SIGINT after a while; in far less than the call would take."""
        counted = []

        def count():
            for _ in range(20):
                counted.append(time.monotonic())
                time.sleep(0.01)
            os.kill(os.getpid(), signal.SIGINT)
        other = threading.Thread(target=count)
        begin = time.monotonic()
        other.start()
        with self.assertRaises(KeyboardInterrupt):
            call()
        took = time.monotonic() - begin
        other.join()
        self.assertLess(took, 8)
        self.assertEqual(len(counted), 20)

    def test_a_packing_stops_between_steps_and_goes_on(self):
        scene = packing_scene(count=12, duration=3.0)
        packing, whole = fc.Packing(scene), fc.Packing(scene)
        self.check_stops(packing.run)
        done = packing.steps
        self.assertTrue(0 < done < packing.total_steps)
        packing.step(50)
        whole.step(done + 50)
        self.assertTrue((whole.positions == packing.positions).all())

    def test_a_run_with_files_stops_at_a_checkpoint_and_is_resumed(self):
        scene = packing_scene(count=12, duration=3.0, output={"samples": 10, "frames": 10, "checkpoints": 0})
        self.check_stops(lambda: fc.run(scene, name="p.yaml", directory="out"))
        self.assertTrue(os.path.exists("out/p.checkpoint"))
        self.check_stops(lambda: fc.run(scene, name="p.yaml", directory="out", earlier="resume"))

    def test_scenes_of_one_fiber_stop(self):
        fiber = odd_fiber(40)
        self.check_stops(lambda: fc.release(fiber, 1.0, periods=1e5, time={"integrator": "leapfrog"}))
        self.check_stops(lambda: fc.release(fiber, 1.0, periods=1e4, time={"integrator": "implicit"}))
        self.check_stops(lambda: fc.cantilever(odd_fiber(300), 1.0, method="march"))
        self.check_stops(lambda: fc.flow(fiber, {"viscosity": 50, "flow": "shear", "rate": 1}, strain=1e5,
                                         samples=100000, start={"direction": [-1, 0.1, 0], "bend": 0.01}))


if __name__ == "__main__":
    unittest.main()
