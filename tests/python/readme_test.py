"""What the README files show runs as it stands there, loops of control shorter."""

import os
import re
import unittest

import numpy as np
from common import SOURCE, InDirectory


def blocks(path):
    with open(os.path.join(SOURCE, path)) as file:
        return re.findall(r"```python\n(.*?)```", file.read(), re.DOTALL)


class Readme(InDirectory):
    def setUp(self):
        super().setUp()
        os.symlink(os.path.join(SOURCE, "data"), "data")
        time = np.linspace(0, 0.1, 500)
        record = np.exp(-8 * time) * np.cos(700 * time)
        np.savetxt("ring-down.csv", np.column_stack([time, record]), delimiter=",", header="time,y", comments="")

    def check_runs(self, path, count):
        names = {"wanted": 0.5}
        every = blocks(path)
        self.assertEqual(len(every), count)
        for block in every:
            shorter, loops = re.subn(r"packing\.time < [0-9.]+", "packing.time < 0.015", block)
            self.assertEqual(loops, block.count("while "))
            exec(compile(shorter, path, "exec"), names)
        return names

    def test_of_the_module(self):
        names = self.check_runs("compare/python/README.md", 5)
        self.assertAlmostEqual(20 * names["critical"].load_factor, np.pi**2, delta=0.02)
        self.assertEqual(names["found"].doubts, [])
        self.assertAlmostEqual(names["found"].damping_ratio.value, 8 / np.hypot(8, 700), delta=1e-8)

    def test_of_the_project(self):
        names = self.check_runs("README.md", 1)
        self.assertGreaterEqual(names["packing"].time, 0.015)


if __name__ == "__main__":
    unittest.main()
