"""How figures look: ink, grid, labels with units. Made for paper as well as for a screen; no global state."""

from __future__ import annotations

from typing import Final, Literal

from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from gasbox.units import UNIT

__all__ = ["GRID", "INK", "KINETIC", "POTENTIAL", "QUIET", "darker", "dress", "label", "legend", "new_figure"]

INK: Final = "#1d2530"
"""Text, axes and curves of theory."""
QUIET: Final = "#5b6673"
"""Ticks and second-rank text."""
GRID: Final = "#dfe3e8"
KINETIC: Final = "#c2410c"
POTENTIAL: Final = "#0b6bcb"


def new_figure(width: float, height: float) -> Figure:
    """An empty figure of this size in inches, drawn by whatever writes it, without pyplot."""
    return Figure(figsize=(width, height), dpi=150, facecolor="white", layout="constrained")


def label(name: str, quantity: str, lines: int = 1) -> str:
    """An axis label with its unit, as in ``speed [length/time]``, on one line or two."""
    return f"{name}{' ' if lines == 1 else chr(10)}[{UNIT[quantity]}]"


def dress(axes: Axes) -> None:
    """Two axes lines, quiet ticks, a light grid behind the data."""
    axes.set_axisbelow(True)
    axes.grid(True, color=GRID, linewidth=0.7)
    axes.spines[["top", "right"]].set_visible(False)
    axes.spines[["left", "bottom"]].set_color(QUIET)
    axes.tick_params(colors=QUIET, labelsize=8, length=3)
    axes.xaxis.label.set(color=INK, fontsize=9)
    axes.yaxis.label.set(color=INK, fontsize=9)
    axes.title.set(color=INK, fontsize=10, fontweight="bold")


def legend(axes: Axes, beside: bool = False, place: Literal["upper right", "best"] = "upper right") -> None:
    """A legend in a corner (or where there is most room: best), or beside the axes where lines run all over."""
    if not axes.get_legend_handles_labels()[0]:
        return
    box = axes.legend(loc="upper left" if beside else place, fontsize=8, edgecolor=GRID, labelcolor=INK)
    if beside:
        box.set_bbox_to_anchor((1.0, 1.02))
        box.set_frame_on(False)


def darker(color: str, share: float = 0.65) -> tuple[float, float, float]:
    """The colour with its brightness cut to `share`: outlines and lines that stay visible on white paper."""
    red, green, blue = to_rgb(color)
    return red * share, green * share, blue * share
