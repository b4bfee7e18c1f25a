"""How rigid molecules turn, and the discs they are made of, as kernels take them."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.state import State

__all__ = [
    "ANGLE",
    "ARM",
    "GRAZING",
    "INERTIA",
    "SITE_ARM",
    "SITE_RADIUS",
    "SITE_X",
    "SITE_Y",
    "TURNING",
    "Spin",
    "is_disc",
    "show_turns",
    "spin",
    "turn_to",
]

# Columns of `turn`: angle and angular velocity at the reference time, moment of inertia, and how far from the centre of
# mass the farthest centre of a disc is.
ANGLE, TURNING, INERTIA, ARM = range(4)
# Columns of `site`: place seen from the centre of mass at angle 0, radius, distance from the centre of mass.
SITE_X, SITE_Y, SITE_RADIUS, SITE_ARM = range(4)

GRAZING = 1e-12
"""Discs of molecules that approach slower than by this part of the speeds involved pass: rounding could not tell."""


class Spin(NamedTuple):
    """What molecules have and discs lack.

    Attributes
    ----------
    turn : (n, 4) float64, one row a particle, see the columns above
    first : (kinds + 1,) int32, kind a has the discs first[a] to first[a + 1]
    site : (discs, 4) float64, see the columns above
    """

    turn: NDArray[np.float64]
    first: NDArray[np.int32]
    site: NDArray[np.float64]


def spin(state: State, kinds: int) -> Spin | None:
    """The tables of a gas with so many kinds of particle; None if all of them are discs."""
    sites = state.sites
    if sites is None or sites.count == state.count:
        return None
    arm = np.hypot(*sites.place.T)
    rows = np.concatenate([sites.place, sites.radius[:, None], arm[:, None]], axis=1)
    found, first = [np.zeros((0, 4))], [0]
    for kind in range(kinds):
        members = np.flatnonzero(state.species == kind)
        if members.size:
            found.append(rows[sites.first[members[0]] : sites.first[members[0] + 1]])
        first.append(sum(map(len, found)))
    turn = np.zeros((state.count, 4))
    turn[:, ANGLE], turn[:, TURNING], turn[:, INERTIA] = state.angle, state.angular_velocity, state.inertia
    turn[:, ARM] = np.maximum.reduceat(arm, sites.first[:-1])
    return Spin(turn, np.array(first, np.int32), np.concatenate(found))


@inlined_kernel
def is_disc(spin: Spin, kind: int) -> bool:
    """Whether particles of this kind are single discs."""
    return spin.first[kind + 1] - spin.first[kind] == 1


@inlined_kernel
def turn_to(spin: Spin | None, i: int, elapsed: float) -> None:
    """Make the angle of particle i that of a time after its reference, within half a turn of 0."""
    if spin is not None:
        angle = spin.turn[i, ANGLE] + spin.turn[i, TURNING] * elapsed
        spin.turn[i, ANGLE] = angle - 2.0 * math.pi * np.rint(angle / (2.0 * math.pi))


@bare_kernel
def show_turns(
    spin: Spin,
    row: NDArray[np.int32],
    elapsed: NDArray[np.float64],
    angle: NDArray[np.float64],
    angular_velocity: NDArray[np.float64],
) -> None:
    """Write angles and angular velocities (n,) a time after the references into the public arrays.

    Parameters
    ----------
    row : (n,) of the public arrays, for each row of the table
    elapsed : (n,) [time]
    """
    for i in range(row.shape[0]):
        angle[row[i]] = spin.turn[i, ANGLE] + spin.turn[i, TURNING] * elapsed[i]
        angular_velocity[row[i]] = spin.turn[i, TURNING]
