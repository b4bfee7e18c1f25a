"""Studies whose horizontal axis is time: energy, centres of mass, sides and mixing, flow."""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np

from gasbox.app.directions import axis_of
from gasbox.app.history import History
from gasbox.app.sample import Sample
from gasbox.app.study import INK, PALETTE, Axis, Picture, Trace
from gasbox.app.window import Lately
from gasbox.geometry import Enclosure, Rectangle, Segment, side_count
from gasbox.observe import (
    Line,
    center_of_mass,
    greatest_mixing_entropy,
    kinetic_energy,
    mixing_entropy,
    passage_rates,
    potential_energy,
    side_counts,
)
from gasbox.units import UNIT

__all__ = ["Centers", "Energy", "Flow", "Mixing", "Sides", "divider"]

_TIME = Axis(f"time  ({UNIT['time']})")


class OverTime:
    """Keeps a row of numbers for each sample.

    Attributes
    ----------
    history : rows as `row` returns them
    """

    name = title = unit = ""
    low: float | None = None
    is_light = True

    def __init__(self) -> None:
        self.history = History()
        self._version = -1
        self._sample: Sample | None = None

    def suits(self, sample: Sample) -> bool:
        """See `gasbox.app.study.Study`."""
        return True

    def is_wanted(self, sample: Sample) -> bool:
        """See `gasbox.app.study.Study`."""
        return False

    def row(self, sample: Sample, lately: Lately | None) -> tuple[float, ...] | None:
        """What to keep of a sample; None for nothing."""
        raise NotImplementedError

    def curves(self, sample: Sample) -> list[tuple[str, str | None]]:
        """Name and colour of each number of a row."""
        raise NotImplementedError

    def take(self, sample: Sample, lately: Lately | None) -> None:
        """See `gasbox.app.study.Study`."""
        if sample.version != self._version:
            self.history, self._version = History(), sample.version
        self._sample = sample
        row = self.row(sample, lately)
        if row is not None:
            self.history.add(sample.time, row)

    def picture(self) -> Picture | None:
        """See `gasbox.app.study.Study`."""
        if self._sample is None or len(self.history.time) < 2:
            return None
        curves = self.curves(self._sample)
        traces = [
            Trace(name, self.history.column(number), color=color)
            for number, (name, color) in enumerate(curves)
        ]
        return Picture(_TIME, Axis(self.axis(self._sample), self.low), traces, self.fact(self._sample))

    def axis(self, sample: Sample) -> str:
        """Name of the vertical axis."""
        return self.unit

    def fact(self, sample: Sample) -> str:
        """A few words beside the title."""
        return ""


def _species(sample: Sample) -> list[tuple[str, str | None]]:
    return [(species.name, str(species.color)) for species in sample.scenario.kinds]


class Energy(OverTime):
    """What the gas has, and what walls, a thermostat, heating and a barostat have given it."""

    name, title, unit = "energy", "Energy, work and heat", f"energy  ({UNIT['energy']})"

    def is_wanted(self, sample: Sample) -> bool:
        """Walls work or heat."""
        geometry = sample.geometry
        return isinstance(geometry, Enclosure) and (
            geometry.moves or any(wall.temperature is not None for wall in geometry.walls)
        )

    def row(self, sample: Sample, lately: Lately | None) -> tuple[float, ...]:
        """Kinetic, potential, both; then what was given, one after the other."""
        tallies = sample.tallies
        kinetic = kinetic_energy(sample.state)
        potential = potential_energy(sample.state, sample.geometry)
        return (
            kinetic,
            potential,
            kinetic + potential if potential else 0.0,
            float(tallies.wall_work.sum()),
            float(tallies.wall_heat.sum()),
            float(tallies.wall_carried.sum()),
            float(tallies.thermostat_heat[0]),
            float(tallies.heater_heat[0]),
            float(tallies.barostat_work[0]),
        )

    def curves(self, sample: Sample) -> list[tuple[str, str | None]]:
        """All of them; those that are always zero are left out by `picture`."""
        had = ("kinetic", "potential", "total")
        given = ("work of walls", "heat of walls", "carried away")
        baths = ("heat of thermostat", "heating", "work of barostat")
        return [(name, None) for name in (*had, *given, *baths)]

    def picture(self) -> Picture | None:
        """Without what is always zero."""
        whole = super().picture()
        if whole is None:
            return None
        told = [
            replace(trace, color=color)
            for trace, color in zip(whole.traces, itertools.cycle(PALETTE), strict=False)
            if trace.name == "kinetic" or np.any(trace.points[:, 1])
        ]
        return Picture(whole.x, whole.y, told, whole.fact)


class Centers(OverTime):
    """Centre of mass of each species along the axis of the profiles."""

    name, title = "centers", "Centre of mass"

    def row(self, sample: Sample, lately: Lately | None) -> tuple[float, ...]:
        """One coordinate for each species."""
        along = "xy".index(axis_of(sample))
        found = [
            center_of_mass(sample.state, sample.geometry, species)
            for species in range(len(sample.scenario.kinds))
        ]
        return tuple(np.nan if center is None else float(center[along]) for center in found)

    def curves(self, sample: Sample) -> list[tuple[str, str | None]]:
        """One for each species."""
        return _species(sample)

    def axis(self, sample: Sample) -> str:
        """Which coordinate."""
        return f"{axis_of(sample)} of the centre  ({UNIT['position']})"


