"""What changes at a given time: gravity, a wall, what holds temperature and pressure, a setting of the world."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, Strict

from gasbox.scenario.baths import BarostatAim, Heating, NewPressure, NewTemperature, ThermostatAim
from gasbox.scenario.values import Finite, NotNegative, Positive, Section, Vector
from gasbox.state import (
    Change,
    MoveWall,
    SetBarostat,
    SetGravity,
    SetHeating,
    SetThermostat,
    SetWall,
    SetWorld,
)

__all__ = ["ScheduledChange"]


class ScheduledChange(Section):
    """One change: of `gravity`, `thermostat`, `barostat`, `heating`, a `setting`, or what becomes of a `wall`."""

    at: NotNegative
    """When [time]."""
    gravity: Vector | None = None
    """New acceleration of all discs [length/time²]."""
    thermostat: NewTemperature | None = None
    """Another temperature for the thermostat, or "off"."""
    barostat: NewPressure | None = None
    """Another pressure for the barostat, or "off"; then the area stays as it is."""
    heating: Heating | None = None
    """Heat is added at another rate."""
    setting: Annotated[str, Field(min_length=1, max_length=60)] | None = None
    """Name of a setting of the world, which gets `value`."""
    value: Annotated[bool, Strict()] | Finite | Annotated[str, Field(max_length=200)] | None = None
    """Of the setting: a number, a word, or true or false."""
    wall: Annotated[str, Field(min_length=1, max_length=60)] | None = None
    """Name of a wall."""
    present: bool | None = None
    """Take the wall (an obstacle) away, or put it back."""
    temperature: NotNegative | None = None
    """New temperature of the wall [energy]."""
    displacement: Finite | None = None
    """Move the wall there, along its normal from its place at the start [length]."""
    speed: Positive | None = None
    """Speed of that motion; without it, 1 [length/time]."""
    origin: Finite | None = None
    """Where the wall was when it set out [length]: stands in snapshots and recordings."""
    free: bool | None = None
    """Let a piston that was moved go free again."""

    def change(self) -> Change:
        """The value that the simulation applies."""
        if self.gravity is not None:
            return SetGravity(self.gravity)
        if self.thermostat is not None:
            aim = self.thermostat
            return SetThermostat(None) if aim == "off" else SetThermostat(aim.temperature, aim.over)
        if self.barostat is not None:
            goal = self.barostat
            return SetBarostat(None) if goal == "off" else SetBarostat(goal.pressure, goal.over)
        if self.heating is not None:
            return SetHeating(self.heating.power)
        if self.setting is not None:
            return SetWorld(self.setting, "" if self.value is None else self.value)
        wall = self.wall or ""
        if self.displacement is not None:
            return MoveWall(wall, self.displacement, self.speed or 1.0, self.origin)
        return SetWall(wall, self.present, self.temperature, self.free)

    @classmethod
    def of(cls, time: float, change: Change) -> ScheduledChange:
        """The entry that makes this change at this time."""
        match change:
            case SetGravity(gravity=gravity):
                return cls(at=time, gravity=gravity)
            case SetThermostat(temperature=None):
                return cls(at=time, thermostat="off")
            case SetThermostat(temperature=temperature, over=over):
                return cls(at=time, thermostat=ThermostatAim(temperature=temperature, over=over))
            case SetBarostat(pressure=None):
                return cls(at=time, barostat="off")
            case SetBarostat(pressure=pressure, over=over):
                return cls(at=time, barostat=BarostatAim(pressure=pressure, over=over))
            case SetHeating(power=power):
                return cls(at=time, heating=Heating(power=power))
            case SetWorld(name=name, value=value):
                return cls(at=time, setting=name, value=value)
            case MoveWall(wall=wall, displacement=displacement, speed=speed, origin=origin):
                return cls(at=time, wall=wall, displacement=displacement, speed=speed, origin=origin)
            case SetWall(wall=wall, present=present, temperature=temperature, free=free):
                return cls(at=time, wall=wall, present=present, temperature=temperature, free=free)
