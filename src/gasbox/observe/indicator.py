"""Pressure against area of a gas behind a moving wall, as an engine's indicator draws it.

The gas gives the work integral of P dA to the wall; the wall gives minus that to the gas.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.observe.walls import between, wall_pressures
from gasbox.state import Contacts, State, Tallies

__all__ = ["Indicator", "IndicatorSeries"]


@dataclass(frozen=True)
class IndicatorSeries:
    """Area and pressure over time.

    Attributes
    ----------
    time : (frames,) float64 [time]
    area : (frames,) float64 [length²], of the whole enclosure
    displacement : (frames,) float64 [length], of the wall
    pressure : (frames,) float64 [mass/time²], mean on the wall in the window before; not-a-number at the first
    mid_area : (frames,) float64 [length²], mean of the areas at both ends of that window: where the pressure belongs
    work : (frames,) float64 [energy], that the wall gave to the gas since the start, tallied hit by hit
    integral : (frames,) float64 [energy], the same from the diagram: minus the sum of mean force times way outwards
    """

    time: NDArray[np.float64]
    area: NDArray[np.float64]
    displacement: NDArray[np.float64]
    pressure: NDArray[np.float64]
    mid_area: NDArray[np.float64]
    work: NDArray[np.float64]
    integral: NDArray[np.float64]


class Indicator:
    """Draws the diagram of a moving side of a rectangle, frame by frame.

    Parameters
    ----------
    geometry : what the gas is in
    radii : (species,) float64 [length]
    wall : index of the wall, 0 to 3 (left, right, bottom, top)
    """

    reads_contacts = False

    def __init__(self, geometry: Geometry, radii: NDArray[np.float64], wall: int) -> None:
        self._geometry, self._wall = geometry, wall
        self._radii = np.asarray(radii, np.float64)
        # The gas is on the front of the left and bottom side, and behind the other two.
        self._outwards = 1.0 if wall % 2 else -1.0
        self._rows: list[tuple[float, ...]] = []
        self._before: tuple[NDArray[np.float64], Tallies] | None = None
        self._start: Tallies | None = None

    def start(self, state: State, tallies: Tallies) -> None:
        """Begin a new diagram."""
        self._rows, self._before, self._start = [], None, tallies.copy()
        self.observe(state, tallies)

    def changed(self, state: State, geometry: Geometry) -> None:
        """From now on the gas is in another geometry."""
        self._geometry = geometry

    def read(self, contacts: Contacts) -> None:
        """Not needed."""

    def observe(self, state: State, tallies: Tallies) -> None:
        """Add a point, unless this moment was seen already."""
        if self._rows and state.time <= self._rows[-1][0]:
            return
        area = self._geometry.at(state.wall_displacement).area
        place = float(state.wall_displacement[self._wall]) if state.wall_displacement.size else 0.0
        start = tallies if self._start is None else self._start
        work = float(np.sum(tallies.wall_work[self._wall] - start.wall_work[self._wall]))
        pressure = mid = np.nan
        integral = 0.0
        if self._before is not None:
            earlier, before = self._before
            last = self._rows[-1]
            change, window = tallies - before, state.time - last[0]
            mean = between(self._geometry, earlier, state.wall_displacement)
            pressure = float(wall_pressures(change, mean, self._radii, window)[self._wall])
            force = float(np.sum(change.wall_impulse[self._wall])) / window
            mid = 0.5 * (last[1] + area)
            integral = last[6] - force * self._outwards * (place - last[2])
        self._rows.append((state.time, area, place, pressure, mid, work, integral))
        self._before = state.wall_displacement.copy(), tallies.copy()

    def series(self) -> IndicatorSeries:
        """Everything so far."""
        return IndicatorSeries(*np.array(self._rows, np.float64).reshape(-1, 7).T)
