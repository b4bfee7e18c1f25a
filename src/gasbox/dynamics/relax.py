"""A start under forces: discs that overlap are moved apart, and a step that is too long is named."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
from numpy.typing import NDArray

from gasbox.dynamics.forced import Forced, ForcedSettings
from gasbox.dynamics.forced_discs import has_molecules
from gasbox.dynamics.inner_tables import stiffest
from gasbox.geometry import Enclosure, Geometry
from gasbox.rng import Stream, generator
from gasbox.state import Contacts, State, Tallies

__all__ = ["move", "random_ways", "relax", "step_warning"]

_TOO_STRONG = 500.0
"""Force, in units of strength/range, beyond which discs overlap: a Lennard-Jones pair at 0.81 sigma."""
_CALM = 100.0
"""Force down to which they are moved apart."""
_LARGEST_WAY = 0.03
"""Of the range: how far a disc is moved at once."""
_MOST_ROUNDS = 5000
_PATIENCE = 50
"""Rounds after which molecules that still overlap are shaken."""
_LONGEST = 0.2
"""Step times the frequency of a bound pair, beyond which a step is called long."""
_FASTEST = 0.15
"""Way of a fast disc (four times the thermal speed) in a step, in ranges, beyond which it is called long."""


def relax(
    state: State, geometry: Geometry, settings: ForcedSettings, strength: float, seed: int
) -> float | None:
    """Move discs apart along their forces until none is extreme; velocities stay.

    Molecules keep their shape: they move along the force on all of their discs, and turn with the torque.

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
    still = _resting(geometry)
    trial = Forced(
        state.copy(), still, _without_baths(settings), Tallies.zero(species, walls), Contacts.empty(0)
    )
    here = geometry.at(state.wall_displacement) if geometry.moves else geometry
    moved = False
    limit = _TOO_STRONG * unit
    for turn in range(_MOST_ROUNDS):
        force, torque = trial.forces_and_torques(state)
        size = np.hypot(*force.T) + np.abs(torque) / state.radius
        apart = _at_one_place(state, turn, seed) if turn < 10 else None
        wild = ~np.isfinite(size)
        if not wild.any() and size.max() <= limit and apart is None:
            break
        moved, limit = True, _CALM * unit
        scale = settings.sigma * _LARGEST_WAY / np.maximum(size, limit)
        way = np.where(wild[:, None], 0.0, force) * scale[:, None]
        angle = np.where(wild, 0.0, torque) * scale / state.radius**2
        way[wild] = random_ways(seed, turn, int(wild.sum()), _LARGEST_WAY * settings.sigma)
        if apart is not None:
            way += apart * settings.sigma
        if has_molecules(state) and turn % _PATIENCE == _PATIENCE - 1:
            _shake(state, way, angle, size > limit, generator(seed, Stream.POSITIONS, 1 + turn))
        move(here, state, way, angle)
        trial.resync(state)
    if not moved:
        return None
    gap = state.position - start
    box = np.where(geometry.periodic, geometry.size, np.inf)
    gap -= np.where(
        geometry.periodic, np.round(gap / box) * np.where(geometry.periodic, geometry.size, 0.0), 0.0
    )
    return float(np.hypot(*gap.T).max())


def _resting(geometry: Geometry) -> Geometry:
    """The same without weight, which presses but is no overlap; and who gets through its walls does not matter."""
    if not isinstance(geometry, Enclosure):
        return geometry
    walls = tuple(dataclasses.replace(wall, open=False, passes=None, soft=False) for wall in geometry.walls)
    return dataclasses.replace(geometry, gravity=(0.0, 0.0), walls=walls)


def random_ways(seed: int, turn: int, count: int, size: float) -> NDArray[np.float64]:
    """(count, 2) float64 [length]: ways of about this size for those that no force leads anywhere."""
    return generator(seed, Stream.POSITIONS, 1 + turn).normal(size=(count, 2)) * size


def _shake(
    state: State,
    way: NDArray[np.float64],
    angle: NDArray[np.float64],
    stuck: NDArray[np.bool_],
    random: np.random.Generator,
) -> None:
    """Other ways, and angles, for molecules that have caught each other: no force leads them out of that."""
    many = int(np.count_nonzero(stuck))
    way[stuck] = 0.5 * state.radius[stuck, None] * random.normal(size=(many, 2))
    angle[stuck] = random.normal(size=many)


