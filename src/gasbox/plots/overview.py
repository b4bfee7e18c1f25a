"""Histograms and time series in one figure."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from matplotlib.figure import Figure

from gasbox.observe import Series
from gasbox.plots.histograms import HistogramPanel, draw_histograms
from gasbox.plots.panels import PANEL_HEIGHT, Panel, draw_panels, panel_rows
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
    more: Sequence[Panel] = (),
) -> Figure:
    """Histograms above, energy, temperature and pressure below; parameters as of the two by themselves.

    Parameters
    ----------
    more : further panels, two side by side at the bottom
    """
    rows = 1 if len(panels) <= 3 else 2
    heights = [2.7 * rows, 6.4, PANEL_HEIGHT * panel_rows(len(more))[1]][: 3 if more else 2]
    width = max(9.2 if more else 7.2, 3.2 * min(max(len(panels), 1), 3))
    figure = new_figure(width, sum(heights))
    parts: Any = figure.subfigures(len(heights), 1, height_ratios=heights)
    draw_histograms(parts[0], panels, quantity)
    species = [(panel.name, panel.color) for panel in panels]
    draw_series(parts[1], series, species, ideal_pressure, hard_disc_pressure)
    if more:
        draw_panels(parts[2], more)
    if title:
        figure.suptitle(title, color=INK, fontsize=12, fontweight="bold")
    return figure
