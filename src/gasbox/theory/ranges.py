"""Where the axis of a histogram ends, when nobody says: a round number that follows from theory alone."""

from __future__ import annotations

import math
from typing import Final, Literal

from gasbox.theory.maxwell import energy_quantile, speed_quantile

__all__ = ["Measure", "Quantity", "histogram_maximum", "rounded_up"]

Quantity = Literal["speed", "energy"]
"""Of the motion of centres: what every particle has."""
Measure = Literal["speed", "energy", "angular-velocity", "rotational-energy", "whole-energy"]
"""And what molecules have beside it; the last is all of their kinetic energy."""

_STEPS: Final = (1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)
_SHARE: Final = 0.999
"""Share of the particles that the axis is to hold."""


def rounded_up(value: float) -> float:
    """The next number of 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten; `value` > 0."""
    power = math.floor(math.log10(value))
    # 10.0**power is inexact for negative powers; text gives the double nearest to the decimal number.
    for step in _STEPS:
        candidate = float(f"{step}e{power}")
        if candidate >= value:
            return candidate
    return float(f"1e{power + 1}")


def histogram_maximum(mass: float, temperature: float, quantity: Quantity = "speed") -> float | None:
    """Rounded end of the axis that holds 99.9 % of Maxwell's law; None at temperature zero."""
    if not temperature > 0.0:
        return None
    if quantity == "speed":
        return rounded_up(speed_quantile(_SHARE, mass, temperature))
    return rounded_up(energy_quantile(_SHARE, temperature))
