"""Shapes made of discs: their area, and how far they reach."""

from __future__ import annotations

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

__all__ = ["extents", "fits_between", "support", "union_area"]

_TURNS: Final = 720
"""Directions that are looked at, beside those in which two discs lie side by side."""
_ROUNDING: Final = 1e-12


def support(
    place: NDArray[np.float64], radius: NDArray[np.float64], direction: NDArray[np.float64]
) -> NDArray[np.float64]:
    """How far discs reach from the origin along each direction (k,) [rad].

    Parameters
    ----------
    place : (m, 2) centres [length]
    radius : (m,) [length]
    """
    along = place[:, :1] * np.cos(direction) + place[:, 1:] * np.sin(direction)
    return np.asarray((along + radius[:, None]).max(axis=0))


def extents(place: NDArray[np.float64], radius: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rows (k, 3) of an angle [rad] by which discs may be turned, and their width and height [length] then.

    Among them are those at which the width is least: there two discs touch one side.
    """
    one, other = np.triu_indices(len(place), 1)
    flush = np.arctan2(*(place[other] - place[one]).T[::-1])
    quarters = np.arange(4)[:, None] * (math.pi / 2)
    turn = np.concatenate([np.arange(_TURNS) * (2.0 * math.pi / _TURNS), (quarters - flush).ravel()])
    width = support(place, radius, -turn) + support(place, radius, math.pi - turn)
    height = support(place, radius, math.pi / 2 - turn) + support(place, radius, -math.pi / 2 - turn)
    return np.stack([turn, width, height], axis=1)


def fits_between(
    place: NDArray[np.float64], radius: NDArray[np.float64], width: float, height: float
) -> bool:
    """Whether discs find room in a rectangle [length], turned as it suits; infinity for a side that is none."""
    _, wide, high = extents(place, radius).T
    return bool(np.any((wide <= width * (1 + _ROUNDING)) & (high <= height * (1 + _ROUNDING))))


def union_area(place: NDArray[np.float64], radius: NDArray[np.float64]) -> float:
    """Area [length²] of what discs cover together, those parts that several cover counted once.

    Exact: by Green's theorem along the arcs of the rim.

    Parameters
    ----------
    place : (m, 2) centres [length]
    radius : (m,) [length]
    """
    discs = np.unique(np.column_stack([place, radius]), axis=0)
    return float(sum(_along_rim(discs, number) for number in range(len(discs))))


def _along_rim(discs: NDArray[np.float64], number: int) -> float:
    """Half the integral of x dy - y dx along those arcs of one disc that no other covers."""
    x, y, r = discs[number]
    others = np.delete(discs, number, axis=0)
    distance = np.hypot(others[:, 0] - x, others[:, 1] - y)
    # Of two that cover each other, as rounding has it, the first one counts.
    first = np.arange(len(others)) < number
    if np.any((distance + r <= others[:, 2]) & (first | (others[:, 2] > r))):
        return 0.0
    near = (distance < r + others[:, 2]) & (distance + others[:, 2] > r)
    cosine = (distance[near] ** 2 + r**2 - others[near, 2] ** 2) / (2.0 * distance[near] * r)
    half = np.arccos(np.clip(cosine, -1.0, 1.0))
    middle = np.arctan2(others[near, 1] - y, others[near, 0] - x)
    begin = (middle - half) % (2.0 * math.pi)
    covered = [(b, b + 2.0 * h) for b, h in zip(begin.tolist(), half.tolist(), strict=True)]
    # What goes beyond a full turn covers the beginning as well.
    covered += [(b - 2.0 * math.pi, e - 2.0 * math.pi) for b, e in covered if e > 2.0 * math.pi]
    total, free = 0.0, 0.0
    for begins, ends in [*sorted(covered), (2.0 * math.pi, 2.0 * math.pi)]:
        if begins > free:
            total += _arc(x, y, r, free, min(begins, 2.0 * math.pi))
        free = max(free, ends)
    return 0.5 * total


def _arc(x: float, y: float, r: float, begin: float, end: float) -> float:
    return float(
        r * r * (end - begin)
        + r * x * (math.sin(end) - math.sin(begin))
        - r * y * (math.cos(end) - math.cos(begin))
    )
