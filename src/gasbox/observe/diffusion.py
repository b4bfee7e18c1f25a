"""How far discs wander: the mean squared displacement, and the diffusion coefficient from its slope."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.state import Contacts, State, Tallies

__all__ = ["Displacements", "MeanSquaredDisplacement", "diffusion_coefficient"]


@dataclass(frozen=True)
class Displacements:
    """Mean squared displacement since the first frame.

    Attributes
    ----------
    times : (frames,) float64 [time], since the first frame
    msd : (frames,) float64 [length²], mean over all discs that are still there
    """

    times: NDArray[np.float64]
    msd: NDArray[np.float64]


class MeanSquaredDisplacement:
    """Follows each disc by its id, round periodic edges by the nearest image from frame to frame.

    That is right as long as no disc goes half-way round the box between two frames. Where a barostat stretches the box,
    the stretching itself is no displacement.

    Parameters
    ----------
    geometry : what the gas is in
    """

    reads_contacts = False

    def __init__(self, geometry: Geometry) -> None:
        self._geometry = geometry
        self._begin = 0.0
        self._id: NDArray[np.int64] = np.zeros(0, np.int64)
        self._place: NDArray[np.float64] = np.zeros((0, 2))
        self._way: NDArray[np.float64] = np.zeros((0, 2))
        self._size: NDArray[np.float64] = np.ones(2)
        self._rows: list[tuple[float, float]] = []

    def start(self, state: State, tallies: Tallies) -> None:
        """Forget everything; displacements count from here."""
        self._begin, self._rows = state.time, [(0.0, 0.0)]
        self._id, self._place = state.id.copy(), state.position.copy()
        self._way = np.zeros_like(self._place)
        self._size = self._geometry.at(state.wall_displacement).size

    def changed(self, state: State, geometry: Geometry) -> None:
        """From now on the gas is in another geometry."""
        self._geometry = geometry

    def read(self, contacts: Contacts) -> None:
        """Not needed."""

    def observe(self, state: State, tallies: Tallies) -> None:
        """Add a row, unless this moment was seen already."""
        if not self._rows:
            self.start(state, tallies)
        time = state.time - self._begin
        if time <= self._rows[-1][0]:
            return
        stays = np.isin(self._id, state.id)
        before, way = self._place[stays], self._way[stays]
        now = state.position[np.isin(state.id, self._id)]
        periodic = np.asarray(self._geometry.periodic)
        size = self._geometry.at(state.wall_displacement).size
        stretch = np.where(periodic, size / self._size, 1.0)
        step = now - before * stretch
        step -= np.where(periodic, np.round(step / size) * size, 0.0)
        self._way = way + step
        self._id, self._place, self._size = self._id[stays], now.copy(), size
        far = np.sum(self._way**2, axis=1)
        self._rows.append((time, float(np.mean(far)) if far.size else np.nan))

    def value(self) -> Displacements:
        """Everything so far."""
        times, msd = np.array(self._rows, np.float64).reshape(-1, 2).T
        return Displacements(times, msd)


def diffusion_coefficient(
    found: Displacements, begin: float | None = None, end: float | None = None
) -> float | None:
    """D = slope/4 of the mean squared displacement [length²/time], by a straight line through a window of time.

    At first discs fly straight on, and in a small box they later meet the walls: the window must lie in between. In
    two dimensions D of a fluid grows with the logarithm of the window and of the box, slowly; say both with the number.

    Parameters
    ----------
    begin, end : of the window [time]; without them, the later half of the whole time

    Returns
    -------
    None with fewer than three frames in the window.

    Source: M. P. Allen and D. J. Tildesley, Computer Simulation of Liquids, 2nd ed. (2017), chapter 2; B. J. Alder and
    T. E. Wainwright, Phys. Rev. A 1, 18 (1970), doi:10.1103/PhysRevA.1.18, for two dimensions.
    """
    last = float(found.times[-1]) if found.times.size else 0.0
    inside = (found.times >= (0.5 * last if begin is None else begin)) & np.isfinite(found.msd)
    inside &= found.times <= (last if end is None else end)
    if np.count_nonzero(inside) < 3:
        return None
    time, far = found.times[inside], found.msd[inside]
    away = time - np.mean(time)
    return float(away @ far / (away @ away)) / 4.0
