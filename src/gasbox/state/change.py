"""What acts on a running gas from outside: plain values, made between two events, logged, replayed to the bit."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "Change",
    "Control",
    "MoveWall",
    "ParticleChange",
    "RemoveParticles",
    "Reply",
    "SetBarostat",
    "SetGate",
    "SetGravity",
    "SetHeating",
    "SetParticles",
    "SetThermostat",
    "SetWalkers",
    "SetWall",
    "SetWorld",
    "Surrounding",
    "Way",
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


@dataclass(frozen=True)
class SetWorld:
    """A setting of the world gets another value.

    Attributes
    ----------
    name : of the setting; the world says which there are
    value : a number, a word, or whether
    """

    name: str
    value: float | str | bool


Change = SetGravity | SetWall | MoveWall | Control | SetWorld
"""What may be asked for from outside: by the schedule of a scenario, or live. It is logged."""


@dataclass(frozen=True)
class Way:
    """Who passes a wall in one direction.

    Attributes
    ----------
    species : indices of the kinds that pass; None for all
    least_speed, greatest_speed : [length/time], speeds that pass
    """

    species: tuple[int, ...] | None = None
    least_speed: float = 0.0
    greatest_speed: float = math.inf


@dataclass(frozen=True)
class SetGate:
    """Others pass a wall than before; only a world does that.

    Attributes
    ----------
    wall : name
    forward, backward : who passes along its normal, and against it; None for nobody
    """

    wall: str
    forward: Way | None = None
    backward: Way | None = None


Surrounding = SetGravity | SetWall | MoveWall | SetGate
"""What changes the surroundings of the gas."""


@dataclass(frozen=True, eq=False)
class SetParticles:
    """Particles are put elsewhere, fly otherwise, or become another kind; only a world does that.

    Attributes
    ----------
    ids : (k,) int64, each once
    position : (k, 2) float64 [length]; None leaves them where they are. Hard discs that would overlap are moved apart,
        and so are those that forces would push extremely
    velocity : (k, 2) float64 [length/time]; None leaves it
    species : (k,) int32, index of a kind, whose mass and radius they get; None leaves it
    """

    ids: NDArray[np.int64]
    position: NDArray[np.float64] | None = None
    velocity: NDArray[np.float64] | None = None
    species: NDArray[np.int32] | None = None


@dataclass(frozen=True, eq=False)
class RemoveParticles:
    """Particles are taken out of the gas for good; only a world does that.

    Attributes
    ----------
    ids : (k,) int64
    """

    ids: NDArray[np.int64]


ParticleChange = SetParticles | RemoveParticles
"""What becomes of single particles. It follows from the run itself, so it is not logged."""


@dataclass(frozen=True, eq=False)
class SetWalkers:
    """People walk otherwise from now on; only a world does that, and it follows from the run itself.

    Attributes
    ----------
    ids : (k,) int64, each once
    place : (k,) int64, row of the table of places in which they walk; None leaves it
    target : (k, 2) float64 [length], to which they go first, straight through walls; None leaves it
    distancing : (k,) float64, how firmly they keep away from others; None leaves it
    pace : (k,) float64, factor on their speed; None leaves it
    """

    ids: NDArray[np.int64]
    place: NDArray[np.int64] | None = None
    target: NDArray[np.float64] | None = None
    distancing: NDArray[np.float64] | None = None
    pace: NDArray[np.float64] | None = None


Reply = Surrounding | ParticleChange | SetWalkers
"""What a world may answer with."""
