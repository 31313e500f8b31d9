"""Packings: the bits of the program, what is read between steps, what may be changed there."""

import json
import unittest

import numpy as np
from common import InDirectory, odd_fiber, packing_scene, program

import fiberchain as fc


class AgainstTheProgram(InDirectory):
    def test_a_packing_ends_in_the_bits_of_the_program(self):
        scene = packing_scene(output={"samples": 5, "frames": 5, "checkpoints": 0, "energy": True, "contacts": True})
        packing = fc.Packing(scene)
        with open("s.yaml", "w") as file:
            json.dump(json.loads(fc._scene_text.text_of(scene)[0]), file)
        self.assertEqual(program("run", "s.yaml", "--out", "out", "--no-figures", "--jobs", "1").returncode, 0)
        log, trajectory = fc.read_table("out/s-log.csv"), fc.Trajectory("out/s.h5")
        self.assertEqual(len(trajectory), 6)
        for line, step in enumerate(log["step"]):
            packing.step(int(step) - packing.steps)
            for column, value in packing.observables().items():
                self.assertEqual(value, log[column][line], f"{column} at step {step}")
            frame = trajectory[line]
            self.assertEqual(frame.step, step)
            # files round positions to 2^-37 of their value
            np.testing.assert_allclose(packing.positions, frame.positions, rtol=2.0**-36, atol=1e-15)
            np.testing.assert_allclose(packing.velocities, frame.velocities, rtol=1e-6, atol=1e-9)
            self.assertEqual(len(packing.contacts), len(frame.contacts))
        self.assertEqual(packing.steps, packing.total_steps)
        self.assertGreater(log["contacts"][-1], 5)

    def test_pieces_and_threads_change_no_bit(self):
        scene = packing_scene(filling={"region": {"z": [0, "25 mm"]}, "seed": 5, "velocity": [0, 0, -0.8],
                                       "batches": {"number": 2, "interval": "3 ms"}}, duration="6 ms")
        whole, pieces = fc.Packing(scene), fc.Packing(scene, threads=2)
        whole.run()
        while pieces.steps < pieces.total_steps:
            pieces.step(min(37, pieces.total_steps - pieces.steps))
        self.assertEqual(len(whole), 12 * 8)
        np.testing.assert_array_equal(whole.positions, pieces.positions)

    def test_run_writes_what_the_program_writes(self):
        scene = packing_scene(duration="2 ms", output={"samples": 2, "frames": 2, "checkpoints": 1})
        done = fc.run(scene, name="p.yaml", directory="mine")
        self.assertEqual(done.table["status"][0], "finished")
        with self.assertRaisesRegex(ValueError, "is there already"):
            fc.run(scene, name="p.yaml", directory="mine")
        fc.run(scene, name="p.yaml", directory="mine", earlier="replace")
        self.assertEqual(len(fc.Trajectory("mine/p.h5")), 3)


