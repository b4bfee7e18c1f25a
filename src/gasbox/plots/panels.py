"""Figures put together from panels: each draws itself into axes of its own."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure

from gasbox.plots.style import INK, new_figure

__all__ = ["PANEL_HEIGHT", "Panel", "Species", "draw_panels", "panel_rows", "panels_figure"]

Panel = Callable[[Axes], None]
"""Draws into empty axes, labels included."""
Species = Sequence[tuple[str, str]]
"""Name and colour of each species."""

_PANEL_WIDTH, PANEL_HEIGHT = 5.0, 3.3
"""Inches."""


def panel_rows(count: int) -> tuple[int, int]:
    """Columns and rows: one by itself, otherwise two side by side."""
    columns = 1 if count <= 1 else 2
    return columns, math.ceil(max(count, 1) / columns)


def panels_figure(panels: Sequence[Panel], title: str = "") -> Figure:
    """A figure of some panels, up to two side by side."""
    columns, rows = panel_rows(len(panels))
    size = (_PANEL_WIDTH * columns, PANEL_HEIGHT * rows) if columns > 1 else (6.4, 4.6)
    figure = new_figure(size[0], size[1] + (0.45 if title else 0.0))
    draw_panels(figure, panels)
    if title:
        figure.suptitle(title, color=INK, fontsize=11, fontweight="bold")
    return figure


def draw_panels(figure: Figure | SubFigure, panels: Sequence[Panel]) -> None:
    """Draw the panels into an empty figure or part of one."""
    columns, rows = panel_rows(len(panels))
    for place, panel in enumerate(panels):
        panel(figure.add_subplot(rows, columns, place + 1))
