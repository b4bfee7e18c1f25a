"""Panels of density and temperature along an axis, with the barometric law where there is gravity."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from gasbox.observe import Axis, Profile, Profiles
from gasbox.plots.panels import Species
from gasbox.plots.style import INK, QUIET, darker, dress, label, legend

__all__ = ["axis_name", "draw_density", "draw_temperature_profile"]

Curve = tuple[NDArray[np.float64], NDArray[np.float64]]
"""Places along the axis [length], and values there."""


def axis_name(axis: Axis) -> str:
    """What an axis is called: x, height y, or an angle."""
    if axis == "x":
        return "x"
    return "height y" if axis == "y" else f"place along {np.degrees(axis):.0f}°"


def draw_density(
    axes: Axes,
    profiles: Profiles,
    species: Species,
    barometric: Sequence[Curve] = (),
    hard_discs: Sequence[Curve] = (),
) -> None:
    """Number density of each species along the axis, with error bars.

    Parameters
    ----------
    species : name and colour of each
    barometric : curve of the ideal law for each species; none leaves them out
    hard_discs : curves of hard discs
    """
    for one, (name, color) in zip(profiles.density, species, strict=True):
        _draw(axes, profiles.middles, one, color, name)
    for number, (curve, (_, color)) in enumerate(zip(barometric, species, strict=False)):
        law = "barometric law" if number == 0 else None
        axes.plot(*curve, color=darker(color), linewidth=1.3, linestyle="--", label=law)
    for number, curve in enumerate(hard_discs):
        axes.plot(*curve, color=INK, linewidth=1.4, label="hard discs (theory)" if number == 0 else None)
    axes.set_title("density")
    axes.set_xlabel(label(axis_name(profiles.axis), "position"))
    axes.set_ylabel("discs per area [1/length²]")
    axes.set_xlim(float(profiles.edges[0]), float(profiles.edges[-1]))
    axes.set_ylim(bottom=0.0)
    dress(axes)
    legend(axes, place="best")


def draw_temperature_profile(
    axes: Axes, profiles: Profiles, species: Species, temperature: float | None = None
) -> None:
    """Temperature of the whole gas, and of each of several species, along the axis.

    Parameters
    ----------
    temperature : of the whole gas, for a line [energy]; None leaves it out
    """
    if len(species) > 1:
        for one, (name, color) in zip(profiles.temperature, species, strict=True):
            _draw(axes, profiles.middles, one, color, name)
    else:
        _draw(axes, profiles.middles, profiles.whole_temperature, species[0][1], species[0][0])
    if temperature is not None:
        axes.axhline(temperature, color=QUIET, linewidth=1.3, linestyle="--", label="whole gas")
    axes.set_title("temperature")
    axes.set_xlabel(label(axis_name(profiles.axis), "position"))
    axes.set_ylabel(label("temperature", "temperature", lines=2))
    axes.set_xlim(float(profiles.edges[0]), float(profiles.edges[-1]))
    _frame_values(axes, profiles, temperature)
    dress(axes)
    legend(axes, place="best")


def _draw(axes: Axes, places: NDArray[np.float64], profile: Profile, color: str, name: str) -> None:
    axes.errorbar(
        places,
        profile.mean,
        np.nan_to_num(profile.error),
        color=darker(color, 0.85),
        ecolor=(*darker(color, 0.85), 0.5),
        elinewidth=1.0,
        marker="o",
        markersize=3.5,
        linestyle="none",
        label=name,
    )


def _frame_values(axes: Axes, profiles: Profiles, temperature: float | None) -> None:
    """From zero to a little above the mean: a lone disc high up may be ten times as hot as the gas."""
    whole = profiles.whole_temperature
    # Strips in which something is known to a fifth.
    sure = whole.mean[np.nan_to_num(whole.error, nan=np.inf) < 0.2 * np.abs(np.nan_to_num(whole.mean))]
    top = max(float(np.max(sure, initial=0.0)), temperature or 0.0)
    axes.set_ylim(0.0, 1.5 * top if top > 0.0 else None)
