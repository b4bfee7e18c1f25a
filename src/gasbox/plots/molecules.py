"""Panels of molecules: how energy is shared, how fast they turn, and how they stand to each other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from gasbox.observe import Histogram, ModeSeries, OrientationPairs, TurningCorrelation
from gasbox.plots.style import INK, QUIET, darker, dress, label, legend

__all__ = ["MODE_COLORS", "draw_law", "draw_modes", "draw_order", "draw_orientation", "draw_turning"]

MODE_COLORS: Final = {"x": "#0b6bcb", "y": "#1f9e89", "rotation": "#c2410c", "vibration": "#8b5cf6"}
_NAMES: Final = {"x": "flight along x", "y": "flight along y"}
_FIRST, _SECOND = "#0b6bcb", "#c2410c"
_FEWEST: Final = 100
"""Pairs in a bin, counted from both sides, below which chance alone would be drawn."""
_FORGOTTEN: Final = 0.05
_BEYOND: Final = 3
"""How far memory is drawn, in units of the time after which it is forgotten."""


def draw_modes(axes: Axes, modes: ModeSeries, temperature: float | None = None) -> None:
    """Mean energy of each degree of freedom over time; in equilibrium each has T/2.

    Parameters
    ----------
    temperature : of the whole gas, for the line at T/2 [energy]; None leaves it out
    """
    for name, color in MODE_COLORS.items():
        values = getattr(modes, name)
        if np.any(np.isfinite(values)):
            axes.plot(modes.time, values, color=color, linewidth=1.3, label=_NAMES.get(name, name))
    if temperature is not None:
        axes.axhline(0.5 * temperature, color=INK, linewidth=1.3, linestyle="--", label="T/2")
    axes.set_title("energy of each degree of freedom")
    axes.set_xlabel(label("time", "time"))
    axes.set_ylabel(label("mean energy", "energy", lines=2))
    axes.set_ylim(bottom=0.0)
    dress(axes)
    legend(axes, place="best")


def draw_law(
    axes: Axes,
    shown: Histogram,
    expected: NDArray[np.float64] | None,
    color: str,
    title: str,
    axis: tuple[str, str],
    law: str,
) -> None:
    """A histogram with what a law puts into each bin.

    Parameters
    ----------
    expected : (bins,) particles in each; None leaves the law out
    axis : words for the axis, and the quantity that says its unit
    law : its name
    """
    axes.stairs(shown.counts, shown.edges, fill=True, color=color, alpha=0.75, label="measured")
    axes.stairs(shown.counts, shown.edges, color=darker(color), linewidth=1.0)
    if expected is not None:
        middles = 0.5 * (shown.edges[1:] + shown.edges[:-1])
        axes.plot(middles, expected, color=INK, linewidth=1.4, marker=".", markersize=4, label=law)
    axes.set_title(title)
    axes.set_xlabel(label(*axis))
    axes.set_ylabel("particles per bin")
    axes.set_xlim(float(shown.edges[0]), float(shown.edges[-1]))
    axes.set_ylim(bottom=0.0)
    dress(axes)
    legend(axes)


def draw_orientation(axes: Axes, found: OrientationPairs, title: str = "orientation of pairs") -> None:
    """How alike two molecules are turned, over the distance of their centres."""
    many = found.pairs >= _FEWEST
    for values, color, name in (
        (found.first, _FIRST, "cos of the angle between"),
        (found.second, _SECOND, "cos of twice the angle"),
    ):
        axes.plot(found.r, np.where(many, values, np.nan), color=color, linewidth=1.4, label=name)
    axes.axhline(0.0, color=QUIET, linewidth=0.8, linestyle=":")
    axes.set_title(title)
    axes.set_xlabel(label("distance r", "position"))
    axes.set_ylabel("mean over pairs")
    axes.set_xlim(0.0, float(found.r[-1]) if found.r.size else 1.0)
    dress(axes)
    legend(axes, place="best")


def draw_turning(
    axes: Axes,
    found: TurningCorrelation,
    free: Sequence[NDArray[np.float64]] = (),
    title: str = "memory of orientation",
) -> None:
    """How long molecules remember how they were turned.

    Parameters
    ----------
    free : (lags,) each, what both means were if nobody met anybody
    """
    names = ("cos of the turn", "cos of twice the turn")
    measured = zip((found.first, found.second), (_FIRST, _SECOND), names, strict=True)
    gone = np.flatnonzero(found.first < _FORGOTTEN)
    for number, (values, color, name) in enumerate(measured):
        axes.plot(found.times, values, color=color, linewidth=1.4, label=name)
        if number < len(free):
            axes.plot(
                found.times,
                free[number],
                color=color,
                linewidth=1.2,
                linestyle="--",
                label="free rotors" if number == 0 else None,
            )
    axes.axhline(0.0, color=QUIET, linewidth=0.8, linestyle=":")
    axes.set_title(title)
    axes.set_xlabel(label("time between", "time"))
    axes.set_ylabel("mean over molecules")
    axes.set_xlim(0.0, _BEYOND * float(found.times[gone[0]]) if gone.size else None)
    axes.set_ylim(top=1.05)
    dress(axes)
    legend(axes)


def draw_order(axes: Axes, time: NDArray[np.float64], order: NDArray[np.float64], chance: float) -> None:
    """Nematic order over time: 1 where all lie along one line.

    Parameters
    ----------
    chance : what it is on average for molecules at random
    """
    axes.plot(time, order, color=INK, linewidth=1.5, label="measured")
    axes.axhline(chance, color=QUIET, linewidth=1.2, linestyle="--", label="at random")
    axes.set_title("nematic order")
    axes.set_xlabel(label("time", "time"))
    axes.set_ylabel("modulus of the mean\nof exp(2i angle)")
    axes.set_ylim(0.0, 1.05)
    dress(axes)
    legend(axes)
