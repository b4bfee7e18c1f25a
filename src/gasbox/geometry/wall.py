"""What a wall is apart from its shape: its name, who passes it, how warm it is, and how it moves."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Literal

__all__ = ["Gate", "Motion", "Passage", "Path", "Piston", "Sinusoid", "Wall", "lets_everybody_pass"]


@dataclass(frozen=True)
class Passage:
    """Who passes a wall as if it were not there, and is counted; everybody else bounces.

    Attributes
    ----------
    species : indices of the species that pass; None for all
    direction : "forward" along the normal of the wall, "backward" against it, or "both"
    least_speed, greatest_speed : [length/time], speeds that pass
    """

    species: tuple[int, ...] | None = None
    direction: Literal["both", "forward", "backward"] = "both"
    least_speed: float = 0.0
    greatest_speed: float = math.inf

    @property
    def ways(self) -> tuple[Passage | None, Passage | None]:
        """The rule forward and backward; None where nobody passes."""
        return (
            None if self.direction == "backward" else self,
            None if self.direction == "forward" else self,
        )


@dataclass(frozen=True)
class Gate:
    """Who passes a wall, with a rule for each direction; everybody else bounces.

    Attributes
    ----------
    forward, backward : the rule along the normal of the wall and against it, whose own `direction` says nothing;
        None for nobody
    """

    forward: Passage | None = None
    backward: Passage | None = None

    @property
    def ways(self) -> tuple[Passage | None, Passage | None]:
        """The rule forward and backward; None where nobody passes."""
        return self.forward, self.backward


def lets_everybody_pass(passage: Passage | Gate | None, species: int | None = None) -> bool:
    """Whether all discs (or all of one species) pass, whatever their speed and direction."""
    return passage is not None and all(_lets_all(way, species) for way in passage.ways)


def _lets_all(way: Passage | None, species: int | None) -> bool:
    if way is None:
        return False
    named = way.species is None or (species is not None and species in way.species)
    return named and way.least_speed == 0.0 and math.isinf(way.greatest_speed)


@dataclass(frozen=True)
class Path:
    """A displacement that is linear in time, piece by piece.

    Attributes
    ----------
    times : (k,) ascending, where the pieces begin [time]
    displacements : (k,) where the wall is then [length]; before the first it rests there
    speeds : (k,) with which it goes on from there [length/time]
    """

    times: tuple[float, ...]
    displacements: tuple[float, ...]
    speeds: tuple[float, ...]

    def piece(self, time: float) -> tuple[float, float, float]:
        """Displacement and speed at `time`, just after a corner if it is one, and when the next piece begins."""
        number = sum(begin <= time for begin in self.times) - 1
        after = self.times[number + 1] if number + 1 < len(self.times) else math.inf
        if number < 0:
            return self.displacements[0], 0.0, after
        speed = self.speeds[number]
        return self.displacements[number] + speed * (time - self.times[number]), speed, after


@dataclass(frozen=True)
class Sinusoid:
    """A displacement A (sin(2 pi t / period + phase) - sin(phase)), zero at time zero.

    Attributes
    ----------
    amplitude : A [length]
    period : [time]
    phase : [radian]
    """

    amplitude: float
    period: float
    phase: float = 0.0

    @property
    def frequency(self) -> float:
        """2 pi / period [1/time]."""
        return 2.0 * math.pi / self.period


@dataclass(frozen=True)
class Piston:
    """A wall that is free to move along its normal, pushed by the gas, by a constant force, and by gravity.

    Attributes
    ----------
    mass : [mass]
    pressure : of the outside [mass/time²]; times the length of the wall, against its displacement
    speed : at the start [length/time]
    lower, upper : stops, as displacements [length], from which it bounces elastically
    """

    mass: float
    pressure: float = 0.0
    speed: float = 0.0
    lower: float = -math.inf
    upper: float = math.inf


Motion = Path | Sinusoid | Piston


@dataclass(frozen=True)
class Wall:
    """One wall: a side of the container, or an obstacle with all its sides and corners.

    Attributes
    ----------
    name : each wall has its own
    temperature : of a thermal wall, which re-emits with the half-Maxwellian flux distribution [energy];
        None for a smooth elastic one
    open : whether a disc whose centre reaches it leaves the gas, and is counted
    passes : who passes; None for nobody
    motion : displacement along its normal over time; None for a wall at rest
    present : whether it is there at all; one that is not lets everybody pass and counts nobody
    soft : whether it came while discs may have stood in its place: who overlaps it is let go on
    """

    name: str
    temperature: float | None = None
    open: bool = False
    passes: Passage | Gate | None = None
    motion: Motion | None = field(default=None)
    present: bool = True
    soft: bool = False
