"""Files of frames."""

import os

from . import _core


class Trajectory:
    """NAME.h5 of a run, frame by frame: `trajectory[n]` reads one, `for frame in trajectory` one after the other.

    As the file is now, of a run at work too; open it again to see later frames.
    Raises OSError for a file that is not there, damaged, or none of ours.
    """

    def __init__(self, path):
        self._core = _core.TrajectoryReader(os.fspath(path))

    def __len__(self):
        return len(self._core)

    def __getitem__(self, number):
        """Frame `number`, from 0; negative ones from the end."""
        count = len(self)
        if not -count <= number < count:
            raise IndexError(f"frame {number} is not there: there are {count}")
        return self._core.read(number % count)

    def __iter__(self):
        for number in range(len(self)):
            yield self[number]

    @property
    def times(self):
        """float64 (frames,) [s]."""
        return self._core.times

    @property
    def steps(self):
        """int64 (frames,)."""
        return self._core.steps

    @property
    def provenance(self):
        """Of the run that began the file, as texts."""
        return self._core.provenance

    def scalars(self, number):
        """The scalars of a frame by name."""
        return self._core.scalars(number)
