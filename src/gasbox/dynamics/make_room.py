"""Room under forces for particles that were put elsewhere in the middle of a run, or have become others."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.dynamics.forced import Forced
from gasbox.dynamics.relax import move, random_ways
from gasbox.geometry import Geometry
from gasbox.state import State

__all__ = ["make_room"]

_CALM = 60.0
"""Force, in units of strength/range, down to which they are moved apart: a Lennard-Jones pair at 0.95 sigma."""
_LARGEST_WAY = 0.05
"""Of the range: how far a disc is moved at once."""
_MOST_ROUNDS = 500
_NEAR = 1.5
"""Who is so near to one that must move, in units of the sum of their radii or of the range, may have to give way."""


def make_room(
    dynamics: Forced, state: State, geometry: Geometry, moved: NDArray[np.bool_], seed: int
) -> None:
    """Move those particles, and whoever they press on, apart along their forces until none of these is extreme.

    All others stay where they are, and all keep their velocities. The dynamics has taken over the state.

    Parameters
    ----------
    geometry : with its walls where they are now
    moved : (n,) bool, who was put elsewhere or has become another
    seed : of the directions in which discs at one place part
    """
    settings = dynamics.settings
    limit = _CALM * settings.strength / settings.sigma
    if not state.count or not settings.terms.law.size or limit == 0.0:
        return
    pressed = moved.copy()
    weight = state.mass[:, None] * np.where(geometry.periodic, 0.0, geometry.gravity)
    for turn in range(_MOST_ROUNDS):
        force, torque = dynamics.forces_and_torques(state)
        size = np.hypot(*(force - weight).T) + np.abs(torque) / state.radius
        at_one_place = _at_one_place(state, pressed)
        wild = ~np.isfinite(size) | at_one_place
        extreme = wild | (size > limit)
        going = extreme & pressed
        if not going.any():
            return
        pressed |= extreme & _near(state, geometry, going, settings.sigma)
        going = extreme & pressed
        scale = np.where(going & ~wild, settings.sigma * _LARGEST_WAY / np.maximum(size, limit), 0.0)
        way = np.where(wild[:, None], 0.0, force) * scale[:, None]
        way[going & wild] = random_ways(seed, turn, int((going & wild).sum()), _LARGEST_WAY * settings.sigma)
        move(geometry, state, way, np.where(wild, 0.0, torque) * scale / state.radius**2)
        dynamics.resync(state)


def _gaps(state: State, geometry: Geometry, row: int) -> NDArray[np.float64]:
    """(n,) float64: distances of all centres from that of one, by the nearest image."""
    gap = state.position - state.position[row]
    size = np.where(geometry.periodic, geometry.size, np.inf)
    gap -= np.where(
        geometry.periodic, np.rint(gap / size) * np.where(geometry.periodic, geometry.size, 0.0), 0.0
    )
    found: NDArray[np.float64] = np.hypot(*gap.T)
    return found


def _near(state: State, geometry: Geometry, going: NDArray[np.bool_], sigma: float) -> NDArray[np.bool_]:
    """(n,) bool: who is near to one of those."""
    near = going.copy()
    for row in np.flatnonzero(going):
        reach = _NEAR * np.maximum(state.radius + state.radius[row], sigma)
        near |= _gaps(state, geometry, int(row)) < reach
    return near


def _at_one_place(state: State, pressed: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """(n,) bool: those of `pressed` that stand exactly where another does: no force parts them."""
    _, place, count = np.unique(state.position, axis=0, return_inverse=True, return_counts=True)
    found: NDArray[np.bool_] = pressed & (count[place.ravel()] > 1)
    return found
