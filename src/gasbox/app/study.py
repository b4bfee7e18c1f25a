"""What a study of the gas is: what it takes from each sample, and what it shows of it. Without any page."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from gasbox.app.sample import Sample
from gasbox.app.window import Lately
from gasbox.scenario import Scenario

__all__ = ["INK", "PALETTE", "PHASE_COLORS", "Axis", "Picture", "Study", "Trace", "radii"]

INK = "var(--ink)"
"""Colour of theory, as the style sheet has it."""
PALETTE = ("#2457d6", "#d1495b", "#2a9d8f", "#b8741a", "#7b4fb5", "#5f6b7a", "#1b9ad6", "#a23e48")
"""Colours of what belongs to no species; read on light and dark."""

PHASE_COLORS = {name: f"var(--gasbox-{name})" for name in ("gas", "liquid", "solid")}
"""Those of the discs (`frontend/core/theme.js`)."""


@dataclass(frozen=True)
class Trace:
    """One curve or one row of bars.

    Attributes
    ----------
    points : (n, 2) float64, x and y; of bars, x counts the labels
    kind : how it is drawn; ``theory`` is a thin dashed line under the others, ``level`` one over bars, all across
        and as high as its first point
    error : (n,) float64, standard errors, or None
    color : or None for one of the palette
    """

    name: str
    points: NDArray[np.float64]
    kind: Literal["line", "dashed", "points", "bars", "theory", "level"] = "line"
    error: NDArray[np.float64] | None = None
    color: str | None = None


@dataclass(frozen=True)
class Axis:
    """Name with unit; from where to where it reaches at least, None to let the values decide."""

    name: str
    low: float | None = None
    high: float | None = None
    labels: tuple[str, ...] = ()


@dataclass(frozen=True)
class Picture:
    """All of a study at one moment; `fact` stands beside the title.

    Where it is `gliding`, what is shown goes evenly to its next place.
    """

    x: Axis
    y: Axis
    traces: list[Trace] = field(default_factory=list)
    fact: str = ""
    gliding: bool = False


class Study(Protocol):
    """A chart beside the histograms: it takes in samples one after the other, and pictures what it found."""

    name: str
    """Short, without blanks: for memory and tests."""
    title: str
    is_light: bool
    """Whether it takes in samples also while it is not shown, so that its past is there when it is."""

    def suits(self, sample: Sample) -> bool:
        """Whether it can say anything about this gas."""
        ...

    def is_wanted(self, sample: Sample) -> bool:
        """Whether it is shown before anybody has chosen: the gas is about this."""
        ...

    def take(self, sample: Sample, lately: Lately | None) -> None:
        """Take in a sample; of another gas than before (`Sample.version`), begin anew."""
        ...

    def picture(self) -> Picture | None:
        """What to show; None before there is anything."""
        ...


def radii(scenario: Scenario) -> NDArray[np.float64]:
    """(kinds,) float64 [length]: how far each reaches from its centre, in the mean over all directions."""
    return np.array([kind.half_width for kind in scenario.kinds], np.float64)
