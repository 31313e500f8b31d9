"""What the examples share: their arguments, and a figure that is saved."""

import argparse
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def arguments(description):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--small", action="store_true", help="a size for a test: seconds")
    parser.add_argument("--out", default=".", help="directory of the figure")
    return parser.parse_args()


def save(figure, options, name):
    os.makedirs(options.out, exist_ok=True)
    path = os.path.join(options.out, name + ".png")
    figure.tight_layout()
    figure.savefig(path, dpi=120)
    plt.close(figure)
    print("wrote", path)
