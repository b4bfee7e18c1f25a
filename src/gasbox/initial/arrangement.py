"""Regular arrangements of places: which rows and columns hold enough discs of one size in a rectangle."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["Arrangement", "Patch", "arrangements", "most_places"]

_ROUNDING = 1e-12


@dataclass(frozen=True)
class Patch:
    """A rectangle for centres of discs.

    Attributes
    ----------
    left, bottom, width, height : [length], what centres can reach
    periodic_x, periodic_y : whether it joins up with itself
    """

    left: float
    bottom: float
    width: float
    height: float
    periodic_x: bool
    periodic_y: bool

    def turned(self) -> Patch:
        """The same with x and y exchanged."""
        return Patch(self.bottom, self.left, self.height, self.width, self.periodic_y, self.periodic_x)


@dataclass(frozen=True)
class Arrangement:
    """Rows of equally spaced places, stretched to fill a patch.

    Attributes
    ----------
    patch : where; already turned if `turned`
    rows : number of rows
    columns : places in the first row
    fewer : places that every second row has less (0 or 1)
    pitch : distance of neighbours in a row [length]
    shift : how far each row is shifted against the one before [length]
    swinging : whether the shift goes forth and back, or always forth
    gap : least distance of two places [length]
    turned : whether rows run along y
    """

    patch: Patch
    rows: int
    columns: int
    fewer: int
    pitch: float
    shift: float
    swinging: bool
    gap: float
    turned: bool

    @property
    def places(self) -> int:
        """Number of places."""
        return self.rows * self.columns - self.fewer * (self.rows // 2)

    def positions(self) -> NDArray[np.float64]:
        """All places, (places, 2) [length]."""
        row, column = np.divmod(np.arange(self.rows * self.columns), self.columns)
        kept = ~((self.fewer == 1) & (row % 2 == 1) & (column == self.columns - 1))
        row, column = row[kept], column[kept]
        x = column * self.pitch + (row % 2 if self.swinging else row) * self.shift
        if self.patch.periodic_x:
            x %= self.patch.width
        y = row * _row_height(self.patch, self.rows)
        x = np.minimum(self.patch.left + x, self.patch.left + self.patch.width)
        y = np.minimum(self.patch.bottom + y, self.patch.bottom + self.patch.height)
        return np.stack([y, x] if self.turned else [x, y], axis=1)


def arrangements(patch: Patch, places: int, diameter: float) -> list[Arrangement]:
    """Every kind of arrangement that has room for so many discs of one diameter, the loosest first."""
    fitting = [
        arrangement
        for turned in (False, True)
        for arrangement in _with_places(patch.turned() if turned else patch, places, diameter, turned)
        if arrangement.gap >= diameter * (1 - _ROUNDING)
    ]
    return sorted(fitting, key=lambda arrangement: -arrangement.gap)


def most_places(patch: Patch, diameter: float) -> int:
    """Number of discs of one diameter that the best arrangement holds; 0 if none fits."""
    low, high = 0, 2 + 2 * int((patch.width + diameter) * (patch.height + diameter) / diameter**2)
    while low < high:
        middle = (low + high + 1) // 2
        if arrangements(patch, middle, diameter):
            low = middle
        else:
            high = middle - 1
    return low


def _row_height(patch: Patch, rows: int) -> float:
    if patch.periodic_y:
        return patch.height / rows
    return patch.height / max(rows - 1, 1)


def _with_places(patch: Patch, places: int, diameter: float, turned: bool) -> Iterator[Arrangement]:
    """For each number of rows the arrangements with just enough columns."""
    # Rows closer than a diameter are staggered; of three rows, the outer two are at least a diameter apart.
    most_rows = min(places, 2 * int(patch.height / diameter) + 3)
    rows = np.arange(1, most_rows + 1)
    height = patch.height / (rows if patch.periodic_y else np.maximum(rows - 1, 1))
    for fewer, shifted in ((0, False), (0, True), (1, True)):
        columns = -(-(places + fewer * (rows // 2)) // rows)
        pitch, shift, allowed = _spacing(patch, rows, columns, fewer, shifted)
        allowed &= columns > fewer
        swinging = not (patch.periodic_x and patch.periodic_y and shifted)
        gap = _least_distance(patch, rows, columns, pitch, shift, height)
        best = np.where(allowed & (gap >= diameter * (1 - _ROUNDING)), gap, -1.0)
        for n in np.argsort(-best, kind="stable")[:3]:
            if best[n] > 0:
                yield Arrangement(
                    patch,
                    int(rows[n]),
                    int(columns[n]),
                    fewer,
                    float(pitch[n]),
                    float(shift[n]),
                    swinging,
                    float(gap[n]),
                    turned,
                )


def _spacing(
    patch: Patch, rows: NDArray[np.int64], columns: NDArray[np.int64], fewer: int, shifted: bool
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.bool_]]:
    """Pitch and shift [length] of the rows, and where such rows fit together."""
    everywhere = np.ones(rows.shape[0], np.bool_)
    if patch.periodic_x:
        pitch = patch.width / columns
        if not shifted:
            return pitch, np.zeros_like(pitch), everywhere & (fewer == 0)
        # Round a period of an odd number of rows, the shift has to be a little less than half a pitch.
        odd = (rows % 2 == 1) & patch.periodic_y
        shift = np.where(odd, pitch * (rows - 1) / (2 * rows), pitch / 2)
        return pitch, shift, everywhere & (fewer == 0)
    if not shifted:
        return patch.width / np.maximum(columns - 1, 1), np.zeros(rows.shape[0]), everywhere
    spaces = np.maximum(columns - 1 if fewer else columns - 0.5, 0.5)
    pitch = patch.width / spaces
    return pitch, pitch / 2, everywhere & ~(patch.periodic_y & (rows % 2 == 1))


def _least_distance(
    patch: Patch,
    rows: NDArray[np.int64],
    columns: NDArray[np.int64],
    pitch: NDArray[np.float64],
    shift: NDArray[np.float64],
    height: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Least distance [length] of two places."""
    infinite = math.inf
    in_row = np.where((columns > 1) | patch.periodic_x, pitch, infinite)
    sideways = np.minimum(shift, np.where(in_row == infinite, infinite, pitch - shift))
    to_next = np.where(rows > 1, np.hypot(sideways, height), infinite)
    to_second = np.where(rows > 2, 2 * height, infinite)
    if patch.periodic_y:
        to_next = np.where(rows == 1, height, to_next)
        to_second = np.where(rows == 2, 2 * height, to_second)
    return np.minimum(in_row, np.minimum(to_next, to_second))
