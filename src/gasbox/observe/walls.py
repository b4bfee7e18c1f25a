"""What each wall feels and does: its pressure with an error bar, and who passes it.

Force per length, as everywhere, and per the length that centres can reach. A wall that a species passes, an open wall
and one that is absent are no pressure gauge. Of an obstacle the pressure is the mean over all that can be touched of
it, both sides of a divider together. Where walls move, lengths change: give the geometry at the mean displacement of
the time in question (`gasbox.observe.between`); lengths between straight walls are linear in it.
Over a time in which a wall grows much longer or shorter its pressure is then the mean weighted by its length.
"""

from __future__ import annotations

import functools
import math

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry, Rectangle, Wall
from gasbox.geometry.conserved import is_solid, lets_everybody_pass
from gasbox.state import State, Tallies

__all__ = [
    "MeanDisplacement",
    "between",
    "gauge_lengths",
    "passage_rates",
    "wall_pressure_errors",
    "wall_pressures",
]


def between(geometry: Geometry, earlier: NDArray[np.float64], later: NDArray[np.float64]) -> Geometry:
    """The geometry with its walls half-way between two displacements (walls,) [length], which may be empty."""
    return geometry.at(0.5 * (earlier + later) if earlier.shape == later.shape else later)


class MeanDisplacement:
    """Mean over time of the displacements of walls, from what is seen now and then.

    Between two looks a wall counts as moving evenly.

    Parameters
    ----------
    state : where walls are at the start
    """

    def __init__(self, state: State) -> None:
        self._last = state.time, state.wall_displacement.copy()
        self._sum: NDArray[np.float64] = np.zeros(state.wall_displacement.shape)
        self._duration = 0.0

    def see(self, state: State) -> None:
        """Take note of where walls are; looks come in the order of time."""
        (time, place), now = self._last, state.wall_displacement
        if state.time <= time:
            return
        if now.shape != place.shape:
            # Walls that began to move only now stood still before.
            place = self._sum = np.zeros(now.shape)
        self._sum = self._sum + 0.5 * (state.time - time) * (place + now)
        self._duration += state.time - time
        self._last = state.time, now.copy()

    def value(self) -> NDArray[np.float64]:
        """(walls,) float64 [length]: the mean so far; empty if no wall moves."""
        return self._sum / self._duration if self._duration > 0.0 else self._last[1]


def gauge_lengths(geometry: Geometry, radii: NDArray[np.float64], gates: bool = False) -> NDArray[np.float64]:
    """(walls, species) float64 [length]: where centres of a species can touch a wall, 0 if that is no gauge.

    Parameters
    ----------
    radii : (species,) [length]
    gates : whether walls count that let some of a species pass, by speed or direction
    """
    return _lengths(geometry, tuple(radii.tolist()), gates).copy()


def wall_pressures(
    change: Tallies, geometry: Geometry, radii: NDArray[np.float64], duration: float
) -> NDArray[np.float64]:
    """(walls,) float64 [mass/time²]: pressure on each wall, summed over species; not-a-number for what is no gauge.

    Parameters
    ----------
    change : what was added to the tallies meanwhile (later - earlier)
    radii : (species,) float64 [length]
    duration : [time]
    """
    lengths = gauge_lengths(geometry, radii, gates=True)
    if duration <= 0.0:
        return np.full(lengths.shape[0], np.nan)
    pressures = np.sum(_over(change.wall_impulse, lengths), axis=1) / duration
    return np.where(np.any(lengths > 0.0, axis=1), pressures, np.nan)


def wall_pressure_errors(
    change: Tallies, geometry: Geometry, radii: NDArray[np.float64], duration: float
) -> NDArray[np.float64]:
    """(walls,) float64 [mass/time²]: standard errors of `wall_pressures`; not-a-number without a hit.

    Hits taken as independent with Maxwell's law: P_s sqrt(4/(pi hits_s)) of each species, added in squares. True of a
    dilute gas; of a dense or driven one ask `gasbox.observe.WallGauge`, which sees the scatter itself.
    """
    lengths = gauge_lengths(geometry, radii, gates=True)
    hits = change.wall_collisions
    if duration <= 0.0:
        return np.full(lengths.shape[0], np.nan)
    parts = _over(change.wall_impulse, lengths) / duration
    squares = 4.0 / math.pi * np.sum(_over(parts**2, hits), axis=1)
    return np.where(np.any((hits > 0) & (lengths > 0.0), axis=1), np.sqrt(squares), np.nan)


def passage_rates(change: Tallies, duration: float) -> NDArray[np.float64] | None:
    """(walls, species, 2) float64 [1/time]: who passed each wall, along its normal and against it; None without time.

    The net flow is the first less the second.
    """
    return change.wall_passed / duration if duration > 0.0 else None


@functools.lru_cache(maxsize=512)
def _lengths(geometry: Geometry, radii: tuple[float, ...], gates: bool) -> NDArray[np.float64]:
    lengths = np.zeros((len(geometry.wall_names), len(radii)))
    for wall in range(lengths.shape[0]):
        for species, radius in enumerate(radii):
            if isinstance(geometry, Rectangle) or _is_gauge(geometry.walls[wall], species, gates):
                lengths[wall, species] = max(geometry.accessible_length(wall, radius), 0.0)
    return lengths


def _is_gauge(wall: Wall, species: int, gates: bool) -> bool:
    if not is_solid(wall) or lets_everybody_pass(wall.passes, species):
        return False
    ways = () if wall.passes is None else wall.passes.ways
    return gates or not any(way and (way.species is None or species in way.species) for way in ways)


def _over(sums: NDArray[np.float64], divisor: NDArray[np.float64] | NDArray[np.int64]) -> NDArray[np.float64]:
    """Quotients, 0 where the divisor is."""
    return np.divide(sums, divisor, out=np.zeros(sums.shape), where=divisor > 0)
