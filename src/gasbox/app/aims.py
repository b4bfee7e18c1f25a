"""What thermostat, barostat and heating aim at now, from the scenario and from what was changed since."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from gasbox.geometry import Enclosure, Geometry, Rectangle
from gasbox.scenario import Forced, Scenario, starting_temperature
from gasbox.state import Change, SetBarostat, SetHeating, SetThermostat

if TYPE_CHECKING:
    from gasbox.app.sample import Sample

__all__ = [
    "Aim",
    "Aims",
    "aims_of",
    "can_have_barostat",
    "has_forces",
    "power_unit",
    "walls_come",
    "walls_move",
]

_SECONDS: Final = 10.0
"""For which one must heat by hand, at speed 1, until each disc has the energy that holds a pair together."""
_FRAMES_PER_SECOND: Final = 60.0


@dataclass(frozen=True)
class Aim:
    """A value that goes evenly from `start` to `goal`, beginning at a time and taking so long [time]."""

    goal: float
    start: float = 0.0
    begin: float = 0.0
    over: float = 0.0

    def at(self, time: float) -> float:
        """Where it is at a time."""
        share = (time - self.begin) / self.over if self.over > 0.0 else 1.0
        return self.start + min(max(share, 0.0), 1.0) * (self.goal - self.start)


@dataclass(frozen=True)
class Aims:
    """All of them; None where one is switched off.

    Attributes
    ----------
    temperature : [energy]
    pressure : [mass/time²]
    power : for each particle [energy/time]
    """

    temperature: Aim | None = None
    pressure: Aim | None = None
    power: float = 0.0


def aims_of(scenario: Scenario, changes: Sequence[tuple[float, Change]]) -> Aims:
    """The aims after these changes (time [time], change), the latest last."""
    temperature = pressure = None
    if scenario.thermostat is not None:
        goal = scenario.thermostat.temperature
        if goal is None:
            goal = starting_temperature(scenario.kinds)
        temperature = None if goal is None else Aim(float(goal))
    if scenario.barostat is not None:
        pressure = Aim(float(scenario.barostat.pressure))
    power = 0.0 if scenario.heating is None else float(scenario.heating.power)
    for time, change in changes:
        match change:
            case SetThermostat(temperature=goal, over=over):
                temperature = _led(temperature, goal, time, over)
            case SetBarostat(pressure=goal, over=over):
                pressure = _led(pressure, goal, time, over)
            case SetHeating(power=power):
                pass
    return Aims(temperature, pressure, power)


def _led(aim: Aim | None, goal: float | None, time: float, over: float) -> Aim | None:
    """An aim that goes on from where another one is."""
    if goal is None:
        return None
    return Aim(goal, goal if aim is None else aim.at(time), time, over)


def has_forces(scenario: Scenario) -> bool:
    """Whether discs attract or repel each other at a distance."""
    return isinstance(scenario.dynamics, Forced)


def walls_move(scenario: Scenario) -> bool:
    """Whether walls can move: under forces, those of molecules stay where they are."""
    return not has_forces(scenario) or all(len(kind.sites) == 1 for kind in scenario.kinds)


def walls_come(scenario: Scenario) -> bool:
    """Whether walls can come and go: not if they also push back smoothly."""
    smooth = scenario.forces is not None and scenario.forces.walls == "repulsive"
    return walls_move(scenario) and not smooth


def can_have_barostat(scenario: Scenario, geometry: Geometry) -> bool:
    """Whether the box can be rescaled: it has forces, no walls, and nothing in it."""
    box = geometry.container if isinstance(geometry, Enclosure) else geometry
    is_bare = not isinstance(geometry, Enclosure) or not geometry.obstacles
    return has_forces(scenario) and isinstance(box, Rectangle) and not box.is_walled and is_bare


def power_unit(sample: Sample) -> float:
    """Power by which the hand heats each particle [energy/time]."""
    scenario = sample.scenario
    depths = [1.0 if disc.epsilon is None else float(disc.epsilon) for disc in scenario.site_kinds]
    counts = [max(kind.count, 1) for kind in scenario.kinds]
    deep = [sum(depths[site] for site in kind.sites) for kind in scenario.kinds]
    energy = sum(depth * count for depth, count in zip(deep, counts, strict=True)) / sum(counts)
    return float(f"{(energy or 1.0) / (_SECONDS * _FRAMES_PER_SECOND * sample.frame_interval):.2g}")
