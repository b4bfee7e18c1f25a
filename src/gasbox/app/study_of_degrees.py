"""Mean energies of the degrees of freedom of each kind of particle, which level out at T/2."""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.app.sample import Sample
from gasbox.app.study import INK, Axis, Picture, Trace
from gasbox.app.window import Lately
from gasbox.app.wording import number
from gasbox.observe import rotational_temperature, temperature, thermal_velocity, vibrational_temperature
from gasbox.scenario import Kind
from gasbox.state import State
from gasbox.theory.ranges import rounded_up
from gasbox.units import UNIT

__all__ = ["Degrees", "bond_energies", "degree_energies"]

_LABELS: Final = ("x", "y", "rotation", "vibration", "bonds")
_RIGID: Final = 3
"""So many of the labels go for rigid molecules."""
_SAMPLES: Final = 4
"""Over which means are taken: a second."""


def degree_energies(sample: Sample, kind: int) -> NDArray[np.float64]:
    """(5, 2) float64 [energy]: mean energy of a degree of freedom of one kind, and its standard error.

    Flight along x and y, rotation, vibration, and what the bonds hold; NaN where there is none.
    """
    state, geometry = sample.state, sample.geometry
    mine = state.species == kind
    count = int(np.count_nonzero(mine))
    found = np.full((len(_LABELS), 2), np.nan)
    if count == 0:
        return found
    flight = 0.5 * state.mass[mine, None] * thermal_velocity(state, geometry)[mine] ** 2
    found[:2, 0] = flight.mean(axis=0)
    for place, warmth, each in (
        (2, rotational_temperature(state, geometry, kind), 1),
        (3, vibrational_temperature(state, kind), _inner_degrees(sample.scenario.kinds[kind])),
    ):
        if warmth is not None:
            found[place, 0] = 0.5 * warmth
            found[place, 1] = each
    bonds = bond_energies(state, sample.scenario.kinds[kind], kind)
    if bonds is not None:
        found[4] = bonds.mean(), _held(sample.scenario.kinds[kind])
        found[4, 0] /= found[4, 1]
    # A squared normal variable varies by the root of 2 of its mean.
    found[:2, 1] = 1
    found[:, 1] = found[:, 0] * np.sqrt(2.0 / (count * found[:, 1]))
    return found


def _inner_degrees(kind: Kind) -> int:
    return 2 * len(kind.sites) - 3


def _held(kind: Kind) -> int:
    """How many degrees of freedom the bonds and angles hold."""
    return min(len(kind.bonds) + len(kind.angles), _inner_degrees(kind))


def bond_energies(state: State, kind: Kind, index: int) -> NDArray[np.float64] | None:
    """(count,) float64 [energy]: of elastic bonds and angles, for each molecule of a flexible kind; else None."""
    if state.sites is None or not kind.flexible:
        return None
    rows = np.nonzero(state.species == index)[0]
    place = state.sites.position[state.sites.first[rows][:, None] + np.arange(len(kind.sites))]
    total = np.zeros(rows.size)
    for bond in kind.bonds:
        a, b = bond.atoms
        length = np.hypot(*(place[:, a] - place[:, b]).T)
        total += 0.5 * (bond.stiffness or 0.0) * (length - (bond.length or 0.0)) ** 2
    for bend in kind.angles:
        one, middle, other = bend.atoms
        first, second = (place[:, one] - place[:, middle]).T, (place[:, other] - place[:, middle]).T
        cross, dot = first[0] * second[1] - first[1] * second[0], first[0] * second[0] + first[1] * second[1]
        total += (
            0.5 * bend.stiffness * (np.abs(np.arctan2(cross, dot)) - math.radians(bend.angle or 0.0)) ** 2
        )
    return total


@dataclass(frozen=True)
class _Moment:
    time: float
    energies: NDArray[np.float64]
    warmth: float


class Degrees:
    """Bars that level out: for each kind of particle one for each degree of freedom, and the line that all come to."""

    name, title = "degrees", "Degrees of freedom"
    is_light = True

    def __init__(self) -> None:
        self._version = -1
        self._seen: deque[_Moment] = deque(maxlen=_SAMPLES)
        self._sample: Sample | None = None
        self._top = 0.0

    def suits(self, sample: Sample) -> bool:
        """There are molecules that rotate."""
        return any(kind.inertia > 0.0 for kind in sample.scenario.kinds)

    is_wanted = suits

    def take(self, sample: Sample, lately: Lately | None) -> None:
        """See `gasbox.app.study.Study`."""
        if sample.version != self._version or (self._seen and sample.time < self._seen[-1].time):
            self._seen.clear()
            self._version, self._top = sample.version, 0.0
        self._sample = sample
        if self._seen and sample.time == self._seen[-1].time:
            return
        kinds = range(len(sample.scenario.kinds))
        energies = np.array([degree_energies(sample, kind) for kind in kinds])
        self._seen.append(_Moment(sample.time, energies, temperature(sample.state, sample.geometry) or 0.0))

    def picture(self) -> Picture | None:
        """See `gasbox.app.study.Study`."""
        if self._sample is None or not self._seen:
            return None
        kinds = self._sample.scenario.kinds
        shown = len(_LABELS) if any(kind.flexible for kind in kinds) else _RIGID
        energies = np.mean([moment.energies for moment in self._seen], axis=0)[:, :shown]
        level = 0.5 * float(np.mean([moment.warmth for moment in self._seen]))
        places = np.arange(shown, dtype=float)
        traces = [
            Trace(
                kind.name,
                np.column_stack([places, energies[index, :, 0]]),
                "bars",
                energies[index, :, 1],
                str(kind.color),
            )
            for index, kind in enumerate(kinds)
            if np.any(np.isfinite(energies[index, :, 0]))
        ]
        traces.insert(0, Trace("T/2", np.column_stack([places, np.full(shown, level)]), "level", None, INK))
        highest = max(float(np.nanmax(energies[:, :, 0], initial=0.0)), level)
        return Picture(
            Axis("", labels=_LABELS[:shown]),
            Axis(f"mean energy  ({UNIT['energy']})", 0.0, self._ceiling(highest)),
            traces,
            f"T/2 = {number(level)}",
            gliding=True,
        )

    def _ceiling(self, highest: float) -> float | None:
        """End of the axis: it grows at once, and comes down only when it is far too high."""
        wanted = rounded_up(1.1 * highest) if highest > 0.0 else 0.0
        if wanted > self._top or wanted < 0.5 * self._top:
            self._top = wanted
        return self._top or None
