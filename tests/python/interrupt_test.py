"""Ctrl-C stops long calls; others run meanwhile."""

import os
import signal
import threading
import time
import unittest

from common import SOURCE, InDirectory, odd_fiber, packing_scene

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

    def test_paths_of_rods_stop(self):
        rod = fc.Rod(odd_fiber(800, bond_model="corrected"), [fc.Support("first")], dimension="spatial",
                     loads=[fc.Load("last", reduced_force=(0, 3, 1))])
        self.check_stops(lambda: rod.trace(points=100000))
        self.check_stops(lambda: fc.run(os.path.join(SOURCE, "data", "scenes", "rod-frame.yaml"),
                                        settings={"path.points": 100000, "path.most_points": 1000000}))

    def test_what_two_threads_cannot_do_at_once_is_refused(self):
        packing = fc.Packing(packing_scene(count=12, duration=0.4))
        other = threading.Thread(target=packing.run)
        other.start()
        while other.is_alive():
            try:
                packing.positions
            except RuntimeError as error:
                self.assertIn("another thread", str(error))
                break
        else:
            self.fail("was not refused")
        other.join()
        self.assertEqual(packing.steps, packing.total_steps)
        scene = packing_scene(count=12, duration=0.4, output={"samples": 2, "frames": 200, "checkpoints": 0})
        other = threading.Thread(target=fc.run, args=(scene,), kwargs={"name": "p.yaml"})
        other.start()
        while not os.path.exists("p.h5"):
            time.sleep(0.001)
        with self.assertRaisesRegex(RuntimeError, "another thread"):
            fc.Trajectory("p.h5")
        other.join()
        self.assertEqual(len(fc.Trajectory("p.h5")), 201)


if __name__ == "__main__":
    unittest.main()
