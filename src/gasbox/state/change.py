"""What acts on a running gas from outside: plain values, made between two events, logged, replayed to the bit."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = [
    "Change",
    "Control",
    "MoveWall",
    "SetBarostat",
    "SetGravity",
    "SetHeating",
    "SetThermostat",
    "SetWall",
]


@dataclass(frozen=True)
class SetGravity:
    """A new acceleration of all discs.

    Attributes
    ----------
    gravity : [length/time²]
    """

    gravity: tuple[float, float]


@dataclass(frozen=True)
class SetWall:
    """A wall is taken away or put back, or gets another temperature.

    Attributes
    ----------
    wall : name
    present : whether it is there; None leaves it as it is
    temperature : of a thermal wall [energy]; None leaves it as it is
    free : whether a piston that was moved goes free again; None leaves it as it is
    """

    wall: str
    present: bool | None = None
    temperature: float | None = None
    free: bool | None = None


@dataclass(frozen=True)
class MoveWall:
    """A wall moves on from where it is, at a constant speed, and then rests.

    Attributes
    ----------
    wall : name
    displacement : where it goes, along its normal from its place at the start [length]
    speed : > 0 [length/time]
    origin : where it was when it set out [length]; filled in when the change is made
    """

    wall: str
    displacement: float
    speed: float
    origin: float | None = None


@dataclass(frozen=True)
class SetThermostat:
    """The thermostat gets another temperature, or is switched off.

    Attributes
    ----------
    temperature : that it aims at in the end [energy]; None switches it off
    over : time in which the aim goes there, evenly, from where it is [time]
    """

    temperature: float | None
    over: float = 0.0


@dataclass(frozen=True)
class SetBarostat:
    """The barostat gets another pressure, or is switched off.

    Attributes
    ----------
    pressure : that it aims at in the end [mass/time²]; None switches it off, and the area stays as it is
    over : time in which the aim goes there, evenly, from where it is [time]
    """

    pressure: float | None
    over: float = 0.0


@dataclass(frozen=True)
class SetHeating:
    """Heat is added at another rate.

    Attributes
    ----------
    power : for each particle [energy/time]; < 0 takes heat away, 0 switches it off
    """

    power: float


Control = SetThermostat | SetBarostat | SetHeating
"""What acts on a gas with forces as a whole."""

Change = SetGravity | SetWall | MoveWall | Control
