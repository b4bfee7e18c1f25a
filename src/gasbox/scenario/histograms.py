"""How the histograms of the species are drawn."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, Strict

from gasbox.scenario.values import WHOLE, NotNegative, Positive, Section

__all__ = ["Histograms"]


class Histograms(Section):
    """Bins, range and quantity, the same for all species."""

    bins: Annotated[int, Strict(), Field(ge=1, le=1000), WHOLE] = 30
    """Number of bins."""
    minimum: NotNegative = 0.0
    """Lower end of the axis, in the quantity's unit."""
    maximum: Positive | None = None
    """Upper end of the axis, in the quantity's unit; without it, chosen from the gas."""
    quantity: Literal["speed", "energy"] = "speed"
    """What the axis shows."""
