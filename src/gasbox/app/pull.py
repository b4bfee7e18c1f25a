"""The scale of the gravity control: half strength lays a gas of this temperature as deep as the box is high."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from gasbox.app.sample import Sample
from gasbox.observe import temperature
from gasbox.theory import gravity

__all__ = ["Pull", "unit_of"]

_STEEPNESS = 3.0
"""Strength goes with the cube, so that one control reaches from a faint tilt to a puddle on the floor."""


def unit_of(sample: Sample) -> float:
    """The gravity [length/time²] whose scale height is the height of the box, for the mean particle."""
    warmth = temperature(sample.state, sample.geometry)
    if not warmth:
        return sample.geometry.height / (100.0 * _interval(sample)) ** 2
    # T/(m g) = H is solved by g = T/(m H): the same expression with g and H exchanged.
    return gravity.scale_height(float(np.mean(sample.state.mass)), warmth, sample.geometry.height)


def _interval(sample: Sample) -> float:
    return sample.time / sample.frame if sample.frame else sample.scenario.frame_interval or 1.0


@dataclass(frozen=True)
class Pull:
    """Gravity as the control shows it.

    Attributes
    ----------
    strength : 0 to 1 within the control; more is possible by typing
    angle : direction [degrees], 0 to the right, counter-clockwise, so -90 is down
    """

    strength: float = 0.0
    angle: float = -90.0

    @classmethod
    def of(cls, vector: tuple[float, float], unit: float, angle: float = -90.0) -> Pull:
        """Of a vector [length/time²]; `angle` is kept where there is no gravity."""
        size = math.hypot(*vector)
        if size == 0.0:
            return cls(0.0, angle)
        return cls(0.5 * (size / unit) ** (1 / _STEEPNESS), math.degrees(math.atan2(vector[1], vector[0])))

    @classmethod
    def at(cls, x: float, y: float) -> Pull:
        """Of a place in the round pad of radius 1; near the middle there is none."""
        size = math.hypot(x, y)
        angle = round(math.degrees(math.atan2(y, x))) if size else -90
        upright = 90 * round(angle / 90)
        return cls(
            0.0 if size < 0.08 else min(size, 1.0), float(upright if abs(angle - upright) <= 4 else angle)
        )

    def vector(self, unit: float) -> tuple[float, float]:
        """Acceleration [length/time²], in three digits, so that it can be read and typed again."""
        size = float(f"{unit * (2.0 * self.strength) ** _STEEPNESS:.3g}")
        x, y = (round(size * part, 12) + 0.0 for part in (self._cos, self._sin))
        return x, y

    @property
    def place(self) -> tuple[float, float]:
        """Where it is in the pad of radius 1."""
        strength = min(self.strength, 1.0)
        return strength * self._cos, strength * self._sin

    @property
    def _cos(self) -> float:
        return math.cos(math.radians(self.angle))

    @property
    def _sin(self) -> float:
        return math.sin(math.radians(self.angle))
