"""The time-dependent elements of a recording: groups of `step`, `time` and `value`, as H5MD wants them."""

from __future__ import annotations

from collections.abc import Mapping

import h5py
import numpy as np
from numpy.typing import ArrayLike

from gasbox.recording.column import Column

__all__ = ["Elements"]


class Elements:
    """Elements that are sampled together: each has its own values, and all share one `step` and one `time`.

    Parameters
    ----------
    file : where the groups are made
    optional : beginnings of the paths of arrays that need not be in each sample
    """

    def __init__(self, file: h5py.File, optional: tuple[str, ...] = ()) -> None:
        self._file = file
        self._optional = optional
        self._taken = 0
        self._step: Column | None = None
        self._time: Column | None = None
        self._values: dict[str, Column] = {}

    @property
    def waiting(self) -> int:
        """Number of samples that are not in the file yet."""
        return 0 if self._step is None else self._step.waiting

    @property
    def waiting_bytes(self) -> int:
        """Size [byte] of what is not in the file yet."""
        return sum(column.waiting_bytes for column in self._values.values())

    def append(
        self,
        step: int,
        time: float,
        values: Mapping[str, ArrayLike],
        fills: Mapping[str, float],
        units: Mapping[str, str],
    ) -> None:
        """One more sample of all elements.

        Parameters
        ----------
        values : path of the element -> its value; the same paths each time, but for optional ones
        fills : path -> what stands where a row is shorter than others; 0 where nothing is said
        units : path -> unit, for readers

        Raises
        ------
        ValueError
            Other paths, shapes or types than those of the first sample.
        """
        different = values.keys() ^ self._values.keys()
        wrong = [path for path in different if self._taken and not path.startswith(self._optional)]
        if wrong:
            raise ValueError(f"not in every frame: {', '.join(sorted(wrong))}")
        for path, value in values.items():
            if path not in self._values:
                self._make(path, value, fills.get(path, 0), units.get(path, ""))
                self._values[path].skip(self._taken)
        assert self._step is not None
        assert self._time is not None
        for path, column in self._values.items():
            if path in values:
                column.append(values[path])
            else:
                column.append_nothing()
        self._taken += 1
        self._step.append(np.int64(step))
        self._time.append(np.float64(time))

    def write(self) -> None:
        """Append all waiting samples to the file."""
        for column in (*self._values.values(), self._time, self._step):
            if column is not None:
                column.write()

    def _make(self, path: str, value: ArrayLike, fill: float, unit: str) -> None:
        group = self._file.require_group(path)
        if self._step is None or self._time is None:
            self._step = Column(group, "step", np.int64(0))
            self._time = Column(group, "time", np.float64(0))
        else:
            group["step"] = self._step.dataset
            group["time"] = self._time.dataset
        column = self._values[path] = Column(group, "value", value, fill)
        if unit:
            column.dataset.attrs["unit"] = unit