def _without_baths(settings: ForcedSettings) -> ForcedSettings:
    return ForcedSettings(
        settings.time_step, settings.terms, settings.sigma, settings.wall_strength, kinds=settings.kinds
    )


def _at_one_place(state: State, turn: int, seed: int) -> NDArray[np.float64] | None:
    """Small random ways for particles with discs at exactly the same place; None if there are none."""
    position, owner = state.position, np.arange(state.count)
    if state.sites is not None:
        position, owner = state.sites.position, state.sites.owner
    _, place, count = np.unique(position, axis=0, return_inverse=True, return_counts=True)
    shared = np.flatnonzero(count[place.ravel()] > 1)
    if not shared.size:
        return None
    of_place: dict[int, set[int]] = {}
    for disc in shared.tolist():
        of_place.setdefault(int(place.ravel()[disc]), set()).add(int(owner[disc]))
    same = np.zeros(state.count, np.bool_)
    # Discs of one molecule may well be at one place.
    same[[row for rows in of_place.values() if len(rows) > 1 for row in rows]] = True
    if not same.any():
        return None
    noise = generator(seed, Stream.POSITIONS, 1 + turn).normal(size=state.position.shape)
    way: NDArray[np.float64] = np.where(same[:, None], noise * _LARGEST_WAY, 0.0)
    return way


def move(geometry: Geometry, state: State, way: NDArray[np.float64], turn: NDArray[np.float64]) -> None:
    """Move (n, 2) [length] and turn (n,) [rad]; who would leave goes along x or y alone, to slide along a wall."""
    waiting = np.ones(state.count, np.bool_)
    for part in ((1.0, 1.0), (1.0, 0.0), (0.0, 1.0), (0.0, 0.0)):
        position = geometry.wrap(state.position + way * part)
        goes = waiting & _held(geometry, state, position, turn)
        state.position[goes] = position[goes]
        if state.sites is not None:
            state.angle[goes] += turn[goes]
        waiting &= ~goes
    if state.sites is not None:
        state.sites.follow(state.position, state.velocity, state.angle, state.angular_velocity, True)


def _held(
    geometry: Geometry, state: State, position: NDArray[np.float64], turn: NDArray[np.float64]
) -> NDArray[np.bool_]:
    """(n,) bool: whether the container holds particles at these places (n, 2) that have turned by so much (n,)."""
    if state.sites is None:
        return geometry.holds(position, state.radius)
    trial = state.sites.copy()
    trial.follow(position, state.velocity, state.angle + turn, state.angular_velocity, True)
    outside = ~geometry.holds(geometry.wrap(trial.position), trial.radius)
    found: NDArray[np.bool_] = np.bincount(trial.owner, outside, state.count) == 0
    return found


def _lightest(state: State) -> float:
    """Smallest mass that the force on a disc has to move; that of a rigid body gives way by turning, too."""
    sites = state.sites
    if sites is None:
        return float(state.mass.min())
    owner, rigid = sites.owner, ~sites.flexible
    turns = np.where(state.inertia > 0.0, state.inertia, np.inf)
    ease = 1.0 / state.mass[owner] + np.sum(sites.place**2, axis=1) / turns[owner]
    return float(np.where(rigid[owner], 1.0 / ease, sites.mass).min())


def step_warning(state: State, settings: ForcedSettings, strength: float) -> str | None:
    """A sentence if the time step is long for the stiffness of a pair or a bond, or for the speed of the discs."""
    if not state.count:
        return None
    frequency = math.sqrt(114.0 * strength / _lightest(state)) / settings.sigma
    present = set(state.species.tolist())
    for number, kind in enumerate(settings.kinds):
        if kind.flexible and number in present and state.sites is not None:
            first = state.sites.first[np.flatnonzero(state.species == number)[0]]
            mass = state.sites.mass[first : first + len(kind.sites)]
            frequency = math.hypot(frequency, stiffest(kind, mass))
    velocity = state.velocity if state.sites is None else state.sites.velocity
    thermal = math.sqrt(float(np.mean(np.sum(velocity**2, axis=1))) / 2.0)
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
