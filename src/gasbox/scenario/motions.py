"""How a wall moves: by a schedule, or freely as a piston. Displacements count along the normal of the wall.

The normal of the left and right side of a rectangle is +x, of the bottom and top +y; that of a segment points to the
right of the way from its first end to its second.
"""

from __future__ import annotations

import math
from typing import Annotated, Final, Literal

from pydantic import ConfigDict, Field
from pydantic.config import JsonDict

from gasbox.geometry import Path, Piston, Sinusoid
from gasbox.scenario.values import Finite, NotNegative, Positive, Section, Vector

__all__ = ["ConstantMotion", "Motion", "PathMotion", "PistonMotion", "SinusoidMotion"]

_KIND_REQUIRED: Final[JsonDict] = {"required": ["kind"]}


class ConstantMotion(Section):
    """At constant speed, from a time on, perhaps until another."""

    model_config = ConfigDict(json_schema_extra=_KIND_REQUIRED)

    kind: Literal["constant"] = "constant"
    """Kind of motion."""
    speed: Finite
    """Speed along the normal [length/time]."""
    start: NotNegative = 0.0
    """When it sets out [time]."""
    stop: Positive | None = None
    """When it comes to rest [time]; without it, never."""

    def motion(self) -> Path:
        """As engines take it."""
        if self.stop is None:
            return Path((self.start,), (0.0,), (self.speed,))
        way = self.speed * (self.stop - self.start)
        return Path((self.start, self.stop), (0.0, way), (self.speed, 0.0))


class PathMotion(Section):
    """Along straight lines between given displacements; at rest before the first and after the last."""

    model_config = ConfigDict(json_schema_extra=_KIND_REQUIRED)

    kind: Literal["path"] = "path"
    """Kind of motion."""
    points: Annotated[tuple[Vector, ...], Field(min_length=1, max_length=10_000)]
    """[time, displacement], in ascending order of time [time, length]; the first displacement is 0."""

    def motion(self) -> Path:
        """As engines take it."""
        times, places = (tuple(column) for column in zip(*self.points, strict=True))
        speeds = [(places[k + 1] - places[k]) / (times[k + 1] - times[k]) for k in range(len(times) - 1)]
        return Path(times, places, (*speeds, 0.0))


class SinusoidMotion(Section):
    """To and fro: amplitude * (sin(2 pi time / period + phase) - sin(phase))."""

    model_config = ConfigDict(json_schema_extra=_KIND_REQUIRED)

    kind: Literal["sinusoid"] = "sinusoid"
    """Kind of motion."""
    amplitude: Finite
    """[length]."""
    period: Positive
    """[time]."""
    phase: Finite = 0.0
    """[radian]."""

    def motion(self) -> Sinusoid:
        """As engines take it."""
        return Sinusoid(self.amplitude, self.period, self.phase)


class PistonMotion(Section):
    """Free to move: pushed by the gas, by the pressure outside and by gravity."""

    model_config = ConfigDict(json_schema_extra=_KIND_REQUIRED)

    kind: Literal["piston"] = "piston"
    """Kind of motion."""
    mass: Positive
    """Mass of the piston [mass]."""
    pressure: Finite = 0.0
    """Pressure outside [mass/time²]: times the wall's length, a force on it. Of a side of the container it pushes
    inwards; of a divider, against its normal."""
    speed: Finite = 0.0
    """Speed along the normal at the start [length/time]."""
    stops: tuple[Finite, Finite] | None = None
    """Least and greatest displacement, where it bounces elastically [length]; without them, only the container's
    other walls stop it."""

    def motion(self) -> Piston:
        """As engines take it."""
        lower, upper = self.stops if self.stops is not None else (-math.inf, math.inf)
        return Piston(self.mass, self.pressure, self.speed, lower, upper)


Motion = Annotated[ConstantMotion | PathMotion | SinusoidMotion | PistonMotion, Field(discriminator="kind")]
