"""Velocities at the start."""

from __future__ import annotations

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.rng import Stream, generator
from gasbox.scenario import Kind, Scenario

__all__ = ["draw_rotation", "draw_velocities"]

_TURNS: Final = 50
_GENTLE: Final = 4.0
"""After the first turn no energy changes by more than this factor; else drift drowns a cold species."""
_CLOSE: Final = 1e-14


def draw_velocities(scenario: Scenario, species: NDArray[np.int32]) -> NDArray[np.float64]:
    """Velocities (n, 2) [length/time] of counted discs, given the species (n,) of each.

    A species with `velocities` gets them as they stand, one with `speed` random directions at exactly this speed, one
    with a `temperature` T Maxwell's distribution: each component normal with variance T/m. All that have a temperature
    form the *drawn gas*, whose velocities are then corrected so that two things hold at once, up to rounding:

    1. Along each periodic direction, where momentum is conserved, the drawn gas has none. One and the same velocity is
       taken off all of its discs, as a change to the frame of its centre of mass does.
    2. Each species s of more than one disc has the kinetic energy ``K_s = N_s T_s (1 - (p/2) m_s/M)`` in that frame,
       with M the mass of the drawn gas and p the number of periodic directions, by one factor on its velocities.

    Without periodic directions ``K_s = N_s T_s``: each species has exactly its temperature, and a gas with one T
    exactly ``T = 2 K/(2N)``. Along a periodic direction a disc of mass m moves against the other discs, and in
    equilibrium carries the share ``(T/2)(1 - m/M)`` of the energy, not T/2. These shares add up to ``(N - 1) T/2``, so
    that a gas with one T in a periodic box has exactly ``T = 2 K/(2N - 2)``, and no species gains or loses on average.
    (The mean energy of a disc of species s is then ``T (1 - m_s/M)``, which is T up to one part in N.)

    Multiplying disturbs 1, taking off disturbs 2; doing both in turn converges quickly, because each correction is
    smaller than the one before by a factor of the order of 1/N. A species of a single disc keeps the speed that it was
    dealt and only takes part in 1; a gas of a single disc is left as drawn, for it has no frame in which it moves.

    (Where a heavy species is so cold that the drift would drown its own motion, this does not settle; then the momentum
    of each species is taken off by itself.)

    Discs that are listed, and species with `speed` or `velocities`, are left exactly as they were asked for, whatever
    momentum they bring.
    """
    velocity = np.zeros((species.shape[0], 2))
    drawn: dict[int, NDArray[np.int64]] = {}
    for number, entry in enumerate(scenario.kinds):
        members = np.flatnonzero(species == number)
        if not members.size:
            continue
        random = generator(scenario.seed, Stream.VELOCITIES, number)
        velocity[members] = _of_species(entry, members.size, random)
        if entry.temperature is not None:
            drawn[number] = members
    _correct(scenario, velocity, drawn)
    return velocity


def draw_rotation(scenario: Scenario, species: NDArray[np.int32]) -> NDArray[np.float64]:
    """Angular velocities (n,) [rad/time] of counted particles, given the kind (n,) of each.

    Normal with variance T/I, where T is the rotational temperature, or the temperature; then scaled so that the mean
    energy of each kind of more than one molecule is T/2. With an angular speed, this in either direction.
    """
    turning = np.zeros(species.shape[0])
    for number, kind in enumerate(scenario.kinds):
        members = np.flatnonzero(species == number)
        if not members.size or kind.inertia == 0.0:
            continue
        random = generator(scenario.seed, Stream.ROTATION, number)
        if kind.angular_speed is not None:
            turning[members] = kind.angular_speed * random.choice([-1.0, 1.0], members.size)
            continue
        warm = kind.temperature if kind.rotational_temperature is None else kind.rotational_temperature
        drawn = random.standard_normal(members.size)
        if members.size > 1:
            drawn /= math.sqrt(float(np.mean(drawn**2)))
        turning[members] = math.sqrt((warm or 0.0) / kind.inertia) * drawn
    return turning


def _of_species(species: Kind, count: int, random: np.random.Generator) -> NDArray[np.float64]:
    if species.velocities is not None:
        return np.array(species.velocities, np.float64).reshape(-1, 2)
    if species.speed is not None:
        angle = random.uniform(0, 2 * math.pi, count)
        return species.speed * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    if species.temperature is None:
        # Only people who walk need none: they look anywhere, and walk at their own speed.
        return np.zeros((count, 2))
    return math.sqrt(species.temperature / species.mass) * random.standard_normal((count, 2))


def _correct(scenario: Scenario, velocity: NDArray[np.float64], drawn: dict[int, NDArray[np.int64]]) -> None:
    """Take off the momentum along periodic directions and set the energies of the species, in place."""
    if sum(members.size for members in drawn.values()) < 2:
        return
    periodic = scenario.geometry().periodic
    masses = [scenario.kinds[number].mass for number in drawn]
    total = sum(mass * members.size for mass, members in zip(masses, drawn.values(), strict=True))
    targets = [_energy(scenario, number, members.size, total) for number, members in drawn.items()]
    groups = [velocity[members] for members in drawn.values()]
    if not _settle(groups, masses, targets, periodic):
        groups = [velocity[members] for members in drawn.values()]
        for group in groups:
            group -= periodic * group.mean(axis=0)
        _rescale(groups, masses, targets)
    for group, members in zip(groups, drawn.values(), strict=True):
        velocity[members] = group


def _settle(
    groups: list[NDArray[np.float64]], masses: list[float], targets: list[float], periodic: NDArray[np.bool_]
) -> bool:
    """Take off the common drift and rescale in turn, in place; False if that does not settle."""
    total = sum(mass * group.shape[0] for mass, group in zip(masses, groups, strict=True))
    for turn in range(_TURNS):
        drift = sum(mass * group.sum(axis=0) for mass, group in zip(masses, groups, strict=True)) / total
        for group in groups:
            group -= periodic * drift
        largest = _rescale(groups, masses, targets)
        if turn > 0 and largest > _GENTLE:
            return False
        if _at_rest(groups, masses, periodic):
            return True
    return False


def _rescale(groups: list[NDArray[np.float64]], masses: list[float], targets: list[float]) -> float:
    """Give each group its kinetic energy [energy], in place; a single disc keeps its own.

    Returns
    -------
    The largest factor on an energy, or of its inverse.
    """
    largest = 1.0
    for group, mass, target in zip(groups, masses, targets, strict=True):
        energy = 0.5 * mass * float(np.square(group).sum())
        if group.shape[0] > 1 and energy > 0:
            group *= math.sqrt(target / energy)
            largest = max(largest, target / energy, energy / target if target > 0 else math.inf)
    return largest


def _at_rest(groups: list[NDArray[np.float64]], masses: list[float], periodic: NDArray[np.bool_]) -> bool:
    """Whether the momentum along periodic directions is nothing but rounding."""
    momentum, size = np.zeros(2), np.zeros(2)
    for group, mass in zip(groups, masses, strict=True):
        momentum += mass * group.sum(axis=0)
        size += mass * np.abs(group).sum(axis=0)
    return bool((np.abs(momentum) <= _CLOSE * size)[periodic].all())


def _energy(scenario: Scenario, number: int, count: int, total: float) -> float:
    """Kinetic energy [energy] that `count` discs of a species are to have in a drawn gas of mass `total`."""
    species = scenario.kinds[number]
    directions = int(scenario.geometry().periodic.sum())
    return count * float(species.temperature or 0.0) * (1 - directions / 2 * species.mass / total)
