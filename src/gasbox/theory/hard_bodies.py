"""Dilute gases of hard molecules: excluded area, second virial coefficient, pressure, and the adiabat with it.

Two hard bodies exclude each other from an area: that of all places of one centre, with the other at the origin, at
which they overlap. B_2 is half of its mean over all angles. For convex bodies the mean is A_1 + A_2 + P_1 P_2/(2 pi),
with areas A and perimeters P, so that B_2 = A + P²/(4 pi) for equal ones. Discs that stick together need not be convex:
for them the area is that of a union of circles, exactly, and the mean is a sum over angles.

Sources: T. Boublik, Mol. Phys. 29, 421 (1975), for convex bodies in two dimensions; L. A. Santalo, Integral Geometry
and Geometric Probability (1976), chapter 7.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gasbox.theory.real import Real

__all__ = [
    "body_area",
    "convex_second_virial",
    "dilute_pressure",
    "dilute_temperature",
    "excluded_area",
    "second_virial",
    "stadium",
    "union_area",
]

_ANGLES: Final = 360
_ROUNDING: Final = 1e-12


def convex_second_virial(area: float, perimeter: float) -> float:
    """B_2 = A + P²/(4 pi) of equal hard convex bodies [length²]."""
    return area + perimeter**2 / (4.0 * math.pi)


def stadium(radius: float, length: float) -> tuple[float, float]:
    """Area and perimeter of a rod with round ends: the convex hull of two discs whose centres are `length` apart."""
    return math.pi * radius**2 + 2.0 * radius * length, 2.0 * math.pi * radius + 2.0 * length


def body_area(radius: ArrayLike, place: ArrayLike) -> float:
    """Area that the discs of a molecule cover together [length²].

    Parameters
    ----------
    radius : (k,) [length]
    place : (k, 2) [length]
    """
    return union_area(np.asarray(place, np.float64), np.asarray(radius, np.float64))


def excluded_area(
    radius: ArrayLike,
    place: ArrayLike,
    other_radius: ArrayLike,
    other_place: ArrayLike,
    angles: int = _ANGLES,
) -> float:
    """Mean over all angles of the area from which one molecule keeps the centre of another [length²].

    Parameters
    ----------
    radius, other_radius : (k,), (l,) of their discs [length]
    place, other_place : (k, 2), (l, 2) of these, each in its own frame [length]
    angles : at how many it is taken; the error falls with their cube or faster
    """
    reach = np.asarray(radius, np.float64)[:, None] + np.asarray(other_radius, np.float64)
    here, there = np.asarray(place, np.float64), np.asarray(other_place, np.float64)
    total = 0.0
    for angle in 2.0 * math.pi * (np.arange(angles) + 0.5) / angles:
        cos, sin = math.cos(angle), math.sin(angle)
        turned = there @ np.array([[cos, sin], [-sin, cos]])
        total += union_area((here[:, None] - turned).reshape(-1, 2), reach.ravel())
    return total / angles


def second_virial(radius: ArrayLike, place: ArrayLike, angles: int = _ANGLES) -> float:
    """B_2 of equal hard molecules [length²]: half of what they exclude; as `excluded_area`."""
    return 0.5 * excluded_area(radius, place, radius, place, angles)


def dilute_pressure(counts: ArrayLike, second: ArrayLike, area: float, temperature: float) -> float:
    """T (N/A + sum B_ij N_i N_j/A²) [mass/time²].

    Parameters
    ----------
    counts : (kinds,) how many there are
    second : (kinds, kinds) B_2 of each pair [length²]; of one kind a number will do
    """
    density = np.atleast_1d(np.asarray(counts, np.float64)) / area
    pairs = np.asarray(second, np.float64).reshape(density.size, density.size)
    return temperature * float(np.sum(density) + density @ pairs @ density)


def dilute_temperature(
    new_area: Real, temperature: float, count: float, second: float, area: float, freedom: float = 3.0
) -> Real:
    """T' after a slow change of area without heat, with P = (N T/A) (1 + B_2 N/A) [energy].

    ln(T'/T) = (2/f) (ln(A/A') + B_2 N (1/A' - 1/A)). With walls, areas are those that centres can reach.

    Parameters
    ----------
    new_area, area : A' and A [length²]
    second : B_2 [length²]
    freedom : f of one molecule
    """
    compression = np.log(area / new_area) + second * count * (1.0 / new_area - 1.0 / area)
    new: Real = temperature * np.exp(2.0 / freedom * compression)
    return new


def union_area(centers: NDArray[np.float64], radii: NDArray[np.float64]) -> float:
    """Area covered by some discs together [length²], by the rim that none of the others covers (Green's theorem).

    Parameters
    ----------
    centers : (k, 2) [length]
    radii : (k,) [length]
    """
    centers, radii = _without_hidden(centers, radii)
    area = 0.0
    for number, (center, radius) in enumerate(zip(centers, radii, strict=True)):
        others = np.arange(radii.size) != number
        for begin, end in _bare_arcs(center, radius, centers[others], radii[others]):
            across = math.sin(end) - math.sin(begin), math.cos(end) - math.cos(begin)
            area += 0.5 * radius * (radius * (end - begin) + center[0] * across[0] - center[1] * across[1])
    return float(area)


def _without_hidden(
    centers: NDArray[np.float64], radii: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Leave out discs that lie within another one; of equal ones the first stays."""
    apart = np.hypot(*(centers[:, None] - centers).transpose(2, 0, 1))
    slack = _ROUNDING * float(np.max(radii))
    inside = apart + radii[:, None] <= radii + slack
    both = inside & inside.T
    order = np.arange(radii.size)
    hidden = np.any(inside & (~both | (order < order[:, None])), axis=1)
    return centers[~hidden], radii[~hidden]


def _bare_arcs(
    center: NDArray[np.float64], radius: float, centers: NDArray[np.float64], radii: NDArray[np.float64]
) -> list[tuple[float, float]]:
    """Parts of a rim that lie in none of the other discs: pairs of angles, of which the second is the greater."""
    way = centers - center
    apart = np.hypot(way[:, 0], way[:, 1])
    meets = (apart < radius + radii) & (apart > np.abs(radius - radii))
    way, apart, radii = way[meets], apart[meets], radii[meets]
    half = np.arccos(np.clip((radius**2 + apart**2 - radii**2) / (2.0 * radius * apart), -1.0, 1.0))
    begin = np.mod(np.arctan2(way[:, 1], way[:, 0]) - half, 2.0 * math.pi)
    covered = sorted(zip(begin.tolist(), (begin + 2.0 * half).tolist(), strict=True))
    if not covered:
        return [(0.0, 2.0 * math.pi)]
    # What reaches beyond a full turn covers the first part of the rim.
    reached = max(0.0, max(end for _, end in covered) - 2.0 * math.pi)
    bare = []
    for first, last in covered:
        if first > reached:
            bare.append((reached, first))
        reached = max(reached, last)
    if reached < 2.0 * math.pi:
        bare.append((reached, 2.0 * math.pi))
    return bare
