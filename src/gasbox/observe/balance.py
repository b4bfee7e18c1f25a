"""The energy of a gas and where it came from: the first law of thermodynamics, kept as a book.

What a gas has, kinetic and potential, changes by the work of moving walls, by the heat of thermal walls, by what those
carry that leave, by the rule for discs at rest, and by changes from outside such as tilting gravity. Engines tally each
of these hit by hit, so that the book closes up to rounding.

A gas with forces also takes heat from a thermostat and a heater, and work from a barostat, tallied step by step. There
the book closes up to the error of the integration, which the time step sets.

Where discs leave in a field of gravity they take their potential energy along too. It is that of the wall: exact for an
open wall all along which the potential is the same, and the mean over the wall otherwise.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Enclosure, Geometry
from gasbox.observe.energy import kinetic_energy, potential_energy
from gasbox.state import Contacts, State, Tallies

__all__ = ["Balance", "EnergyBalance"]

_COLUMNS: Final = (
    *("kinetic", "potential", "work", "heat", "carried", "rest", "changes"),
    *("thermostat", "heater", "barostat"),
)


@dataclass(frozen=True)
class EnergyBalance:
    """The book over time, one row for each frame; all but the first three count from the start [energy].

    Attributes
    ----------
    time : (frames,) float64 [time]
    kinetic, potential : (frames,) float64 [energy], what the gas has; the second in gravity and of forces together
    work : (frames,) float64 [energy], that moving walls gave to the gas
    heat : (frames,) float64 [energy], that thermal walls gave to the gas
    carried : (frames,) float64 [energy], taken along by discs that left
    rest : (frames,) float64 [energy], that the rule for discs at rest gave
    changes : (frames,) float64 [energy], that changes of gravity gave
    thermostat, heater : (frames,) float64 [energy], heat that they gave to the gas
    barostat : (frames,) float64 [energy], work that it gave to the gas
    wall_work, wall_heat : (frames, walls) float64 [energy], work and heat of each wall
    """

    time: NDArray[np.float64]
    kinetic: NDArray[np.float64]
    potential: NDArray[np.float64]
    work: NDArray[np.float64]
    heat: NDArray[np.float64]
    carried: NDArray[np.float64]
    rest: NDArray[np.float64]
    changes: NDArray[np.float64]
    thermostat: NDArray[np.float64]
    heater: NDArray[np.float64]
    barostat: NDArray[np.float64]
    wall_work: NDArray[np.float64]
    wall_heat: NDArray[np.float64]

    @property
    def internal(self) -> NDArray[np.float64]:
        """(frames,) float64 [energy]: kinetic and potential energy."""
        return self.kinetic + self.potential

    @property
    def residual(self) -> NDArray[np.float64]:
        """(frames,) float64 [energy]: change of the internal energy that the book does not explain; rounding."""
        explained = self.work + self.heat - self.carried + self.rest + self.changes
        explained = explained + self.thermostat + self.heater + self.barostat
        return self.internal - self.internal[:1] - explained


class Balance:
    """Keeps the book of energy, frame by frame.

    Parameters
    ----------
    geometry : what the gas is in
    mass : (species,) float64 [mass], for what those carry that leave
    """

    reads_contacts = False

    def __init__(self, geometry: Geometry, mass: NDArray[np.float64]) -> None:
        self._geometry = geometry
        self._mass = np.asarray(mass, np.float64)
        self._changes = self._left = 0.0
        self._times: list[float] = []
        self._rows: list[tuple[float, ...]] = []
        self._walls: list[tuple[NDArray[np.float64], NDArray[np.float64]]] = []
        self._start: Tallies | None = None
        self._last: Tallies | None = None

    def start(self, state: State, tallies: Tallies) -> None:
        """Open a new book."""
        self._times, self._rows, self._walls = [], [], []
        self._changes = self._left = 0.0
        self._start = self._last = tallies.copy()
        self.observe(state, tallies)

    def changed(self, state: State, geometry: Geometry) -> None:
        """From now on the gas is in another geometry; `state` as it was at that moment."""
        self._changes += potential_energy(state, geometry) - potential_energy(state, self._geometry)
        self._geometry = geometry

    def read(self, contacts: Contacts) -> None:
        """Not needed."""

    def observe(self, state: State, tallies: Tallies) -> None:
        """Add a row, unless this moment was seen already."""
        if self._times and state.time <= self._times[-1]:
            return
        change = tallies - (tallies if self._start is None else self._start)
        if self._last is not None:
            self._left += _potential_left(self._geometry, self._mass, tallies - self._last)
        self._last = tallies.copy()
        self._times.append(state.time)
        self._rows.append(
            (
                kinetic_energy(state),
                potential_energy(state, self._geometry),
                float(np.sum(change.wall_work)),
                float(np.sum(change.wall_heat)),
                float(np.sum(change.wall_carried)) + self._left,
                float(change.rest_energy[0]),
                self._changes,
                float(change.thermostat_heat[0]),
                float(change.heater_heat[0]),
                float(change.barostat_work[0]),
            )
        )
        self._walls.append((np.sum(change.wall_work, axis=1), np.sum(change.wall_heat, axis=1)))

    def series(self) -> EnergyBalance:
        """The book so far."""
        columns = np.array(self._rows, np.float64).reshape(-1, len(_COLUMNS)).T
        walls = len(self._geometry.wall_names)
        work, heat = (
            np.array([row[place] for row in self._walls], np.float64).reshape(-1, walls) for place in (0, 1)
        )
        named = dict(zip(_COLUMNS, columns, strict=True))
        time = np.array(self._times, np.float64)
        return EnergyBalance(time=time, wall_work=work, wall_heat=heat, **named)


def _potential_left(geometry: Geometry, mass: NDArray[np.float64], change: Tallies) -> float:
    """Potential energy of those that left through open walls [energy]."""
    if not isinstance(geometry, Enclosure) or not any(geometry.gravity):
        return 0.0
    total = 0.0
    for number, wall in enumerate(geometry.walls):
        if wall.open and np.any(change.wall_passed[number]):
            gone = np.sum(change.wall_passed[number], axis=1)
            total -= float(gone @ mass) * _mean_pull(geometry, number)
    return total


def _mean_pull(geometry: Enclosure, wall: int) -> float:
    """Mean of g·x along the sides of a wall [length²/time²]."""
    pull = np.where(geometry.periodic, 0.0, geometry.gravity)
    sides = [element for element in geometry.elements if element.wall == wall]
    # The sides of a rectangle have no ends; those of its box are meant.
    middles = [
        np.clip(
            np.array(side.place) + 0.5 * (side.low + side.high) * np.array(side.tangent), 0, geometry.size
        )
        if np.isfinite(side.high - side.low)
        else np.where(np.abs(side.normal) > 0.5, side.place, 0.5 * geometry.size)
        for side in sides
    ]
    return float(np.mean([middle @ pull for middle in middles])) if middles else 0.0
