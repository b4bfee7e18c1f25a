"""Panels of the energy of a gas and where it came from, and of pressure against area."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from gasbox.observe import EnergyBalance, IndicatorSeries
from gasbox.plots.style import INK, KINETIC, POTENTIAL, QUIET, dress, label, legend

__all__ = ["draw_energies", "draw_indicator", "draw_transfers"]

_WORK, _HEAT, _CARRIED, _OTHER = "#0b6bcb", "#c2410c", "#7c4fb5", "#8a6d00"
_MEASURED = "#0b6bcb"
MOST_POINTS: Final = 40
"""Points of a diagram of pressure and area."""


def draw_energies(axes: Axes, book: EnergyBalance) -> None:
    """Kinetic, potential and internal energy over time; the first two only where they differ from the third."""
    if np.any(book.potential):
        axes.plot(book.time, book.kinetic, color=KINETIC, linewidth=1.2, label="kinetic")
        axes.plot(book.time, book.potential, color=POTENTIAL, linewidth=1.2, label="potential")
    axes.plot(book.time, book.internal, color=INK, linewidth=1.7, label="internal")
    axes.set_title("energy")
    axes.set_xlabel(label("time", "time"))
    axes.set_ylabel(label("energy", "energy", lines=2))
    _settle(axes, book.internal)
    dress(axes)
    legend(axes, place="best")


def draw_transfers(axes: Axes, book: EnergyBalance) -> None:
    """Work, heat and what else the gas was given since the start, beside the change of its internal energy."""
    given = (
        ("work of walls", book.work, _WORK),
        ("heat from walls", book.heat, _HEAT),
        ("carried away", -book.carried, _CARRIED),
        ("heat from thermostat", book.thermostat, "#e07a5f"),
        ("heat from heater", book.heater, "#b5179e"),
        ("work of barostat", book.barostat, "#1f9e89"),
        ("rule for rest", book.rest, _OTHER),
        ("changed gravity", book.changes, QUIET),
    )
    scale = max((float(np.max(np.abs(row), initial=0.0)) for _, row, _ in given), default=0.0)
    for name, row, color in given:
        if np.max(np.abs(row), initial=0.0) > 1e-9 * scale:
            axes.plot(book.time, row, color=color, linewidth=1.3, label=name)
    change = book.internal - book.internal[:1]
    axes.plot(book.time, change, color=INK, linewidth=1.7, linestyle="--", label="internal energy")
    axes.axhline(0.0, color=QUIET, linewidth=0.8)
    axes.set_title("where energy came from")
    axes.set_xlabel(label("time", "time"))
    axes.set_ylabel(label("given since the start", "energy", lines=2))
    dress(axes)
    legend(axes, place="best")


def draw_indicator(
    axes: Axes,
    diagram: IndicatorSeries,
    curves: Sequence[tuple[str, NDArray[np.float64], NDArray[np.float64]]] = (),
) -> None:
    """Pressure on a moving wall against the area of the enclosure, later points darker.

    Windows are put together until no more than `MOST_POINTS` are left, lest single hits hide the curve.

    Parameters
    ----------
    curves : name, areas [length²] and pressures [mass/time²] of what theory says
    """
    area, pressure = _together(diagram)
    axes.plot(area, pressure, color=_MEASURED, linewidth=0.8, alpha=0.35)
    if area.size:
        shade = np.linspace(0.25, 1.0, area.size)
        colors = np.column_stack([np.tile((0.04, 0.42, 0.80), (area.size, 1)), shade])
        axes.scatter(area, pressure, s=16, c=colors, linewidths=0, zorder=2.5)
        # In the legend as dark as the last one: the first is too pale for it.
        axes.plot([], [], color=_MEASURED, marker="o", markersize=4, linestyle="none", label="on the wall")
    for (name, places, values), style in zip(curves, ("--", ":", "-."), strict=False):
        axes.plot(places, values, color=INK, linewidth=1.4, linestyle=style, label=name)
    axes.set_title("pressure and area")
    axes.set_xlabel(label("area", "area"))
    axes.set_ylabel(label("pressure", "pressure"))
    axes.set_ylim(bottom=0.0)
    dress(axes)
    legend(axes, place="best")


def _together(diagram: IndicatorSeries) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Mean areas and pressures of as many neighbouring windows as it takes, each weighted by its duration."""
    area, pressure, window = diagram.mid_area[1:], diagram.pressure[1:], np.diff(diagram.time)
    seen = np.isfinite(pressure)
    area, pressure, window = area[seen], pressure[seen], window[seen]
    if not area.size:
        return area, pressure
    starts = np.arange(0, area.size, math.ceil(area.size / MOST_POINTS))
    whole = np.add.reduceat(window, starts)
    return np.add.reduceat(window * area, starts) / whole, np.add.reduceat(window * pressure, starts) / whole


def _settle(axes: Axes, internal: NDArray[np.float64]) -> None:
    """Zero belongs to the axis if it is near, and rounding must not look like an event."""
    low, high = axes.get_ylim()
    if internal.size and high - low < 0.02 * abs(float(internal[0])):
        middle, half = float(internal[0]), 0.02 * abs(float(internal[0]))
        axes.set_ylim(middle - half, middle + half)
    elif low > 0.0:
        axes.set_ylim(bottom=0.0)
