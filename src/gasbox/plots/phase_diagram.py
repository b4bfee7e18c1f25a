"""The phase diagram of Lennard-Jones discs: what was found at each temperature and density, and what others found."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import to_rgba
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from numpy.typing import NDArray

from gasbox.observe import Phase
from gasbox.plots.matter import PHASE_COLORS
from gasbox.plots.style import INK, dress, new_figure
from gasbox.theory.lennard_jones import COEXISTENCE, CRITICAL_POINTS, TRIPLE_POINTS, Model

__all__ = ["MATTER_COLORS", "draw_literature", "draw_matters", "phase_diagram_figure"]

MATTER_COLORS: Final = {
    "gas": PHASE_COLORS[Phase.GAS],
    "fluid": "#9ab973",
    "liquid": PHASE_COLORS[Phase.LIQUID],
    "solid": PHASE_COLORS[Phase.SOLID],
    "gas and liquid": "#e6c229",
    "gas, liquid, solid": "#b07aa1",
    "gas and solid": "#8f8fc4",
    "liquid and solid": "#56b4e9",
}
"""Colour of each thing that the discs may be, in the order of the legend."""
_ALPHA: Final = 0.55
_LONG: Final = 4.0
"""Cutoff [sigma] from which forces count as the full law; below it, as those truncated at 2.5."""


def phase_diagram_figure(
    temperature: Sequence[float],
    density: Sequence[float],
    matter: Sequence[str],
    cutoff: float,
    caption: str,
) -> Figure:
    """The whole figure.

    Parameters
    ----------
    temperature, density : of each point [energy], [1/length²]
    matter : what was found there, names in `MATTER_COLORS`
    cutoff : of the forces [sigma]; it decides to which model of the literature they belong
    caption : under the title
    """
    figure = new_figure(9.0, 5.6)
    axes = figure.subplots()
    draw_matters(axes, np.asarray(temperature), np.asarray(density), matter)
    draw_literature(axes, "full" if cutoff >= _LONG else "truncated")
    axes.set_title(f"phases of Lennard-Jones discs\n{caption}")
    axes.set_xlabel("density  [discs per sigma²]")
    axes.set_ylabel("temperature  [epsilon]")
    dress(axes)
    axes.grid(visible=False)
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), fontsize=8, frameon=False, labelcolor=INK)
    return figure


def draw_matters(
    axes: Axes, temperature: NDArray[np.float64], density: NDArray[np.float64], matter: Sequence[str]
) -> None:
    """A coloured field around each point, as far as half-way to its neighbours."""
    rows, columns = _borders(temperature), _borders(density)
    for warm, dense, what in zip(temperature, density, matter, strict=True):
        bottom, top = rows[float(warm)]
        left, right = columns[float(dense)]
        face = to_rgba(MATTER_COLORS[what], _ALPHA)
        axes.add_patch(
            Rectangle((left, bottom), right - left, top - bottom, facecolor=face, edgecolor="none")
        )
    for name, color in MATTER_COLORS.items():
        chosen = np.array([what == name for what in matter], bool)
        if np.any(chosen):
            axes.plot(
                density[chosen], temperature[chosen], "s", color=color, markersize=3.5, label=name, zorder=2
            )
    axes.set_xlim(min(low for low, _ in columns.values()), max(high for _, high in columns.values()))
    axes.set_ylim(min(low for low, _ in rows.values()), max(high for _, high in rows.values()))


def draw_literature(axes: Axes, model: Model) -> None:
    """Critical point, triple point and coexisting densities that were published for this model, with their errors."""
    there = [row for row in COEXISTENCE if row.model == model]
    if there:
        for name, sizes, errors in (
            ("gas beside liquid, published", [row.gas for row in there], [row.gas_error for row in there]),
            (None, [row.liquid for row in there], [row.liquid_error for row in there]),
        ):
            axes.errorbar(
                sizes, [row.temperature for row in there], xerr=errors, fmt="o", color=INK, markersize=3.5,
                elinewidth=0.8, capsize=2, label=name, zorder=4,
            )  # fmt: skip
    for number, one in enumerate(row for row in CRITICAL_POINTS if row.model == model):
        axes.errorbar(
            [one.density], [one.temperature], xerr=one.density_error, yerr=one.temperature_error, fmt="*",
            color=INK, markersize=11, markerfacecolor="white" if number else INK, elinewidth=0.8,
            label=f"critical point, {_author(one.source)}", zorder=5,
        )  # fmt: skip
    for triple in (row for row in TRIPLE_POINTS if row.model == model):
        about = "about " if triple.approximate else ""
        axes.axhline(
            triple.temperature, color=INK, linewidth=0.9, linestyle="--",
            label=f"triple point, {about}{triple.temperature:g}", zorder=3,
        )  # fmt: skip
        ends = [value for value in (triple.liquid, triple.solid) if value is not None]
        axes.plot(ends, [triple.temperature] * len(ends), "D", color=INK, markersize=4, zorder=5)


def _borders(values: NDArray[np.float64]) -> dict[float, tuple[float, float]]:
    """For each different value: half-way to the one below and to the one above."""
    different = np.unique(values)
    if different.size < 2:
        return {float(value): (float(value) - 0.01, float(value) + 0.01) for value in different}
    middles = 0.5 * (different[1:] + different[:-1])
    first, last = 2.0 * different[0] - middles[0], 2.0 * different[-1] - middles[-1]
    ends = np.concatenate([[first], middles, [last]])
    return {
        float(value): (float(low), float(high))
        for value, low, high in zip(different, ends[:-1], ends[1:], strict=True)
    }


def _author(source: str) -> str:
    """First of the authors and year of a source, as in "B. Smit and D. Frenkel 1991"."""
    year = re.search(r"\((\d{4})\)", source)
    return f"{source.split(',')[0]} {year.group(1) if year else ''}".strip()
