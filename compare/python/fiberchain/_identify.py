"""From a ring-down to the fiber."""

import os
from dataclasses import dataclass
from typing import NamedTuple

import numpy

from . import _core


class Estimate(NamedTuple):
    """A value with the ends of its interval; NaN where the record cannot tell."""

    value: float
    low: float
    high: float


@dataclass(frozen=True)
class Identification:
    """What a ring-down tells."""

    frequency: Estimate  #: undamped [rad/s]
    damping_ratio: Estimate  #: xi_f
    log_decrement: Estimate
    loss_factor: Estimate  #: 2 xi_f
    youngs_modulus: Estimate | None  #: [Pa]; None without a fiber
    bond_damping: Estimate | None  #: xi_b of a chain with that xi_f; None without a fiber
    table: dict  #: all of them as a table
    noise: float  #: standard deviation of what the fit leaves, in the record's unit
    amplitude: float  #: of the mode at the begin, likewise
    periods: float  #: that the record has
    modes: int  #: damped sines that were fitted
    doubts: list  #: why the record cannot tell; empty where it can
    warnings: list  #: what makes the intervals too narrow
    residuals: numpy.ndarray  #: float64 (samples,): record less fit


def identify(time, displacement, *, fiber=None, of="beam", confidence=0.95):
    """Young's modulus, damping and loss factor from a ring-down, with intervals.

    time [s], rising, and displacement, of any unit and zero: arrays (samples,), 12 or more.
    fiber: its diameter, aspect ratio, density, Poisson's ratio, bond and mass model count; its E and damping are
    sought. Left out: frequency and damping only. of: "beam", a real fiber clamped at one end, or "chain", of this
    program. Damped sines are fitted by least squares, their start found here; intervals are those of the fit's
    covariance, with Student's t, at `confidence`.
    Raises ValueError for records that are none.
    """
    found = _core.identify(time, displacement, fiber, of, confidence)
    for key in ("frequency", "damping_ratio", "log_decrement", "loss_factor", "youngs_modulus", "bond_damping"):
        found[key] = None if found[key] is None else Estimate(*found[key])
    return Identification(**found)


def read_record(path, *, time="", displacement="", time_unit=1.0):
    """Times [s] and displacements of a CSV file: the first two columns, or those named."""
    if not os.path.exists(path):
        raise FileNotFoundError(f"{os.fspath(path)}: there is no such file")
    return _core.read_record(os.fspath(path), time, displacement, time_unit)
