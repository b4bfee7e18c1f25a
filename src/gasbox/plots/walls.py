"""Panels of what walls feel, and of who passes them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from gasbox.plots.panels import Species
from gasbox.plots.style import INK, darker, dress, label, legend

__all__ = ["draw_passed", "draw_wall_pressures"]

_POINT = "#0b6bcb"
_MOST = 24
"""Names that can still be read one below the other."""


def draw_wall_pressures(
    axes: Axes, names: Sequence[str], mean: NDArray[np.float64], error: NDArray[np.float64]
) -> None:
    """Mean pressure on each wall with its error bar; walls that are no gauge are left out.

    Parameters
    ----------
    mean, error : (walls,) float64 [mass/time²]
    """
    shown = [k for k in range(len(names)) if np.isfinite(mean[k])][:_MOST]
    rows = np.arange(len(shown))
    bars = np.nan_to_num(error[shown])
    axes.errorbar(
        mean[shown], rows, xerr=bars, color=_POINT, marker="o", markersize=5, linestyle="none", capsize=3
    )
    axes.set_yticks(rows, [names[k] for k in shown])
    axes.set_ylim(len(shown) - 0.5, -0.5)
    axes.set_title("pressure on each wall")
    axes.set_xlabel(label("pressure", "pressure"))
    axes.set_xlim(left=0.0)
    dress(axes)
    axes.tick_params(axis="y", length=0, labelsize=9, labelcolor=INK)


def draw_passed(
    axes: Axes,
    time: NDArray[np.float64],
    passed: NDArray[np.int64],
    names: Sequence[str],
    species: Species,
) -> None:
    """How many discs have passed walls so far: forwards less backwards, and each way as thin lines.

    Where none came back, as through an open wall, those that passed count, whichever way they went.

    Parameters
    ----------
    time : (frames,) float64 [time]
    passed : (frames, walls, species, 2) int64, along the normal and against it
    names : of these walls
    """
    styles = ("-", "--", ":", "-.")
    one_way = not np.any(np.any(passed[..., 0], axis=(0, 2)) & np.any(passed[..., 1], axis=(0, 2)))
    for wall, wall_name in enumerate(names):
        for number, (name, color) in enumerate(species):
            forward, backward = passed[:, wall, number, 0], passed[:, wall, number, 1]
            if not (np.any(forward) or np.any(backward)):
                continue
            line: dict[str, Any] = {"color": darker(color, 0.85), "linestyle": styles[wall % len(styles)]}
            parts = ([wall_name] if len(names) > 1 else []) + ([name] if len(species) > 1 else [])
            net = forward + backward if one_way else forward - backward
            axes.plot(time, net, linewidth=1.6, label=", ".join(parts) or "net", **line)
            if np.any(forward) and np.any(backward):
                axes.plot(time, forward, linewidth=0.7, alpha=0.6, **line)
                axes.plot(time, -backward, linewidth=0.7, alpha=0.6, **line)
    axes.set_title(f"passed {names[0]}" if len(names) == 1 else "passed")
    axes.set_xlabel(label("time", "time"))
    axes.set_ylabel("discs" if one_way else "discs, forwards less backwards")
    dress(axes)
    legend(axes, place="best")
