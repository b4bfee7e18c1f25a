"""Places discs without overlap: insertion at random places, and shaking of a dense start.

Random numbers come in as arrays, so that the same ones give the same bits with and without the JIT.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import kernel
from gasbox.kernels.barriers import Barriers, is_clear
from gasbox.kernels.size_grid import SizeGrid, overlaps_any, put, take

__all__ = ["free_places", "insert", "insert_between", "shake"]


@kernel
def insert(
    grid: SizeGrid,
    position: NDArray[np.float64],
    radius: NDArray[np.float64],
    order: NDArray[np.int64],
    low: NDArray[np.float64],
    high: NDArray[np.float64],
    uniform: NDArray[np.float64],
) -> int:
    """Random sequential insertion: each disc of `order` in turn tries places until one is free.

    Parameters
    ----------
    grid : holds all discs that are in place already; the new ones are entered
    position : (n, 2) float64 [length], filled in place
    radius : (n,) float64 [length]
    order : (m,) int64, which discs, in this order
    low, high : (n, 2) float64 [length], bounds of the centre of each disc
    uniform : (tries, 2) float64 in [0, 1)

    Returns
    -------
    Number of discs placed.

    Source
    ------
    J. Feder, J. Theor. Biol. 87, 237 (1980), https://doi.org/10.1016/0022-5193(80)90358-6
    """
    placed = 0
    for attempt in range(uniform.shape[0]):
        if placed == order.shape[0]:
            break
        i = order[placed]
        x = min(low[i, 0] + uniform[attempt, 0] * (high[i, 0] - low[i, 0]), high[i, 0])
        y = min(low[i, 1] + uniform[attempt, 1] * (high[i, 1] - low[i, 1]), high[i, 1])
        if not overlaps_any(grid, position, radius, i, x, y, radius[i]):
            position[i, 0] = x
            position[i, 1] = y
            put(grid, i, x, y)
            placed += 1
    return placed


@kernel
def insert_between(
    walls: Barriers,
    grid: SizeGrid,
    position: NDArray[np.float64],
    radius: NDArray[np.float64],
    order: NDArray[np.int64],
    reach: NDArray[np.float64],
    places: NDArray[np.float64],
) -> int:
    """As `insert`, but between walls of any shape, at given places.

    Parameters
    ----------
    reach : (n,) float64 [length], how far from walls the centre of each disc stays
    places : (tries, 2) float64 [length], within the bounds of the discs

    Returns
    -------
    Number of discs placed.
    """
    placed = 0
    for attempt in range(places.shape[0]):
        if placed == order.shape[0]:
            break
        i = order[placed]
        x, y = places[attempt, 0], places[attempt, 1]
        if not is_clear(walls, x, y, reach[i]):
            continue
        if not overlaps_any(grid, position, radius, i, x, y, radius[i]):
            position[i, 0] = x
            position[i, 1] = y
            put(grid, i, x, y)
            placed += 1
    return placed


@kernel
def free_places(
    grid: SizeGrid,
    position: NDArray[np.float64],
    radius: NDArray[np.float64],
    places: NDArray[np.float64],
    r: float,
) -> NDArray[np.bool_]:
    """Which of `places` (m, 2) [length] have room for a disc of radius `r` [length] beside those of the grid."""
    free = np.empty(places.shape[0], np.bool_)
    for number in range(places.shape[0]):
        free[number] = not overlaps_any(grid, position, radius, -1, places[number, 0], places[number, 1], r)
    return free


@kernel
def shake(
    grid: SizeGrid,
    position: NDArray[np.float64],
    radius: NDArray[np.float64],
    order: NDArray[np.int64],
    low: NDArray[np.float64],
    high: NDArray[np.float64],
    step: float,
    uniform: NDArray[np.float64],
) -> int:
    """One Monte-Carlo sweep of hard discs: each disc of `order` tries one small move and makes it if it is free.

    Parameters
    ----------
    step : longest move along each axis [length]
    uniform : (m, 2) float64 in [0, 1), one row for each disc of `order`

    Returns
    -------
    Number of moves made.

    Precondition
    ------------
    Nothing overlaps, and a periodic direction reaches from 0 to the whole side in `low` and `high`.

    Source
    ------
    N. Metropolis et al., J. Chem. Phys. 21, 1087 (1953), https://doi.org/10.1063/1.1699114
    """
    moves = 0
    for number in range(order.shape[0]):
        i = order[number]
        x = position[i, 0] + step * (2.0 * uniform[number, 0] - 1.0)
        y = position[i, 1] + step * (2.0 * uniform[number, 1] - 1.0)
        # Out of bounds: stay, also in a periodic direction; that costs a few moves and no exactness.
        if x < low[i, 0] or x > high[i, 0] or y < low[i, 1] or y > high[i, 1]:
            continue
        if not overlaps_any(grid, position, radius, i, x, y, radius[i]):
            take(grid, i, position[i, 0], position[i, 1])
            position[i, 0] = x
            position[i, 1] = y
            put(grid, i, x, y)
            moves += 1
    return moves
