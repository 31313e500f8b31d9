"""Runs an example at its small size and looks at the figure: python3 run_example.py NAME DIRECTORY."""

import os
import subprocess
import sys

try:
    import matplotlib  # noqa: F401
except ImportError:
    print("skipped: matplotlib is not installed")
    sys.exit(0)

name, directory = sys.argv[1:]
script = os.path.join(os.environ["FIBERCHAIN_SOURCE_DIR"], "compare", "python", "examples", name + ".py")
figure = os.path.join(directory, name.replace("_", "-") + ".png")
if os.path.exists(figure):
    os.remove(figure)
done = subprocess.run([sys.executable, "-B", script, "--small", "--out", directory])
if done.returncode != 0:
    sys.exit(done.returncode)
with open(figure, "rb") as file:
    content = file.read()
if not content.startswith(b"\x89PNG") or len(content) < 10000:
    sys.exit(f"{figure} is no figure")
