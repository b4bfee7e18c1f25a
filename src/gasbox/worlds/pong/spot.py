"""Where a ball can be put: as near to the middle as there is room."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.state import State
from gasbox.worlds.pong.table import Table

__all__ = ["free_spot"]

_TURN = math.pi * (3.0 - math.sqrt(5.0))
"""Golden angle: places at it, one after the other, lie evenly."""
_PLACES = 400
_PITCH = 0.35
"""Between neighbouring places, in radii of the ball."""


def free_spot(table: Table, state: State, row: int) -> NDArray[np.float64]:
    """(2,) [length]: nearest to the middle, where the ball, in this row, touches nobody; the emptiest if none."""
    number = np.arange(_PLACES)
    away = _PITCH * table.radius * np.sqrt(number)
    places = np.array(table.center) + away[:, None] * np.stack(
        [np.cos(_TURN * number), np.sin(_TURN * number)], axis=1
    )
    places[:, 1] = np.clip(places[:, 1], table.bottom, table.top)
    others = np.arange(state.count) != row
    if not others.any():
        return np.array(places[0])
    gap = np.hypot(*(places[:, None] - state.position[others]).transpose(2, 0, 1)) - state.radius[others]
    room = gap.min(axis=1) - table.radius
    free = np.flatnonzero(room > 0.0)
    return np.array(places[free[0] if free.size else int(room.argmax())])
