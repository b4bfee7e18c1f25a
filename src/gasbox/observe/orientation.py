"""How molecules are turned: their order, how it goes over distance, and how long each remembers.

All count the molecules that rotate alone. cos(2 x) takes both ends of a rod for the same; cos(x) does not.

Source: M. P. Allen and D. J. Tildesley, Computer Simulation of Liquids, 2nd ed. (2017), section 2.6, in two
dimensions.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.observe.neighbours import neighbours
from gasbox.state import Contacts, State, Tallies

__all__ = [
    "NematicOrder",
    "OrientationCorrelation",
    "OrientationPairs",
    "Turning",
    "TurningCorrelation",
    "nematic_order",
]


@dataclass(frozen=True)
class NematicOrder:
    """How far molecules lie along one line.

    Attributes
    ----------
    order : S, the modulus of the mean of exp(2i angle): 1 if all lie along one line, and sqrt(pi/(4N)) by chance
    director : angle of that line [rad], above -pi/2 and up to pi/2
    """

    order: float
    director: float


def nematic_order(state: State, species: int | None = None) -> NematicOrder | None:
    """Order of all molecules that rotate, or of one kind; None without any."""
    turning = _turning(state, species)
    if not np.any(turning):
        return None
    mean = complex(np.mean(np.exp(2j * state.angle[turning])))
    return NematicOrder(abs(mean), 0.5 * math.atan2(mean.imag, mean.real))


@dataclass(frozen=True)
class OrientationPairs:
    """Correlation of two angles as a function of the distance of their centres; not-a-number without a pair.

    Attributes
    ----------
    r : (bins,) float64 [length], middles of the bins
    first, second : (bins,) float64, means of cos(angle_i - angle_j) and cos(2 (angle_i - angle_j))
    pairs : (bins,) float64, ordered pairs over which they were taken
    """

    r: NDArray[np.float64]
    first: NDArray[np.float64]
    second: NDArray[np.float64]
    pairs: NDArray[np.float64]


class OrientationCorrelation:
    """Averages over all pairs of molecules, and over the frames of a run.

    Parameters
    ----------
    geometry : what the gas is in
    bins : how many between 0 and `maximum`
    maximum : greatest distance [length]
    species : of which kind; None for all that rotate
    since : frames before this time are left out [time]
    """

    reads_contacts = False

    def __init__(
        self,
        geometry: Geometry,
        bins: int,
        maximum: float,
        species: int | None = None,
        since: float = -np.inf,
    ) -> None:
        self._geometry = geometry
        self._edges = np.linspace(0.0, maximum, bins + 1)
        self._species, self._since = species, since
        self._last = -np.inf
        self._sums = np.zeros((3, bins))

    def start(self, state: State, tallies: Tallies) -> None:
        """Forget all frames and count the first."""
        self._last, self._sums = -np.inf, np.zeros_like(self._sums)
        self.observe(state, tallies)

    def changed(self, state: State, geometry: Geometry) -> None:
        """From now on the gas is in another geometry."""
        self._geometry = geometry

    def read(self, contacts: Contacts) -> None:
        """Not needed."""

    def observe(self, state: State, tallies: Tallies) -> None:
        """Add the pairs of a frame, unless it is too early or was seen already."""
        if state.time < self._since or state.time <= self._last:
            return
        self._last = state.time
        turning = _turning(state, self._species)
        if not np.any(turning):
            return
        found = neighbours(state, self._geometry, float(self._edges[-1]))
        rows, other = found.rows, found.other
        both = turning[rows] & turning[other] & (rows != other)
        bins = self._edges.size - 1
        way = np.hypot(found.way[both, 0], found.way[both, 1])
        place = np.minimum((way * (bins / self._edges[-1])).astype(np.int64), bins - 1)
        between = state.angle[rows[both]] - state.angle[other[both]]
        for row, worth in zip(
            self._sums, (np.ones_like(between), np.cos(between), np.cos(2 * between)), strict=True
        ):
            row += np.bincount(place, worth, bins)

    def value(self) -> OrientationPairs:
        """The mean so far."""
        pairs = self._sums[0]
        means = np.full((2, pairs.size), np.nan)
        np.divide(self._sums[1:], pairs, out=means, where=pairs > 0.0)
        middles = 0.5 * (self._edges[1:] + self._edges[:-1])
        return OrientationPairs(middles, means[0], means[1], pairs.copy())


@dataclass(frozen=True)
class TurningCorrelation:
    """How long molecules remember how they were turned.

    Attributes
    ----------
    times : (lags,) float64 [time], apart
    first, second : (lags,) float64, means of cos(turn) and cos(2 turn), of what each has turned in that time
    """

    times: NDArray[np.float64]
    first: NDArray[np.float64]
    second: NDArray[np.float64]


class Turning:
    """Keeps the angles of all molecules, frame by frame; frames must be equally far apart in time.

    Those that leave the gas do not count at all.

    Parameters
    ----------
    species : of which kind; None for all that rotate
    """

    reads_contacts = False

    def __init__(self, species: int | None = None) -> None:
        self._species = species
        self._times: list[float] = []
        self._frames: list[NDArray[np.complex128]] = []
        self._id: NDArray[np.int64] = np.zeros(0, np.int64)

    def start(self, state: State, tallies: Tallies) -> None:
        """Forget everything; times count from here."""
        self._times, self._frames = [], []
        self._id = state.id[_turning(state, self._species)].copy()
        self.observe(state, tallies)

    def read(self, contacts: Contacts) -> None:
        """Not needed."""

    def observe(self, state: State, tallies: Tallies) -> None:
        """Keep the angles of a frame, unless this moment was seen already."""
        if self._times and state.time <= self._times[-1]:
            return
        if not self._times:
            self._id = state.id[_turning(state, self._species)].copy()
        stays = np.isin(self._id, state.id)
        self._frames = [frame[stays] for frame in self._frames] if not stays.all() else self._frames
        self._id = self._id[stays]
        self._times.append(state.time)
        angle = state.angle if state.sites is not None else np.zeros(state.count)
        self._frames.append(np.exp(1j * angle[np.isin(state.id, self._id)]))

    def value(self, lags: int | None = None) -> TurningCorrelation:
        """The mean over all molecules and all beginnings.

        Parameters
        ----------
        lags : how many distances in time, the first of which is 0; None for half of the frames
        """
        times = np.array(self._times)
        frames = np.array(self._frames).reshape(times.size, self._id.size)
        number = min(times.size, times.size // 2 + 1 if lags is None else lags)
        mean = np.full((2, number), np.nan)
        for lag in range(number if frames.size else 0):
            turn = frames[lag:] * np.conj(frames[: times.size - lag])
            mean[:, lag] = np.mean(turn.real), np.mean((turn**2).real)
        return TurningCorrelation(times[:number] - times[:1] if times.size else times, *mean)


def _turning(state: State, species: int | None) -> NDArray[np.bool_]:
    """(n,) bool: who rotates, of one kind or of all."""
    if state.sites is None:
        return np.zeros(state.count, np.bool_)
    turning: NDArray[np.bool_] = state.inertia > 0.0
    return turning if species is None else turning & (state.species == species)
