"""Figures of speed or energy histograms, one panel for each species, with Maxwell's law over them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure
from numpy.typing import NDArray

from gasbox.observe import Histogram
from gasbox.plots.style import INK, darker, dress, label, legend, new_figure
from gasbox.theory.maxwell import expected_energy_counts, expected_speed_counts
from gasbox.theory.ranges import Quantity

__all__ = ["HistogramPanel", "draw_histograms", "histogram_figure", "theory_curve"]

_PANEL_WIDTH, _PANEL_HEIGHT = 3.6, 2.8
"""Inches."""


@dataclass(frozen=True)
class HistogramPanel:
    """What one panel shows.

    Attributes
    ----------
    name, color : of the species
    histogram : counts, or their mean over frames
    mass : of one particle [mass]
    temperature : for the curve of theory [energy]; None leaves it out
    """

    name: str
    color: str
    histogram: Histogram
    mass: float
    temperature: float | None


def histogram_figure(
    panels: Sequence[HistogramPanel], quantity: Quantity = "speed", title: str = ""
) -> Figure:
    """A figure with one panel for each species, up to three side by side."""
    columns, rows = _layout(len(panels))
    figure = new_figure(_PANEL_WIDTH * columns, _PANEL_HEIGHT * rows + (0.3 if title else 0.0))
    draw_histograms(figure, panels, quantity)
    if title:
        figure.suptitle(title, color=INK, fontsize=11, fontweight="bold")
    return figure


def draw_histograms(
    figure: Figure | SubFigure, panels: Sequence[HistogramPanel], quantity: Quantity = "speed"
) -> None:
    """Draw the panels into an empty figure or part of one."""
    columns, rows = _layout(len(panels))
    for place, panel in enumerate(panels):
        _draw(figure.add_subplot(rows, columns, place + 1), panel, quantity)


def theory_curve(
    panel: HistogramPanel, quantity: Quantity, points: int = 201
) -> tuple[NDArray[np.float64], NDArray[np.float64]] | None:
    """The law as a smooth curve: what a bin as wide as the first would hold, were its middle there.

    In the middle of such a bin it is that bin's expected count exactly, so that bars may be held against it.

    Returns
    -------
    Values of the quantity and numbers of particles, (points,) each; None without temperature.
    """
    if not panel.temperature:
        return None
    edges = panel.histogram.edges
    half = 0.5 * float(edges[1] - edges[0])
    middles = np.linspace(float(edges[0]), float(edges[-1]), points)
    ends = np.stack([middles - half, middles + half])
    if quantity == "speed":
        expected = expected_speed_counts(ends.T, panel.histogram.total, panel.mass, panel.temperature)
    else:
        expected = expected_energy_counts(ends.T, panel.histogram.total, panel.temperature)
    return middles, expected[:, 0]


def _layout(panels: int) -> tuple[int, int]:
    """Columns and rows: up to three in a row, four as two by two."""
    columns = 2 if panels == 4 else min(max(panels, 1), 3)
    return columns, math.ceil(max(panels, 1) / columns)


def _draw(axes: Axes, panel: HistogramPanel, quantity: Quantity) -> None:
    shown = panel.histogram
    axes.stairs(shown.counts, shown.edges, fill=True, color=panel.color, alpha=0.75, label="measured")
    axes.stairs(shown.counts, shown.edges, color=darker(panel.color), linewidth=1.0)
    curve = theory_curve(panel, quantity)
    if curve is not None:
        axes.plot(*curve, color=INK, linewidth=1.6, label="Maxwell")
    axes.set_title(panel.name)
    axes.set_xlabel(label("kinetic energy" if quantity == "energy" else "speed", quantity))
    axes.set_ylabel("particles per bin")
    axes.set_xlim(float(shown.edges[0]), float(shown.edges[-1]))
    axes.set_ylim(bottom=0.0)
    _note_outside(axes, shown)
    dress(axes)
    legend(axes)


def _note_outside(axes: Axes, shown: Histogram) -> None:
    """Say so if particles lie outside the axis; silence would make the bars look complete."""
    outside = shown.underflow + shown.overflow
    if outside >= 0.5:
        text = f"{outside:.0f} outside"
        axes.text(0.97, 0.7, text, transform=axes.transAxes, ha="right", va="top", fontsize=8, color=INK)
