"""One growing dataset of a recording: a row for each sample, buffered and appended in blocks."""

from __future__ import annotations

from typing import Any, Final

import h5py
import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Column"]

_CHUNK_BYTES: Final = 2**18
_CHUNK_FRAMES: Final = 256
_CHUNK_PARTICLES: Final = 2**16


class Column:
    """A growing dataset of arrays, one a row; shorter rows are padded with a fill value.

    Rows wait in memory until `write`: HDF5 is fast with blocks and slow with single small rows.

    Parameters
    ----------
    group : where the dataset is made
    name : its name
    example : an array of the shape and type of one row; only the first axis may vary between rows
    fill : what stands where a shorter row has no value
    """

    def __init__(self, group: h5py.Group, name: str, example: ArrayLike, fill: float = 0) -> None:
        row = np.asarray(example)
        self._fill = fill
        self._rows: list[NDArray[Any]] = []
        self._written = 0
        self.dataset = group.create_dataset(
            name,
            shape=(0, *row.shape),
            maxshape=(None, *(None for _ in row.shape[:1]), *row.shape[1:]),
            chunks=_chunk(row),
            dtype=row.dtype,
            fillvalue=fill,
        )

    @property
    def waiting(self) -> int:
        """Number of rows that are not in the file yet."""
        return len(self._rows)

    @property
    def waiting_bytes(self) -> int:
        """Size [byte] of the rows that are not in the file yet."""
        return sum(row.nbytes for row in self._rows)

    def append(self, row: ArrayLike) -> None:
        """Take a copy of one more row.

        Raises
        ------
        ValueError
            Shape or type is not that of the first row.
        """
        array = np.array(row)
        shape = self.dataset.shape[1:]
        if array.ndim != len(shape) or array.shape[1:] != shape[1:] or array.dtype != self.dataset.dtype:
            found, expected = f"{array.dtype} {array.shape}", f"{self.dataset.dtype} {shape}"
            raise ValueError(f"{self.dataset.name}: a row {found} does not fit the first one, {expected}")
        self._rows.append(array)

    def append_nothing(self) -> None:
        """One more row, that only holds the fill value."""
        shape = self.dataset.shape[1:]
        self.append(np.full((0, *shape[1:]) if shape else (), self._fill, self.dataset.dtype))

    def skip(self, rows: int) -> None:
        """Begin after so many rows that only hold the fill value; before anything is appended."""
        self.dataset.resize((rows, *self.dataset.shape[1:]))
        self._written = rows

    def write(self) -> None:
        """Append all waiting rows to the file; if it is broken off, the next call does it again."""
        if not self._rows:
            return
        block, first = self._block(), self._written
        self.dataset.resize((first + len(block), *np.maximum(self.dataset.shape[1:], block.shape[1:])))
        self.dataset[(slice(first, None), *(slice(0, length) for length in block.shape[1:]))] = block
        self._rows, self._written = [], first + len(block)

    def _block(self) -> NDArray[Any]:
        if self._rows[0].ndim == 0 or len({row.shape[0] for row in self._rows}) == 1:
            return np.stack(self._rows)
        longest = max(row.shape[0] for row in self._rows)
        block = np.full((len(self._rows), longest, *self._rows[0].shape[1:]), self._fill, self.dataset.dtype)
        for padded, row in zip(block, self._rows, strict=True):
            padded[: row.shape[0]] = row
        return block


def _chunk(row: NDArray[Any]) -> tuple[int, ...]:
    """Chunks of many frames when frames are small, and of a part of one frame when they are large."""
    item = tuple(max(1, length) for length in row.shape)
    item = (*(min(length, _CHUNK_PARTICLES) for length in item[:1]), *item[1:])
    frames = _CHUNK_BYTES // (int(np.prod(item)) * row.dtype.itemsize)
    return (min(max(1, frames), _CHUNK_FRAMES), *item)
