"""The heating curve: temperature against the heat that was added, coloured by what the gas is meanwhile."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.app.aims import Aims, aims_of, has_forces
from gasbox.app.sample import Sample
from gasbox.app.studies_of_matter import reach_of
from gasbox.app.study import INK, PHASE_COLORS, Axis, Picture, Trace
from gasbox.app.window import Lately
from gasbox.app.wording import number
from gasbox.observe import HeatingCourse, HeatingCurve, latent_heats, stretches
from gasbox.units import UNIT

__all__ = ["Heating", "turns"]

_TURNED: Final = 0.05
"""Share of all heat that must come back before it counts as cooling, or as heating again."""
_NOISE: Final = 0.1
"""And in units of the mean temperature: a gas that is left alone, or held, neither heats nor cools."""
_POINTS: Final = 400
"""Of the curve, at most; a chart has not many more pixels."""
_ROWS: Final = 1500
"""Rows, after which only every second sample is taken in, then every third."""
_BETWEEN: Final = "two phases"
_COOLING: Final = "cooling"


@dataclass(frozen=True)
class _Piece:
    """A part of the curve with one look."""

    name: str
    course: HeatingCourse


class Heating:
    """Follows heat and temperature from the start of the gas on, whoever heats it."""

    name, title = "heating", "Heating curve"
    is_light = True

    def __init__(self) -> None:
        self._key: tuple[object, ...] = ()
        self._observer: HeatingCurve | None = None
        self._rows = self._seen = 0
        self._names: list[str] = []

    def suits(self, sample: Sample) -> bool:
        """There are forces."""
        return has_forces(sample.scenario)

    def is_wanted(self, sample: Sample) -> bool:
        """It is heated or cooled, now or later."""
        scenario = sample.scenario
        if not has_forces(scenario):
            return False
        driven = any(entry.thermostat or entry.heating for entry in scenario.schedule)
        return driven or bool(scenario.heating is not None and scenario.heating.power)

    def take(self, sample: Sample, lately: Lately | None) -> None:
        """See `gasbox.app.study.Study`. Heat is counted at one pressure: with another one it begins anew."""
        pressure = _pressure(aims_of(sample.scenario, sample.changes))
        key = (sample.version, sample.geometry, pressure)
        if key != self._key or self._observer is None:
            self._key, self._rows, self._seen, self._names = key, 0, 0, []
            self._observer = HeatingCurve(sample.geometry, pressure, reach_of(sample))
        self._seen += 1
        if self._seen % (1 + self._rows // _ROWS) == 0:
            self._observer.observe(sample.state, sample.tallies)
            self._rows += 1

    def picture(self) -> Picture | None:
        """See `gasbox.app.study.Study`."""
        course = None if self._observer is None else self._observer.value()
        if course is None or course.time.size < 3:
            return None
        # The first row has the temperature that was drawn, before motion and forces have shared it.
        course = course.rows(slice(1, None))
        pieces = _pieces(course)
        for piece in pieces:
            if piece.name not in self._names:
                self._names.append(piece.name)
        stride = 1 + course.time.size // _POINTS
        traces = [_trace(name, pieces, stride) for name in self._names]
        return Picture(
            Axis("heat added per disc  (energy)"),
            Axis(f"temperature  ({UNIT['temperature']})", None),
            traces,
            _fact(course),
        )


def _pressure(aims: Aims) -> float:
    return 0.0 if aims.pressure is None else aims.pressure.goal


def turns(heat: NDArray[np.float64], least: float) -> list[int]:
    """Rows at which the heat turns from growing to shrinking and back, and both ends.

    Parameters
    ----------
    heat : (n,) float64 [energy]
    least : by how much it must turn [energy]
    """
    ends, best = [0], 0
    rising: bool | None = None
    for row in range(1, heat.size):
        step = heat[row] - heat[best]
        if rising is None:
            if abs(step) > least:
                rising, best = step > 0, row
        elif (step > 0) == rising:
            best = row
        elif abs(step) > least:
            ends.append(best)
            rising, best = not rising, row
    return [*ends, heat.size - 1]


def _pieces(course: HeatingCourse) -> list[_Piece]:
    """The curve from one turn to the next; where it is heated, also from one stretch to the next."""
    noise = _NOISE * float(np.nanmean(course.temperature))
    ends = turns(course.heat, max(_TURNED * float(np.ptp(course.heat)), noise))
    pieces = []
    for begin, end in itertools.pairwise(ends):
        part = course.rows(slice(begin, end + 1))
        if part.heat[-1] < part.heat[0]:
            pieces.append(_Piece(_COOLING, part))
            continue
        for stretch in stretches(part):
            name = stretch.name if stretch.name in PHASE_COLORS else _BETWEEN
            pieces.append(_Piece(name, part.rows(slice(stretch.begin, stretch.end + 1))))
    return pieces


def _trace(name: str, pieces: list[_Piece], stride: int) -> Trace:
    """All pieces of one name, with gaps between them."""
    rows = [np.zeros((0, 2))]
    for piece in pieces:
        if piece.name == name:
            course = np.column_stack([piece.course.heat, piece.course.temperature])
            rows += [course[:-1:stride], course[-1:], np.full((1, 2), np.nan)]
    points = np.vstack(rows)
    if name == _COOLING:
        return Trace(name, points, "dashed", None, INK)
    return Trace(name, points, "line", None, PHASE_COLORS.get(name, "var(--muted)"))


def _fact(course: HeatingCourse) -> str:
    """Latent heats per disc [energy], as far as the whole curve shows them."""
    found = {latent.name: latent.heat for latent in latent_heats(course)}
    return " · ".join(f"{name} {number(heat, 2)}" for name, heat in found.items())