class Between(unittest.TestCase):
    def lone(self, **more):
        return fc.Packing(packing_scene(count=1, duration="20 ms", **more))

    def test_gravity_changes_from_now_on(self):
        packing = self.lone(gravity=[0, 0, 0], filling={"region": {"z": ["10 mm", "15 mm"]}, "seed": 2})
        start, dt = packing.positions.mean(axis=0), packing.time_step
        packing.gravity = (1.5, 0, 0)
        packing.step(200)
        packing.gravity = (0, -2.5, 0)
        packing.step(300)
        moved = packing.positions.mean(axis=0) - start
        # the leapfrog's sums: a whole kick at each step from the change on
        first, second = 200, 300
        x = 1.5 * dt**2 * (0.5 * first * (first + 1) + first * second)
        y = -2.5 * dt**2 * sum(n for n in range(1, second + 1))
        self.assertAlmostEqual(moved[0] / x, 1, delta=1e-8)
        self.assertAlmostEqual(moved[1] / y, 1, delta=1e-8)
        self.assertAlmostEqual(moved[2], 0, delta=1e-12)

    def test_a_wall_that_is_set_going_is_one_that_went(self):
        going = packing_scene(count=12)
        going["walls"]["planes"][1]["velocity"] = [0, 0, -1.0]
        one, other = fc.Packing(going), fc.Packing(packing_scene(count=12))
        other.walls["plate"].velocity = (0, 0, -1)
        for packing in (one, other):
            packing.step(one.total_steps)
        self.assertLess(one.walls["plate"].place[2], 0.018)
        self.assertNotEqual(one.walls["plate"].force[2], 0)
        np.testing.assert_array_equal(one.positions, other.positions)

    def test_a_wall_that_is_stopped_is_two_walls_of_a_scene(self):
        stop, height, speed = 4e-3, 25e-3, 2.0
        scene = packing_scene(count=16, contacts={"restitution": 0.5, "friction": 0})
        scene["walls"]["planes"][1:] = [
            {"point": [0, 0, height], "normal": [0, 0, -1], "velocity": [0, 0, -speed], "until": stop},
            {"point": [0, 0, height - speed * stop], "normal": [0, 0, -1], "from": stop}]
        two = fc.Packing(scene)
        scene["walls"]["planes"][1:] = [{"point": [0, 0, height], "normal": [0, 0, -1], "name": "plate",
                                         "velocity": [0, 0, -speed]}]
        scene["motion"] = {"step": two.time_step}
        one = fc.Packing(scene)
        steps = round(stop / two.time_step)
        one.step(steps), two.step(steps)
        np.testing.assert_allclose(one.positions, two.positions, rtol=0, atol=1e-12)
        plate = one.walls["plate"]
        plate.velocity = (0, 0, 0)
        plate.place = (0, 0, height - speed * stop)
        before = plate.force
        one.step(3000), two.step(3000)
        self.assertAlmostEqual(plate.place[2], height - speed * stop, delta=1e-15)
        self.assertNotEqual(before, plate.force)
        self.assertGreater(plate.force[2], 0)
        # a contact that begins at another wall has no memory of its speed: first order in the step
        np.testing.assert_allclose(one.positions, two.positions, rtol=0, atol=2e-5)

    def test_a_wall_put_elsewhere_meets_spheres_there(self):
        packing = fc.Packing(packing_scene(count=12, gravity=[0, 0, 0], filling={"region": {"z": [0, "25 mm"]},
                                                                               "seed": 3}))
        packing.step(10)
        self.assertEqual(packing.walls["plate"].force, (0, 0, 0))
        top = packing.positions[:, 2].max()
        packing.walls["plate"].place = (0, 0, top + 0.9 * packing.radii[0])
        packing.step(1)
        packing.step(1)
        self.assertGreater(packing.walls["plate"].force[2], 0)
        with self.assertRaisesRegex(ValueError, "would be behind it"):
            packing.walls["plate"].place = (0, 0, top - 1e-3)
        self.assertAlmostEqual(packing.walls["plate"].place[2], top + 0.9 * packing.radii[0], delta=1e-12)
        with self.assertRaisesRegex(ValueError, "finite"):
            packing.walls["plate"].velocity = (0, 0, float("nan"))
        with self.assertRaises(KeyError):
            packing.walls["plat"]

    def test_a_servo_holds_the_force_of_a_plate(self):
        wanted = 0.5
        packing = fc.Packing(packing_scene(count=24, gravity=[0, 0, 0],
                                           contacts={"restitution": 0.2, "friction": 0.3},
                                           filling={"region": {"z": [0, "25 mm"]}, "seed": 3}))
        plate, floor, forces = packing.walls["plate"], packing.walls["floor"], []
        for _ in range(6000):
            packing.step(10)
            plate.velocity = (0, 0, min(0.3, max(-0.8, 0.5 * (plate.force[2] - wanted))))
            forces.append((plate.force[2], -floor.force[2]))
        held, below = np.mean(forces[-500:], axis=0)
        self.assertAlmostEqual(held / wanted, 1, delta=1e-3)
        # at rest what presses from above presses on the floor
        self.assertAlmostEqual(below / held, 1, delta=1e-3)
        self.assertLess(plate.place[2], 0.012)

    def test_contacts_bonds_and_walls_agree(self):
        packing = fc.Packing(packing_scene(count=16))
        packing.step(packing.total_steps - 1)
        packing.step(1, keep_forces=True)
        contacts, frame = packing.contacts, packing.frame()
        at_floor = contacts[(contacts["kind"] == 1) & (contacts["second"] == 1)]
        self.assertGreater(len(at_floor), 0)
        # what pushes spheres up pushes the floor down
        pushed = at_floor["force"].sum(axis=0)
        self.assertGreater(pushed[2], 0)
        np.testing.assert_allclose(frame.fibers, np.repeat(np.arange(16), 8))
        np.testing.assert_array_equal(np.diff(packing.bonds["first"].reshape(16, 7), axis=1), 1)
        lengths = np.linalg.norm(np.diff(packing.positions.reshape(16, 8, 3), axis=1), axis=2)
        np.testing.assert_allclose(lengths, 1.66e-3, rtol=0.05)
        self.assertTrue(0 < packing.structure()["contacts_per_fiber"] < 20)


if __name__ == "__main__":
    unittest.main()
