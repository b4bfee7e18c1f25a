"""Dilute gases of molecules with forces between their sites: the second virial coefficient, by quadrature.

B_2 = -1/2 times the integral over the distance of the centres of the mean over both angles of exp(-u/T) - 1, u the sum
of all pairs of sites. Angles are taken at equal steps, which for a smooth periodic function is as exact as can be, and
distances by Gauss-Legendre.

Source: C. G. Gray and K. E. Gubbins, Theory of Molecular Fluids 1 (1984), chapter 6, in two dimensions.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["SiteEnergy", "pair_energy", "second_virial"]

SiteEnergy = Callable[[int, int, NDArray[np.float64]], NDArray[np.float64]]
"""Energy of site i of one molecule and site j of another at distances [length], the same shape [energy]."""

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(20)
_PANEL: Final = 0.1
"""Length of a panel, in units of the reach of the forces."""


def pair_energy(
    place: ArrayLike,
    other_place: ArrayLike,
    energy: SiteEnergy,
    distance: NDArray[np.float64],
    angle: NDArray[np.float64],
    other_angle: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Energy of two molecules, the other at (distance, 0) from the one [energy].

    Parameters
    ----------
    place, other_place : (k, 2), (l, 2) of their sites at angle 0, seen from the centre [length]
    distance, angle, other_angle : arrays that go together [length], [rad]
    """
    total = np.zeros(np.broadcast_shapes(distance.shape, angle.shape, other_angle.shape))
    cos, sin, other_cos, other_sin = np.cos(angle), np.sin(angle), np.cos(other_angle), np.sin(other_angle)
    for i, (x, y) in enumerate(np.asarray(place, np.float64)):
        for j, (a, b) in enumerate(np.asarray(other_place, np.float64)):
            along = distance + (other_cos * a - other_sin * b) - (cos * x - sin * y)
            across = (other_sin * a + other_cos * b) - (sin * x + cos * y)
            total += energy(i, j, np.hypot(along, across))
    return total


def second_virial(
    place: ArrayLike,
    other_place: ArrayLike,
    energy: SiteEnergy,
    reach: float,
    temperature: float,
    angles: int = 48,
) -> float:
    """B_2 [length²] of two kinds of rigid molecule, or of one with itself.

    Parameters
    ----------
    place, other_place : (k, 2), (l, 2) of their sites, seen from the centre of mass [length]
    energy : of each pair of sites; from `reach` on zero
    reach : of the forces between two sites [length]
    temperature : > 0 [energy]
    angles : steps of each of both angles
    """
    one, other = np.asarray(place, np.float64), np.asarray(other_place, np.float64)
    end = reach + float(np.max(np.hypot(*one.T))) + float(np.max(np.hypot(*other.T)))
    edges = np.linspace(0.0, end, math.ceil(end / (_PANEL * reach)) + 1)
    turn = 2.0 * math.pi * (np.arange(angles) + 0.5) / angles
    total = 0.0
    for low, high in itertools.pairwise(edges):
        half = 0.5 * (high - low)
        distance = low + half * (1.0 + _NODES)
        shown = distance[:, None, None], turn[:, None], turn[None, :]
        with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
            worth = pair_energy(one, other, energy, *shown)
        # Where attraction and repulsion are both infinite the cores overlap.
        worth = np.nan_to_num(worth, nan=np.inf, posinf=np.inf)
        mayer = np.mean(np.expm1(np.clip(-worth / temperature, -700.0, 700.0)), axis=(1, 2))
        total += float(np.sum(_WEIGHTS * half * distance * mayer))
    return -math.pi * total
