"""Studies of walls: the pressure on each, and the diagram of pressure and area of a moving one."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.app.history import History
from gasbox.app.sample import Sample
from gasbox.app.study import INK, Axis, Picture, Trace, radii
from gasbox.app.window import Lately
from gasbox.geometry import Enclosure, Geometry, Rectangle
from gasbox.observe import temperature, wall_pressure_errors, wall_pressures
from gasbox.theory import adiabat, mixture
from gasbox.units import UNIT

__all__ = ["Pressures", "Work"]

_MOST_BARS: Final = 16
_AREA: Final = f"area  ({UNIT['area']})"
_PRESSURE: Final = f"pressure  ({UNIT['pressure']})"


class Pressures:
    """Pressure on each wall over the last seconds, with standard errors."""

    name, title = "pressures", "Pressure on each wall"
    is_light = False

    def __init__(self) -> None:
        self._picture: Picture | None = None

    def suits(self, sample: Sample) -> bool:
        """There are walls."""
        return sample.geometry.is_walled

    def is_wanted(self, sample: Sample) -> bool:
        """Never by itself."""
        return False

    def take(self, sample: Sample, lately: Lately | None) -> None:
        """See `gasbox.app.study.Study`."""
        self._picture = None
        if lately is None or lately.duration <= 0.0:
            return
        geometry = sample.geometry.at(lately.displacement)
        radius = radii(sample.scenario)
        mean = wall_pressures(lately.change, geometry, radius, lately.duration)
        error = wall_pressure_errors(lately.change, geometry, radius, lately.duration)
        known = np.flatnonzero(np.isfinite(mean))[:_MOST_BARS]
        if known.size:
            points = np.column_stack([np.arange(known.size), mean[known]])
            names = tuple(geometry.wall_names[wall] for wall in known)
            bars = Trace("pressure", points, "bars", np.nan_to_num(error[known]), "var(--accent)")
            self._picture = Picture(Axis("", labels=names), Axis(_PRESSURE, 0.0), [bars])

    def picture(self) -> Picture | None:
        """See `gasbox.app.study.Study`."""
        return self._picture


class Work:
    """Pressure on the first moving side against the area of the gas, and what a slow change would give."""

    name, title = "work", "Pressure and area"
    is_light = True

    def __init__(self) -> None:
        self._history = History()
        self._version = -1
        self._start: Sample | None = None
        self._sample: Sample | None = None

    def suits(self, sample: Sample) -> bool:
        """A side of a rectangle moves."""
        return _moving(sample.geometry) is not None

    is_wanted = suits

    def take(self, sample: Sample, lately: Lately | None) -> None:
        """See `gasbox.app.study.Study`."""
        if sample.version != self._version:
            self._history, self._version, self._start = History(), sample.version, sample
        self._sample = sample
        wall = _moving(sample.geometry)
        if wall is None or lately is None or lately.brief is None or lately.brief.duration <= 0.0:
            return
        brief = lately.brief
        geometry = sample.geometry.at(brief.displacement)
        pressure = wall_pressures(brief.change, geometry, radii(sample.scenario), brief.duration)[wall]
        if np.isfinite(pressure):
            self._history.add(sample.time, (geometry.area, float(pressure)))

    def picture(self) -> Picture | None:
        """See `gasbox.app.study.Study`."""
        if self._start is None or len(self._history.rows) < 2:
            return None
        points = np.array(self._history.rows, np.float64)
        traces = [
            Trace("pressure", points, "line", None, "var(--accent)"),
            Trace("now", points[-1:], "points", None, "var(--accent)"),
            *_expected(self._start, points[:, 0]),
        ]
        return Picture(Axis(_AREA), Axis(_PRESSURE, 0.0), traces)


def _expected(start: Sample, areas: NDArray[np.float64]) -> list[Trace]:
    """What a slow change would give, without heat or beside walls of one temperature; of species of one size."""
    geometry, warmth = start.geometry, temperature(start.state, start.geometry)
    sizes = {radii(start.scenario)[species] for species in np.unique(start.state.species)}
    if start.scenario.molecules or not isinstance(geometry, Enclosure) or not warmth:
        return []
    if len(sizes) != 1 or any(geometry.gravity):
        return []
    warm = {wall.temperature for wall in geometry.walls if wall.temperature is not None}
    if len(warm) > 1 or any(wall.open for wall in geometry.walls):
        return []
    low, high = float(np.min(areas)), float(np.max(areas))
    if high - low < 0.02 * high:
        return []
    x = np.linspace(low, high, 41)
    begun = geometry.at(start.state.wall_displacement).area
    if warm:
        name, y = "slow, isothermal", _isotherm(start, x, warm.pop())
    else:
        name = "slow, without heat"
        y = adiabat.adiabatic_pressure(x, warmth, start.state.count, float(sizes.pop()), begun)
    points = np.column_stack([x, np.asarray(y)])
    return [Trace(name, points, "theory", None, INK)] if np.all(np.isfinite(points)) else []


def _isotherm(start: Sample, areas: NDArray[np.float64], warmth: float) -> NDArray[np.float64]:
    counts = np.bincount(start.state.species, minlength=len(start.scenario.kinds))
    masses = [species.mass for species in start.scenario.kinds]
    gases = [mixture.Mixture.of(counts, masses, radii(start.scenario), float(area)) for area in areas]
    return np.array([mixture.pressure(gas, warmth) for gas in gases], np.float64)


def _moving(geometry: Geometry) -> int | None:
    if not isinstance(geometry, Enclosure) or not isinstance(geometry.container, Rectangle):
        return None
    return next((wall for wall in range(4) if geometry.walls[wall].motion is not None), None)
