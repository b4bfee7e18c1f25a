"""Studies of matter with forces: g(r), how far discs wander, phases and order."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np

from gasbox.app.aims import has_forces
from gasbox.app.look import REACH, mean_size, sizes_of
from gasbox.app.sample import Sample
from gasbox.app.studies_over_time import OverTime
from gasbox.app.study import INK, PHASE_COLORS, Axis, Picture, Trace
from gasbox.app.window import Lately
from gasbox.observe import (
    MeanSquaredDisplacement,
    RadialDistribution,
    diffusion_coefficient,
    hexatic_order,
    phase_shares,
    phases,
    rms_speed,
)
from gasbox.units import UNIT

__all__ = ["Order", "Pairs", "Wandering", "reach_of"]

_BINS: Final = 120
_FARTHEST: Final = 5.0
"""Of g(r), in units of sigma."""
_WINDOW: Final = 40
"""Samples over which g(r) is averaged at least, twice as many at most."""
_MOST_SPECIES: Final = 3
"""With more, only the g(r) of all discs is shown."""
_FASTEST: Final = 3.0
"""Times the root of the mean squared speed: hardly a disc is faster."""


def reach_of(sample: Sample) -> float:
    """How near neighbours are, in the mean over all discs [length]."""
    sizes = sizes_of(sample.scenario)
    counts = np.bincount(sample.state.species, minlength=len(sizes)).tolist()
    return REACH * mean_size(sizes, counts)


class Pairs:
    """The radial distribution function, averaged over the last samples; two averages take turns."""

    name, title = "pairs", "Radial distribution g(r)"
    is_light = False

    def __init__(self) -> None:
        self._key: tuple[object, ...] = ()
        self._averages: list[RadialDistribution] = []
        self._seen = 0
        self._sample: Sample | None = None

    def suits(self, sample: Sample) -> bool:
        """There are pairs."""
        return sample.state.count > 1

    def is_wanted(self, sample: Sample) -> bool:
        """There are forces."""
        return has_forces(sample.scenario)

    def take(self, sample: Sample, lately: Lately | None) -> None:
        """See `gasbox.app.study.Study`."""
        key = (sample.version, sample.geometry)
        if key != self._key:
            self._key, self._averages, self._seen = key, [self._fresh(sample)], 0
        elif self._sample is not None and sample.time == self._sample.time:
            return
        if self._seen == _WINDOW:
            self._averages, self._seen = [self._averages[-1], self._fresh(sample)], 0
        self._seen += 1
        self._sample = sample
        for average in self._averages:
            average.observe(sample.state, sample.tallies)

    @staticmethod
    def _fresh(sample: Sample) -> RadialDistribution:
        size = reach_of(sample) / REACH
        half = 0.5 * float(sample.geometry.at(sample.state.wall_displacement).size.min())
        farthest = float(f"{min(_FARTHEST * size, half):.3g}")
        return RadialDistribution(sample.geometry, len(sample.scenario.kinds), _BINS, farthest)

    def picture(self) -> Picture | None:
        """See `gasbox.app.study.Study`."""
        sample = self._sample
        if not self._averages or sample is None:
            return None
        found = self._averages[0].value()
        species = sample.scenario.kinds
        if 1 < len(species) <= _MOST_SPECIES:
            curves = [
                (f"{one.name}, {other.name}", found.g[a, a + b], str(one.color) if b == 0 else None)
                for a, one in enumerate(species)
                for b, other in enumerate(species[a:])
            ]
        else:
            curves = [("g(r)", found.whole, str(species[0].color) if len(species) == 1 else None)]
        end = round(float(found.r[0] + found.r[-1]), 9)  # half a bin further than the last middle
        traces = [
            Trace(name, np.column_stack([found.r, g]), "line", None, color)
            for name, g, color in curves
            if np.any(np.isfinite(g))
        ]
        traces.append(Trace("by chance", np.array([[0.0, 1.0], [end, 1.0]]), "theory", None, INK))
        distance = Axis(f"distance r  ({UNIT['position']})", 0.0, end)
        return Picture(distance, Axis("g(r)", 0.0), traces, f"{found.frames} samples")


class Wandering:
    """Mean squared displacement since the chart was opened."""

    name, title = "wandering", "Mean squared displacement"
    is_light = False

    def __init__(self) -> None:
        self._version = -1
        self._observer: MeanSquaredDisplacement | None = None
        self._last: float | None = None
        self._too_fast = False

    def suits(self, sample: Sample) -> bool:
        """There is a disc."""
        return sample.state.count > 0

    def is_wanted(self, sample: Sample) -> bool:
        """Only when it is chosen."""
        return False

    def take(self, sample: Sample, lately: Lately | None) -> None:
        """See `gasbox.app.study.Study`. What moves half-way round a box between two samples cannot be followed."""
        state = sample.state
        if self._last is not None and sample.version == self._version and state.time == self._last:
            return
        lost = self._last is None or state.time < self._last or sample.version != self._version
        if not lost and self._last is not None and np.any(sample.geometry.periodic):
            way = _FASTEST * (rms_speed(state) or 0.0) * (state.time - self._last)
            size = sample.geometry.at(state.wall_displacement).size
            self._too_fast = way > 0.5 * float(size[np.asarray(sample.geometry.periodic)].min())
            lost = self._too_fast
        if lost or self._observer is None:
            self._observer = MeanSquaredDisplacement(sample.geometry)
            self._observer.start(state, sample.tallies)
            self._version = sample.version
        else:
            self._observer.observe(state, sample.tallies)
        self._last = state.time

    def picture(self) -> Picture | None:
        """See `gasbox.app.study.Study`."""
        if self._observer is None:
            return None
        found = self._observer.value()
        stride = 1 + found.times.size // 400
        points = np.column_stack([found.times, found.msd])
        traces = [Trace("mean", np.vstack([points[:-1:stride], points[-1:]]), "line")]
        speed = diffusion_coefficient(found)
        fact = "" if speed is None else f"D ≈ {speed:.2g}"
        return Picture(
            Axis(f"time since it was first shown  ({UNIT['time']})"),
            Axis(f"squared distance  ({UNIT['area']})", 0.0),
            traces,
            "too fast to follow: slow down" if self._too_fast else fact,
        )


class Order(OverTime):
    """Shares of discs that are gas, liquid and solid, and the order of the whole."""

    name, title, unit, low = "order", "Phases and order", "share of all discs", 0.0

    def suits(self, sample: Sample) -> bool:
        """There are forces."""
        return has_forces(sample.scenario)

    is_wanted = suits

    def row(self, sample: Sample, lately: Lately | None) -> tuple[float, ...] | None:
        """Gas, liquid, solid, hexatic order."""
        if not sample.state.count:
            return None
        reach = reach_of(sample)
        found = phase_shares(phases(sample.state, sample.geometry, reach))
        return (*(float(share) for share in found), hexatic_order(sample.state, sample.geometry, reach))

    def curves(self, sample: Sample) -> list[tuple[str, str | None]]:
        """The colours are those of the discs."""
        named: list[tuple[str, str | None]] = list(PHASE_COLORS.items())
        return [*named, ("order", "var(--muted)")]

    def picture(self) -> Picture | None:
        """From 0 to 1, the order dashed."""
        whole = super().picture()
        if whole is None:
            return None
        *shares, order = whole.traces
        return replace(
            whole,
            y=Axis(self.unit, 0.0, 1.0),
            traces=[*shares, replace(order, kind="dashed")],
            fact="order: |ψ₆| of all",
        )
