"""The inversion of ring-downs, by the module and by the program."""

import json
import unittest

import numpy as np
from common import InDirectory, odd_fiber, program

import fiberchain as fc


def ring_down(xi=0.01, omega=120.0, periods=15, samples=1500, noise=0.0, seed=1, offset=0.3):
    time = np.linspace(0, periods * 2 * np.pi / omega, samples)
    damped = omega * np.sqrt(1 - xi**2)
    clean = np.exp(-xi * omega * time) * np.cos(damped * time - 0.4) + offset
    return time, clean + noise * np.random.default_rng(seed).standard_normal(samples)


class Identify(unittest.TestCase):
    def test_a_chain_s_own_ring_down_gives_its_modulus_and_damping(self):
        truth = odd_fiber(13, bond_damping=0.8)
        run = fc.release(truth, 0.01, periods=25)
        noise = 0.01 * run.y[0] * np.random.default_rng(7).standard_normal(run.y.size)
        found = fc.identify(run.time, run.y + noise, fiber=odd_fiber(13, youngs_modulus=1e6), of="chain")
        self.assertEqual(found.doubts, [])
        # the leapfrog's own step is in both: 2e-3
        self.assertAlmostEqual(found.youngs_modulus.value / truth.youngs_modulus, 1, delta=2e-3)
        self.assertAlmostEqual(found.bond_damping.value / 0.8, 1, delta=0.02)
        self.assertEqual(found.residuals.shape, run.y.shape)

    def test_a_beam_s_modulus(self):
        fiber = odd_fiber(40)
        E, L = 5.5e9, fiber.length
        omega = (1.87510407 / L)**2 * np.sqrt(E * fiber.diameter**2 / 16 / fiber.density)
        found = fc.identify(*ring_down(omega=omega, noise=0.01), fiber=fiber)
        self.assertTrue(found.youngs_modulus.low < E < found.youngs_modulus.high)
        self.assertLess(found.youngs_modulus.high - found.youngs_modulus.low, 1e-3 * E)

    def test_it_says_where_the_record_cannot_tell(self):
        noise = np.random.default_rng(3).standard_normal(500)
        for time, record, word in ((np.arange(500.0), noise, "stands out"),
                                   (*ring_down(periods=1.2, noise=0.01), "periods"),
                                   (*ring_down(xi=1e-5, noise=0.2, samples=200), "holds none")):
            found = fc.identify(time, record)
            self.assertEqual(len(found.doubts), 1, found.doubts)
            self.assertIn(word, found.doubts[0])
            self.assertTrue(np.isnan(found.damping_ratio.value))
        with self.assertRaisesRegex(ValueError, "must rise"):
            fc.identify([0, 1, 1] + list(range(2, 20)), np.zeros(21))
        with self.assertRaisesRegex(ValueError, "too few"):
            fc.identify([0, 1, 2], [0, 1, 2])


class Program(InDirectory):
    def test_the_command_finds_the_same(self):
        time, record = ring_down(noise=0.01)
        np.savetxt("r.csv", np.column_stack([record, 1e3 * time]), delimiter=",", header="y,t", comments="")
        said = program("identify", "r.csv", "--time", "t", "--time-unit", "1 ms", "--displacement", "y", "--diameter",
                       "0.5 mm", "--aspect-ratio", "30", "--density", "1500", "--json")
        self.assertEqual(said.returncode, 0, said.stderr)
        rows = {row["quantity"]: row for row in json.loads(said.stdout)["rows"]}
        fiber = fc.Fiber(0.5e-3, 30, youngs_modulus=1e9, poisson_ratio=0.3, density=1500)
        found = fc.identify(time, record, fiber=fiber)
        for name in ("damping_ratio", "youngs_modulus", "bond_damping", "loss_factor"):
            self.assertAlmostEqual(rows[name]["identified"] / getattr(found, name).value, 1, delta=1e-9)
            self.assertAlmostEqual(rows[name]["interval_low"] / getattr(found, name).low, 1, delta=1e-9)

    def test_the_command_says_where_it_cannot_tell_and_what_is_wrong(self):
        np.savetxt("r.csv", np.column_stack([np.arange(100), np.random.default_rng(1).standard_normal(100)]),
                   delimiter=",", header="t,y", comments="")
        said = program("identify", "r.csv")
        self.assertEqual(said.returncode, 1)
        self.assertIn("cannot tell", said.stderr)
        with open("odd.csv", "w") as file:
            file.write("t,y\n0,1\n1,x\n")
        said = program("identify", "odd.csv")
        self.assertEqual(said.returncode, 2)
        self.assertIn("odd.csv:3: column 2: 'x'", said.stderr)
        self.assertEqual(program("identify", "none.csv").returncode, 2)
        self.assertEqual(program("identify", "r.csv", "--density", "1000").returncode, 2)


if __name__ == "__main__":
    unittest.main()
