"""A dense start of discs of one size: a lattice with vacancies, shaken."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.initial.arrangement import arrangements
from gasbox.initial.room import Room
from gasbox.kernels.placement import free_places, shake

__all__ = ["place_on_lattice"]

_MOVES: Final = 16_000_000
"""About so many moves are tried in all, but at least `_LEAST_SWEEPS` and at most `_MOST_SWEEPS` for each disc."""
_LEAST_SWEEPS: Final = 8
_MOST_SWEEPS: Final = 200
_TRIES: Final = 8


def place_on_lattice(room: Room, discs: NDArray[np.int64], random: np.random.Generator) -> bool:
    """Place `discs` (m,), all of one radius and with the same bounds; False if no arrangement has room for them."""
    patch = room.patch(int(discs[0]))
    radius = float(room.radius[discs[0]])
    wanted = discs.size
    for _ in range(_TRIES):
        fitting = arrangements(patch, wanted, 2 * radius)
        if not fitting:
            return False
        places = fitting[0].positions()
        if room.placed.any():
            places = places[free_places(room.grid, room.position, room.radius, places, radius)]
        if places.shape[0] >= discs.size:
            chosen = np.sort(random.permutation(places.shape[0])[: discs.size])
            room.enter(discs, places[chosen])
            _loosen(room, discs, fitting[0].gap - 2 * radius, random)
            return True
        # Other discs stand in the way of some places: ask for so many more.
        wanted += discs.size - places.shape[0]
    return False


def _loosen(room: Room, discs: NDArray[np.int64], slack: float, random: np.random.Generator) -> None:
    """Monte-Carlo sweeps, which wash out the lattice where there is room and keep what does not overlap."""
    radius = float(room.radius[discs[0]])
    step = min(max(slack, 0.1 * radius), radius)
    sweeps = min(max(_MOVES // discs.size, _LEAST_SWEEPS), _MOST_SWEEPS)
    for _ in range(sweeps):
        uniform = random.random((discs.size, 2))
        shake(room.grid, room.position, room.radius, discs, room.low, room.high, step, uniform)
