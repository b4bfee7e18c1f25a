"""A dense start of molecules of one kind: rows and columns, all turned one way, then shaken."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry.discs import extents, support
from gasbox.initial.bodies import Draw, Filling
from gasbox.kernels.molecules.placing import insert_bodies, shake_bodies

__all__ = ["most_in_rows", "place_in_rows"]

_SWEEPS: Final = 200
_STEP: Final = 0.1
"""Of the radius of the largest disc."""
_ROUNDING: Final = 1e-12
_QUARTERS: Final[NDArray[np.float64]] = np.arange(4, dtype=np.float64) * (math.pi / 2)


@dataclass(frozen=True)
class _Rows:
    """Places of molecules that are all turned by one angle."""

    angle: float
    places: NDArray[np.float64]


def place_in_rows(room: Filling, rows: NDArray[np.int64], draw: Draw) -> bool:
    """Place particles `rows` (m,), all of one kind, beside those that have their places; False if not all have room."""
    kind = int(room.kind[rows[0]])
    best = _densest(room, kind)
    order = draw.shuffled(np.arange(len(best.places)))
    drawn = np.column_stack([best.places[order], np.full(len(order), best.angle)])
    if insert_bodies(room.bodies, room.grid, room.walls, rows, 1.0, drawn) < rows.size:
        return False
    step = np.full(room.kind.size, _STEP * float(room.kinds[kind].radii.max()))
    for _ in range(_SWEEPS):
        draws = draw.uniform(rows.size)
        shake_bodies(
            room.bodies, room.grid, room.walls, rows, step, step / room.kinds[kind].radius, 0.0, draws
        )
    return True


def most_in_rows(room: Filling, kind: int) -> int:
    """How many molecules of a kind find room in rows, where nothing else stands."""
    return len(_densest(room, kind).places)


def _densest(room: Filling, kind: int) -> _Rows:
    found = room.kinds[kind]
    radii = room.bodies.full[room.bodies.first[int(np.argmax(room.kind == kind))] :][: len(found.sites)]
    turn, width, height = extents(found.place, radii).T
    slim = float(turn[int((width * height).argmin())])
    return max(
        (_Rows(angle, _places(room, kind, radii, angle)) for angle in (slim, slim + math.pi / 2)),
        key=lambda rows: len(rows.places),
    )


def _places(room: Filling, kind: int, radii: NDArray[np.float64], angle: float) -> NDArray[np.float64]:
    """Places (k, 2) [length] of centres of mass, as far from each other as the box allows."""
    found, geometry = room.kinds[kind], room.geometry
    apart = support(found.place, radii, np.subtract(_QUARTERS, angle))
    kept = support(found.place, found.radii, np.subtract(_QUARTERS, angle))
    (left, lower), (right, upper) = room.box(kind)
    x = _along(
        left, right, kept[2], kept[0], apart[0] + apart[2], bool(geometry.periodic[0]), geometry.size[0]
    )
    y = _along(
        lower, upper, kept[3], kept[1], apart[1] + apart[3], bool(geometry.periodic[1]), geometry.size[1]
    )
    return np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)


def _along(
    low: float, high: float, before: float, after: float, pitch: float, periodic: bool, length: float
) -> NDArray[np.float64]:
    """Coordinates [length] of columns between two ends, or once round a period."""
    if periodic and high - low == length:
        count = int(length / pitch * (1 + _ROUNDING))
        return np.asarray(low + (np.arange(count) + 0.5) * length / max(count, 1))
    room = high - low - before - after
    if room < -_ROUNDING * length:
        return np.zeros(0)
    count = int(max(room, 0.0) / pitch * (1 + _ROUNDING)) + 1
    return np.linspace(low + before, max(high - after, low + before), count)
