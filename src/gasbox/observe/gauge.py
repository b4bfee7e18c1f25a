"""An observer that keeps the pressure on each wall, frame by frame, with an error bar from its own scatter."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.observe.blocks import block_error
from gasbox.observe.walls import between, wall_pressure_errors, wall_pressures
from gasbox.state import Contacts, State, Tallies

__all__ = ["WallGauge", "WallSeries"]


@dataclass(frozen=True)
class WallSeries:
    """Pressure on each wall over time, and its mean.

    Attributes
    ----------
    names : (walls,) of the walls
    time : (windows,) float64 [time], end of each window between two frames
    pressure : (windows, walls) float64 [mass/time²], not-a-number where a wall is no gauge
    mean : (walls,) float64 [mass/time²], over all windows, each weighted by its duration
    error : (walls,) float64 [mass/time²], standard error of the mean: the larger of that of independent hits
        and that of blocks of windows
    """

    names: tuple[str, ...]
    time: NDArray[np.float64]
    pressure: NDArray[np.float64]
    mean: NDArray[np.float64]
    error: NDArray[np.float64]


class WallGauge:
    """Measures the pressure on each wall in each window between two frames.

    Parameters
    ----------
    geometry : what the gas is in
    radii : (species,) float64 [length]
    since : windows that begin before are left out, so that a transient can pass [time]
    """

    reads_contacts = False

    def __init__(self, geometry: Geometry, radii: NDArray[np.float64], since: float = -np.inf) -> None:
        self._geometry = geometry
        self._radii = np.asarray(radii, np.float64)
        self._since = since
        self._before: tuple[float, NDArray[np.float64], Tallies] | None = None
        self._times: list[float] = []
        self._windows: list[tuple[float, NDArray[np.float64], NDArray[np.float64]]] = []

    def start(self, state: State, tallies: Tallies) -> None:
        """Forget all windows."""
        self._times, self._windows = [], []
        self._before = state.time, state.wall_displacement.copy(), tallies.copy()

    def changed(self, state: State, geometry: Geometry) -> None:
        """From now on the gas is in another geometry."""
        self._geometry = geometry

    def read(self, contacts: Contacts) -> None:
        """Not needed."""

    def observe(self, state: State, tallies: Tallies) -> None:
        """Add the window since the frame before."""
        before = self._before
        self._before = state.time, state.wall_displacement.copy(), tallies.copy()
        if before is None or before[0] < self._since or state.time <= before[0]:
            return
        window, change = state.time - before[0], tallies - before[2]
        mid = between(self._geometry, before[1], state.wall_displacement)
        self._times.append(state.time)
        self._windows.append(
            (
                window,
                wall_pressures(change, mid, self._radii, window),
                wall_pressure_errors(change, mid, self._radii, window),
            )
        )

    def series(self) -> WallSeries:
        """Everything so far; not-a-number for means and errors of nothing."""
        names = self._geometry.wall_names
        share = np.array([window for window, _, _ in self._windows])
        pressure, hits = (
            np.array([entry[place] for entry in self._windows]).reshape(-1, len(names)) for place in (1, 2)
        )
        if not share.size:
            nothing = np.full(len(names), np.nan)
            return WallSeries(names, np.array(self._times), pressure, nothing, nothing)
        # A wall that was taken away or put back is a gauge in some windows only.
        share = np.where(np.isfinite(pressure), share[:, None], 0.0)
        whole = np.sum(share, axis=0)
        share = share / np.where(whole > 0.0, whole, np.nan)
        mean = np.sum(share * np.nan_to_num(pressure), axis=0)
        # A window without a hit adds nothing to the error from hits.
        dilute = np.sqrt(np.sum(np.square(share * np.nan_to_num(hits)), axis=0))
        error = np.array([_scatter(column) for column in pressure.T])
        return WallSeries(names, np.array(self._times), pressure, mean, np.fmax(error, dilute))


def _scatter(pressure: NDArray[np.float64]) -> float:
    """Standard error of the mean of those windows in which the wall was a gauge."""
    return float(block_error(pressure[np.isfinite(pressure)]))
