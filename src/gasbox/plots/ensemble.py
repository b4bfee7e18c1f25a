"""Figures of many runs: what they count over time as fans, and how their numbers are spread as histograms."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from gasbox.plots.style import INK, POTENTIAL, QUIET, darker, dress, legend, new_figure

__all__ = ["Fan", "Mark", "Pile", "draw_fans", "draw_pile", "ensemble_figure"]

_WIDTH, _FAN_HEIGHT, _PILE_HEIGHT = 10.0, 3.4, 2.9
"""Inches."""
_SINGLE: Final = 6
"""Runs that are drawn one by one."""
_MOST_BINS: Final = 40
_HEADROOM: Final = 0.12
"""Room above the highest bar for each row of a legend, in units of that bar."""


@dataclass(frozen=True, eq=False)
class Fan:
    """One quantity over time in all runs.

    Attributes
    ----------
    name, color : of the quantity
    values : (runs, k) float64
    """

    name: str
    color: str
    values: NDArray[np.float64]


@dataclass(frozen=True)
class Mark:
    """A value to hold a histogram against, with the standard deviation that goes with it; nan draws none."""

    name: str
    value: float
    deviation: float = math.nan


@dataclass(frozen=True, eq=False)
class Pile:
    """One number of all runs.

    Attributes
    ----------
    name, unit : of the number; the unit may be empty
    values : (runs,) float64; nan are left out
    marks : what theory says
    note : under the name, in place of the mean
    """

    name: str
    unit: str
    values: NDArray[np.float64]
    marks: Sequence[Mark] = ()
    note: str = ""


def ensemble_figure(
    time: NDArray[np.float64],
    fans: Sequence[tuple[str, Sequence[Fan]]],
    piles: Sequence[Pile],
    title: str = "",
    clock: str = "time",
) -> Figure:
    """Fans below each other over the whole width, then histograms, up to three side by side.

    Parameters
    ----------
    time : (k,) float64 [time]
    fans : label of an axis, and what is drawn along it
    clock : unit of the time
    """
    columns = 2 if len(piles) == 4 else min(max(len(piles), 1), 3)
    rows = math.ceil(len(piles) / columns)
    heights = [height for height in (_FAN_HEIGHT * len(fans), _PILE_HEIGHT * rows) if height]
    figure = new_figure(_WIDTH, sum(heights) + 0.25 * len(title.splitlines()))
    # Parts of their own, so that a legend beside the fans takes no room from the histograms.
    parts = list(figure.subfigures(len(heights), 1, height_ratios=heights, squeeze=False)[:, 0])
    if fans:
        upper = parts.pop(0)
        for row, (axis, drawn) in enumerate(fans):
            draw_fans(upper.add_subplot(len(fans), 1, row + 1), time, axis, drawn, clock)
    for number, pile in enumerate(piles):
        draw_pile(parts[0].add_subplot(rows, columns, number + 1), pile)
    if title:
        figure.suptitle(title, color=INK, fontsize=11, fontweight="bold")
    return figure


def draw_fans(
    axes: Axes, time: NDArray[np.float64], axis: str, fans: Sequence[Fan], clock: str = "time"
) -> None:
    """The median of all runs, where 90 of 100 lie, and some single ones, so that one sees what a run is like."""
    for fan in fans:
        dark = darker(fan.color, 0.8)
        low, median, high = _quantiles(fan.values)
        axes.fill_between(time, low, high, color=fan.color, alpha=0.22, linewidth=0.0)
        chosen = np.unique(np.linspace(0, len(fan.values) - 1, _SINGLE).round().astype(int))
        for run in chosen:
            axes.plot(time, fan.values[run], color=dark, linewidth=0.6, alpha=0.55)
        axes.plot(time, median, color=dark, linewidth=2.2, label=f"{fan.name}, median")
    axes.fill_between([], [], [], color=QUIET, alpha=0.25, linewidth=0.0, label="90 of 100 runs")
    axes.plot([], [], color=QUIET, linewidth=0.6, label="single runs")
    axes.set_ylabel(axis)
    axes.set_xlabel(f"time [{clock}]")
    axes.set_xlim(float(time[0]), float(time[-1]))
    axes.ticklabel_format(axis="y", useOffset=False)
    if not any(np.any(fan.values < 0.0) for fan in fans):
        axes.set_ylim(bottom=0.0)
    dress(axes)
    legend(axes, beside=True)


def _quantiles(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """(3, k) float64: 5, 50 and 95 of 100 runs lie below; nan where no run has a value."""
    found = np.full((3, values.shape[1]), np.nan)
    known = np.any(np.isfinite(values), axis=0)
    if np.any(known):
        found[:, known] = np.nanquantile(values[:, known], (0.05, 0.5, 0.95), axis=0)
    return found


def draw_pile(axes: Axes, pile: Pile) -> None:
    """A histogram of runs, with what theory says as lines, and its standard deviation as a band."""
    known = pile.values[np.isfinite(pile.values)]
    counts, edges = np.histogram(known, _edges(known))
    axes.stairs(counts, edges, fill=True, color=POTENTIAL, alpha=0.45)
    axes.stairs(counts, edges, color=darker(POTENTIAL), linewidth=0.9)
    highest, rows = max(float(counts.max(initial=1)), 1.0), _draw_marks(axes, pile.marks)
    axes.set_ylim(0.0, highest * (1.06 + _HEADROOM * rows))
    axes.set_title(f"{pile.name}\n")
    axes.set_xlabel(f"{pile.name} [{pile.unit}]" if pile.unit else pile.name)
    axes.set_ylabel("runs")
    axes.ticklabel_format(axis="x", useOffset=False)
    axes.locator_params(axis="x", nbins=5)
    dress(axes)
    axes.text(
        0.5, 1.03, pile.note or _mean(known), transform=axes.transAxes, ha="center", fontsize=8, color=QUIET
    )
    if rows:
        axes.legend(
            loc="upper center", fontsize=7.5, facecolor="white", framealpha=0.9, edgecolor="none",
            labelcolor=INK, borderaxespad=0.1, labelspacing=0.25,
        )  # fmt: skip


def _draw_marks(axes: Axes, marks: Sequence[Mark]) -> int:
    """Lines of theory with their bands; how many rows the legend has."""
    rows = 0
    for mark, style in zip(marks, ("-", "--", ":", "-."), strict=False):
        axes.axvline(mark.value, color=INK, linewidth=1.5, linestyle=style, label=mark.name)
        rows += 1
        if math.isfinite(mark.deviation):
            span = mark.value - mark.deviation, mark.value + mark.deviation
            axes.axvspan(*span, color=INK, alpha=0.13, linewidth=0.0, label="± its standard deviation")
            rows += 1
    return rows


def _mean(values: NDArray[np.float64]) -> str:
    if values.size < 2:
        return f"{float(values[0]):.4g}" if values.size else "no value"
    deviation = float(np.std(values, ddof=1))
    return f"mean {np.mean(values):.4g} ± {deviation / math.sqrt(values.size):.2g}, sd {deviation:.2g}"


def _edges(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bins that show the shape; of values that come in steps, as whole numbers do, each holds equally many of them."""
    if not values.size:
        return np.array([0.0, 1.0])
    low, high = float(values.min()), float(values.max())
    if high - low <= 1e-9 * max(abs(low), abs(high)):
        half = 0.01 * abs(high) or 0.5
        return np.array([low - half, high + half])
    step = _step(values)
    if step is None:
        return np.linspace(low, high, _bins(values) + 1)
    steps = round((high - low) / step) + 1
    each = math.ceil(steps / _bins(values))
    return np.asarray(low + (np.arange(0, steps + each, each) - 0.5) * step, np.float64)


def _step(values: NDArray[np.float64]) -> float | None:
    """The even step in which all values come, up to rounding; None if they come in none, or in a very small one."""
    different = np.unique(values)
    gaps = np.diff(different)
    span = float(different[-1] - different[0])
    gaps = gaps[gaps > 1e-3 * span]
    step = span / float(np.sum(np.round(gaps / gaps.min()))) if gaps.size else span
    places = (different - different[0]) / step
    return step if np.all(np.abs(places - np.round(places)) < 0.1) else None


def _bins(values: NDArray[np.float64]) -> int:
    """Twice the root of the number of values, within reason."""
    return int(min(max(2.0 * math.sqrt(values.size), 5.0), _MOST_BINS))