def divider(sample: Sample) -> tuple[Line, int | None]:
    """The line that parts the gas: the first segment, there or not, else the middle; and the index of its wall."""
    geometry = sample.geometry
    if isinstance(geometry, Enclosure):
        first = side_count(geometry.container)
        for number, obstacle in enumerate(geometry.obstacles, first):
            if isinstance(obstacle, Segment):
                moved = sample.state.wall_displacement
                way = float(moved[number]) if moved.size else 0.0
                return Line.of_segment(obstacle.start, obstacle.end, way), number
    box = geometry.at(sample.state.wall_displacement) if isinstance(geometry, Rectangle) else geometry
    return Line((0.5 * box.width, 0.0), (1.0, 0.0)), None


def _is_divided(sample: Sample) -> bool:
    return divider(sample)[1] is not None


class Sides(OverTime):
    """How many of each species are on either side of the divider, or of the middle."""

    name, title, unit, low = "sides", "On both sides", "number of particles", 0.0

    def is_wanted(self, sample: Sample) -> bool:
        """There is a divider."""
        return _is_divided(sample)

    def row(self, sample: Sample, lately: Lately | None) -> tuple[float, ...]:
        """Behind and ahead, species by species."""
        line, _ = divider(sample)
        counts = side_counts(sample.state, line, len(sample.scenario.kinds))
        return tuple(float(count) for count in counts.ravel())

    def curves(self, sample: Sample) -> list[tuple[str, str | None]]:
        """Two for each species."""
        sides = divider(sample)[0].sides
        shades = ("", "88")
        return [
            (f"{name}, {side}", f"{color}{shade}")
            for name, color in _species(sample)
            for side, shade in zip(sides, shades, strict=True)
        ]


class Mixing(OverTime):
    """Entropy of mixing on the two sides."""

    name, title, unit, low = "mixing", "Entropy of mixing", "entropy  (k_B)", 0.0

    def suits(self, sample: Sample) -> bool:
        """There is something to mix."""
        return len(sample.scenario.kinds) > 1

    def is_wanted(self, sample: Sample) -> bool:
        """There is a divider, and something to mix."""
        return self.suits(sample) and _is_divided(sample)

    def row(self, sample: Sample, lately: Lately | None) -> tuple[float, ...]:
        """Entropy, and the greatest that it can have."""
        counts = side_counts(sample.state, divider(sample)[0], len(sample.scenario.kinds))
        return mixing_entropy(counts), greatest_mixing_entropy(counts)

    def curves(self, sample: Sample) -> list[tuple[str, str | None]]:
        """What it is, and could be."""
        return [("entropy", None), ("fully mixed", INK)]


class Flow(OverTime):
    """How many pass a line, a membrane or an open wall, per time, over the last seconds."""

    name, title, low = "flow", "Flow through openings", 0.0
    unit = f"particles per time  ({UNIT['rate']})"

    def suits(self, sample: Sample) -> bool:
        """There is something that can be passed."""
        return bool(_gates(sample))

    is_wanted = suits

    def row(self, sample: Sample, lately: Lately | None) -> tuple[float, ...] | None:
        """Along the normal and against it, gate by gate; of an open wall, all that leave."""
        rates = None if lately is None else passage_rates(lately.change, lately.duration)
        if rates is None:
            return None
        both = rates.sum(axis=1)
        return tuple(
            float(rate)
            for gate in _gates(sample)
            for rate in ((both[gate].sum(),) if _is_open(sample, gate) else both[gate])
        )

    def curves(self, sample: Sample) -> list[tuple[str, str | None]]:
        """Two for each gate, one for each open wall."""
        names = sample.geometry.wall_names
        return [
            (f"{names[gate]}, {way}", None)
            for gate in _gates(sample)
            for way in (("leaving",) if _is_open(sample, gate) else _ways(sample, gate))
        ]


def _is_open(sample: Sample, wall: int) -> bool:
    assert isinstance(sample.geometry, Enclosure)
    return sample.geometry.walls[wall].open


def _ways(sample: Sample, wall: int) -> tuple[str, str]:
    """Where the normal of a wall points, and the other way."""
    assert isinstance(sample.geometry, Enclosure)
    x, y = sample.geometry.normal(wall)
    if x == y == 0.0:
        return "out", "in"
    words = ("to the right", "to the left") if abs(x) >= abs(y) else ("up", "down")
    return words if (x if abs(x) >= abs(y) else y) > 0 else words[::-1]


def _gates(sample: Sample, most: int = 4) -> list[int]:
    geometry = sample.geometry
    if not isinstance(geometry, Enclosure):
        return []
    return [index for index, wall in enumerate(geometry.walls) if wall.open or wall.passes is not None][:most]
