"""Panels of who is on which side of a divider, how mixed both sides are, and where centres of mass are."""

from __future__ import annotations

from typing import Literal

import numpy as np
from matplotlib.axes import Axes

from gasbox.observe import CenterSeries, SideSeries
from gasbox.plots.panels import Species
from gasbox.plots.style import INK, darker, dress, label, legend

__all__ = ["draw_centers", "draw_mixing", "draw_sides"]


def draw_sides(axes: Axes, sides: SideSeries, species: Species) -> None:
    """Number of discs of each species on both sides of a line over time."""
    names = sides.line.sides
    for number, (name, color) in enumerate(species):
        for side, style in enumerate(("-", "--")):
            which = f"{name}, {names[side]}" if len(species) > 1 else names[side]
            row = sides.counts[:, number, side]
            axes.plot(sides.time, row, color=darker(color, 0.85), linewidth=1.3, linestyle=style, label=which)
    axes.set_title(f"{names[0]} and {names[1]}")
    axes.set_xlabel(label("time", "time"))
    axes.set_ylabel("discs")
    axes.set_ylim(bottom=0.0)
    dress(axes)
    legend(axes, place="best")


def draw_mixing(axes: Axes, sides: SideSeries) -> None:
    """Entropy of mixing over time, as a share of its greatest value."""
    axes.plot(sides.time, sides.mixing, color=INK, linewidth=1.5)
    axes.set_title("mixing")
    axes.set_xlabel(label("time", "time"))
    axes.set_ylabel("entropy of mixing\n[of its greatest]")
    axes.set_ylim(0.0, 1.05)
    dress(axes)


def draw_centers(axes: Axes, centers: CenterSeries, species: Species, axis: Literal["x", "y"] = "y") -> None:
    """Centre of mass of each species over time, along an axis."""
    column = 0 if axis == "x" else 1
    for number, (name, color) in enumerate(species):
        row = centers.species[:, number, column]
        axes.plot(centers.time, row, color=darker(color, 0.85), linewidth=1.4, label=name)
    if len(species) > 1:
        row = centers.whole[:, column]
        axes.plot(centers.time, row, color=INK, linewidth=1.2, linestyle="--", label="all")
    axes.set_title("centre of mass")
    axes.set_xlabel(label("time", "time"))
    axes.set_ylabel(label("height y" if axis == "y" else "x", "position"))
    _least_span(axes)
    dress(axes)
    if len(species) > 1:
        legend(axes, place="best")


def _least_span(axes: Axes) -> None:
    """A centre that hardly moves must not fill the axis with noise."""
    low, high = axes.get_ylim()
    middle = 0.5 * (low + high)
    if np.isfinite(middle) and high - low < 0.1 * abs(middle):
        axes.set_ylim(middle - 0.05 * abs(middle), middle + 0.05 * abs(middle))
