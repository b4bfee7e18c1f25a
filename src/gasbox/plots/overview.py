"""Histograms and time series in one figure."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from matplotlib.figure import Figure

from gasbox.observe import Series
from gasbox.plots.histograms import HistogramPanel, draw_histograms
from gasbox.plots.series import draw_series
from gasbox.plots.style import INK, new_figure
from gasbox.theory.ranges import Quantity

__all__ = ["overview_figure"]


def overview_figure(
    panels: Sequence[HistogramPanel],
    series: Series,
    quantity: Quantity = "speed",
    ideal_pressure: float | None = None,
    hard_disc_pressure: float | None = None,
    title: str = "",
) -> Figure:
    """Histograms above, energy, temperature and pressure below; parameters as of the two by themselves."""
    rows = 1 if len(panels) <= 3 else 2
    figure = new_figure(max(7.2, 3.2 * min(max(len(panels), 1), 3)), 6.4 + 2.7 * rows)
    parts: Any = figure.subfigures(2, 1, height_ratios=[2.7 * rows, 6.4])
    above, below = parts
    draw_histograms(above, panels, quantity)
    species = [(panel.name, panel.color) for panel in panels]
    draw_series(below, series, species, ideal_pressure, hard_disc_pressure)
    if title:
        figure.suptitle(title, color=INK, fontsize=12, fontweight="bold")
    return figure
