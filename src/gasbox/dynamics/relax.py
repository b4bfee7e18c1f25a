"""A start under forces: discs that overlap are moved apart, and a step that is too long is named."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
from numpy.typing import NDArray

from gasbox.dynamics.forced import Forced, ForcedSettings
from gasbox.geometry import Enclosure, Geometry
from gasbox.rng import Stream, generator
from gasbox.state import Contacts, State, Tallies

__all__ = ["relax", "step_warning"]

_TOO_STRONG = 500.0
"""Force, in units of strength/range, beyond which discs overlap: a Lennard-Jones pair at 0.81 sigma."""
_CALM = 100.0
"""Force down to which they are moved apart."""
_LARGEST_WAY = 0.03
"""Of the range: how far a disc is moved at once."""
_MOST_ROUNDS = 5000
_LONGEST = 0.2
"""Step times the frequency of a bound pair, beyond which a step is called long."""
_FASTEST = 0.15
"""Way of a fast disc (four times the thermal speed) in a step, in ranges, beyond which it is called long."""


def relax(
    state: State, geometry: Geometry, settings: ForcedSettings, strength: float, seed: int
) -> float | None:
    """Move discs apart along their forces until none is extreme; velocities stay.

    Parameters
    ----------
    strength : largest epsilon of all pairs [energy]
    seed : of the directions in which discs at one place part

    Returns
    -------
    The longest way [length]; None if nothing had to be done.
    """
    if not state.count or not settings.terms.law.size:
        return None
    unit = strength / settings.sigma
    start = state.position.copy()
    species, walls = int(state.species.max()) + 1, len(geometry.wall_names)
    # Weight presses, but it is no overlap.
    still = dataclasses.replace(geometry, gravity=(0.0, 0.0)) if isinstance(geometry, Enclosure) else geometry
    trial = Forced(
        state.copy(), still, _without_baths(settings), Tallies.zero(species, walls), Contacts.empty(0)
    )
    moved = False
    limit = _TOO_STRONG * unit
    for turn in range(_MOST_ROUNDS):
        force = trial.forces(state)
        size = np.hypot(*force.T)
        apart = _at_one_place(state, turn, seed) if turn < 10 else None
        wild = ~np.isfinite(size)
        if not wild.any() and size.max() <= limit and apart is None:
            break
        moved, limit = True, _CALM * unit
        way = (
            np.where(wild[:, None], 0.0, force)
            * (settings.sigma * _LARGEST_WAY / np.maximum(size, limit))[:, None]
        )
        noise = generator(seed, Stream.POSITIONS, 1 + turn).normal(size=(int(wild.sum()), 2))
        way[wild] = noise * _LARGEST_WAY * settings.sigma
        if apart is not None:
            way += apart * settings.sigma
        _move(geometry, state, way)
        trial.resync(state)
    if not moved:
        return None
    gap = state.position - start
    box = np.where(geometry.periodic, geometry.size, np.inf)
    gap -= np.where(
        geometry.periodic, np.round(gap / box) * np.where(geometry.periodic, geometry.size, 0.0), 0.0
    )
    return float(np.hypot(*gap.T).max())


def _without_baths(settings: ForcedSettings) -> ForcedSettings:
    return ForcedSettings(settings.time_step, settings.terms, settings.sigma, settings.wall_strength)


def _at_one_place(state: State, turn: int, seed: int) -> NDArray[np.float64] | None:
    """Small random ways for discs that stand at exactly the same place; None if none do."""
    _, place, count = np.unique(state.position, axis=0, return_inverse=True, return_counts=True)
    same = count[place.ravel()] > 1
    if not same.any():
        return None
    noise = generator(seed, Stream.POSITIONS, 1 + turn).normal(size=state.position.shape)
    way: NDArray[np.float64] = np.where(same[:, None], noise * _LARGEST_WAY, 0.0)
    return way


def _move(geometry: Geometry, state: State, way: NDArray[np.float64]) -> None:
    """Move discs; one that would leave goes along x or y alone, if it can, so that it slides along a wall."""
    waiting = np.ones(state.count, np.bool_)
    for part in ((1.0, 1.0), (1.0, 0.0), (0.0, 1.0)):
        position = geometry.wrap(state.position + way * part)
        goes = waiting & geometry.holds(position, state.radius)
        state.position[goes] = position[goes]
        waiting &= ~goes


def step_warning(state: State, settings: ForcedSettings, strength: float) -> str | None:
    """A sentence if the time step is long for the stiffness of a bound pair, or for the speed of the discs."""
    if not state.count:
        return None
    mass = float(state.mass.min())
    frequency = math.sqrt(114.0 * strength / mass) / settings.sigma
    thermal = math.sqrt(float(np.mean(np.sum(state.velocity**2, axis=1))) / 2.0)
    longest = min(
        _LONGEST / frequency if frequency > 0.0 else math.inf,
        _FASTEST * settings.sigma / (4.0 * thermal) if thermal > 0.0 else math.inf,
    )
    if settings.time_step <= longest:
        return None
    return (
        f"dynamics.time_step {settings.time_step:g} is long for these forces and speeds: energy will drift or the run "
        f"will stop; up to {longest:.2g} is safe"
    )
