"""The heating curve of school chemistry: temperature against the heat that was added, with what the gas is meanwhile.

The heat added is the change of the enthalpy H = K + U + P A, with the pressure P from outside (without a barostat the
area stays, and it is the change of K + U): what the gas has got, whoever gave it. Where the pressure changes meanwhile
it is the sum of d(K + U) + P dA. The temperature is the mean over the
time between two frames, where the tallies hold it.

Stretches are told from the shares of discs in each phase alone (`gasbox.observe.phases`), not from the temperature:
solid, melting, liquid, boiling, gas, and subliming where solid and gas share the box without much liquid. In a finite
gas plateaus are tilted and rounded, and a transition may begin late (a crystal without a surface overheats).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.observe.energy import degrees_of_freedom, enthalpy, internal_energy, temperature
from gasbox.observe.phases import phase_shares, phases
from gasbox.state import Contacts, State, Tallies

__all__ = ["HeatingCourse", "HeatingCurve"]


@dataclass(frozen=True)
class HeatingCourse:
    """One row for each frame.

    Attributes
    ----------
    time : (frames,) float64 [time]
    heat : (frames,) float64 [energy], added since the first frame, for each disc
    enthalpy : (frames,) float64 [energy], of each disc
    temperature : (frames,) float64 [energy], mean over the time since the frame before; the first as it is
    density : (frames,) float64 [1/length²], discs per area
    shares : (frames, 3) float64, of discs in gas, liquid and solid
    """

    time: NDArray[np.float64]
    heat: NDArray[np.float64]
    enthalpy: NDArray[np.float64]
    temperature: NDArray[np.float64]
    density: NDArray[np.float64]
    shares: NDArray[np.float64]

    def rows(self, chosen: slice | NDArray[np.int64]) -> HeatingCourse:
        """Some of the frames; heat still counts from the first of all."""
        return HeatingCourse(
            self.time[chosen],
            self.heat[chosen],
            self.enthalpy[chosen],
            self.temperature[chosen],
            self.density[chosen],
            self.shares[chosen],
        )


class HeatingCurve:
    """Keeps heat, temperature, density and phases, frame by frame.

    Parameters
    ----------
    geometry : what the gas is in
    pressure : from outside, that of the barostat, or a function of time that gives it [mass/time²]; 0 without one
    distance : within which others are neighbours, for telling phases [length]; some 1.5 sigma
    """

    reads_contacts = False

    def __init__(
        self, geometry: Geometry, pressure: float | Callable[[float], float] = 0.0, distance: float = 1.5
    ) -> None:
        self._geometry = geometry
        self._pressure = pressure
        self._distance = distance
        self._before: tuple[float, float] = (0.0, 0.0)
        self._energies: tuple[float, float, float] = (0.0, 0.0, 0.0)
        self._sum = 0.0
        self._rows: list[tuple[float, ...]] = []

    def start(self, state: State, tallies: Tallies) -> None:
        """Forget everything; heat counts from here."""
        self._rows = []
        self.observe(state, tallies)

    def changed(self, state: State, geometry: Geometry) -> None:
        """From now on the gas is in another geometry."""
        self._geometry = geometry

    def read(self, contacts: Contacts) -> None:
        """Not needed."""

    def observe(self, state: State, tallies: Tallies) -> None:
        """Add a row, unless this moment was seen already; none for an empty box."""
        if not state.count or (self._rows and state.time <= self._rows[-1][0]):
            return
        area = self._geometry.at(state.wall_displacement).area
        pressure = self._pressure(state.time) if callable(self._pressure) else self._pressure
        heat = self._heat(internal_energy(state, self._geometry), area, pressure) / state.count
        each = enthalpy(state, self._geometry, pressure) / state.count
        shares = phase_shares(phases(state, self._geometry, self._distance))
        warmth = self._temperature(state, tallies)
        self._rows.append((state.time, heat, each, warmth, state.count / area, *shares))

    def value(self) -> HeatingCourse:
        """Everything so far."""
        rows = np.array(self._rows, np.float64).reshape(-1, 8)
        time, heat, each, warmth, density = rows[:, :5].T
        return HeatingCourse(time, heat, each, warmth, density, rows[:, 5:])

    def _heat(self, energy: float, area: float, pressure: float) -> float:
        """Heat added since the first row [energy]."""
        (old_energy, old_area, old_pressure), self._energies = self._energies, (energy, area, pressure)
        self._sum = (
            self._sum + energy - old_energy + 0.5 * (pressure + old_pressure) * (area - old_area)
            if self._rows
            else 0.0
        )
        return self._sum

    def _temperature(self, state: State, tallies: Tallies) -> float:
        """2/f times the mean kinetic energy since the last row; where nobody summed it, as it is now."""
        within = float(tallies.rotational_time[0] + tallies.vibrational_time[0])
        now_at = float(tallies.measured_time[0]), float(tallies.kinetic_time[0]) + within
        (time, before), self._before = self._before, now_at
        freedom = degrees_of_freedom(state, self._geometry)
        if self._rows and freedom and now_at[0] > time:
            return 2.0 * (now_at[1] - before) / (freedom * (now_at[0] - time))
        now = temperature(state, self._geometry)
        return np.nan if now is None else now
