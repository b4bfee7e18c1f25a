"""A figure of energy, temperature and pressure over time."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure
from numpy.typing import NDArray

from gasbox.observe import Series
from gasbox.plots.style import INK, KINETIC, POTENTIAL, QUIET, darker, dress, label, legend, new_figure

__all__ = ["draw_series", "series_figure"]

_WALL, _VIRIAL = "#0b6bcb", "#c2410c"
_LEAST_SPAN = 0.02
"""Least height of the energy axis as a share of the energy: rounding errors must not look like events."""
_CONSERVED = 1e-3
"""A larger relative change is no error that one would like to know: it is work, heat or discs that left."""


def series_figure(
    series: Series,
    species: Sequence[tuple[str, str]] = (),
    ideal_pressure: float | None = None,
    hard_disc_pressure: float | None = None,
    title: str = "",
) -> Figure:
    """Energy, temperature and pressure, one above the other.

    Parameters
    ----------
    series : as `gasbox.observe.TimeSeries` or a recording gives it
    species : name and colour of each; their temperatures are drawn where there is more than one
    ideal_pressure, hard_disc_pressure : what theory says [mass/time²]; None leaves the line out
    """
    figure = new_figure(7.2, 7.0)
    draw_series(figure, series, species, ideal_pressure, hard_disc_pressure)
    if title:
        figure.suptitle(title, color=INK, fontsize=11, fontweight="bold")
    return figure


def draw_series(
    figure: Figure | SubFigure,
    series: Series,
    species: Sequence[tuple[str, str]] = (),
    ideal_pressure: float | None = None,
    hard_disc_pressure: float | None = None,
) -> None:
    """Draw the three panels into an empty figure or part of one; as `series_figure`."""
    energy, heat, pressure = figure.subplots(3, 1, sharex=True)
    _draw_energy(energy, series)
    _draw_temperature(heat, series, species)
    _draw_pressure(pressure, series, ideal_pressure, hard_disc_pressure)
    pressure.set_xlabel(label("time", "time"))
    for axes in (energy, heat, pressure):
        dress(axes)
        legend(axes, beside=True)
    figure.align_ylabels([energy, heat, pressure])


def _draw_energy(axes: Axes, series: Series) -> None:
    """The kinetic energy; where there is a potential one, both and their sum, which is what is conserved then."""
    energy = series.energy
    if np.any(series.potential_energy):
        axes.plot(series.time, series.energy, color=KINETIC, linewidth=1.1, label="kinetic")
        axes.plot(series.time, series.potential_energy, color=POTENTIAL, linewidth=1.1, label="potential")
        energy = series.energy + series.potential_energy
    # The name goes into a legend only where there is more than one line.
    name = "internal" if energy is not series.energy else None
    axes.plot(series.time, energy, color=INK, linewidth=1.6, label=name)
    axes.set_ylabel(label("energy", "energy", lines=2))
    axes.ticklabel_format(axis="y", useOffset=False)
    if energy.size == 0:
        return
    first = float(energy[0])
    low, high = axes.get_ylim()
    if high - low < _LEAST_SPAN * abs(first):
        half = _LEAST_SPAN * abs(first)
        axes.set_ylim(first - half, first + half)
    elif np.any(series.potential_energy):
        # Room for the note above a sum that lies highest.
        axes.set_ylim(low, high + 0.2 * (high - low))
    change = float(np.max(np.abs(energy - first)))
    if abs(first) > 0.0 and change < _CONSERVED * abs(first):
        text = f"largest relative change {change / abs(first):.1e}"
        axes.text(0.99, 0.95, text, transform=axes.transAxes, ha="right", va="top", fontsize=8, color=QUIET)


def _draw_temperature(axes: Axes, series: Series, species: Sequence[tuple[str, str]]) -> None:
    if len(species) > 1:
        for column, (name, color) in zip(series.species_temperature.T, species, strict=True):
            axes.plot(series.time, column, color=darker(color, 0.85), linewidth=1.1, label=name)
    axes.plot(series.time, series.temperature, color=INK, linewidth=1.6, label="whole gas")
    axes.set_ylabel(label("temperature", "temperature", lines=2))
    axes.ticklabel_format(axis="y", useOffset=False)
    axes.set_ylim(bottom=0.0)


def _draw_pressure(axes: Axes, series: Series, ideal: float | None, hard_disc: float | None) -> None:
    _draw_measured(axes, series.time, series.wall_pressure, _WALL, "at the walls")
    _draw_measured(axes, series.time, series.virial_pressure, _VIRIAL, "from the virial")
    if ideal is not None:
        axes.axhline(ideal, color=QUIET, linewidth=1.3, linestyle=":", label="ideal gas")
    if hard_disc is not None:
        axes.axhline(hard_disc, color=INK, linewidth=1.3, linestyle="--", label="hard discs (theory)")
    axes.set_ylabel(label("pressure", "pressure", lines=2))
    axes.ticklabel_format(axis="y", useOffset=False)


def _draw_measured(
    axes: Axes, time: NDArray[np.float64], pressure: NDArray[np.float64], color: str, name: str
) -> None:
    if np.any(np.isfinite(pressure)):
        axes.plot(time, pressure, color=color, linewidth=1.1, label=name)
