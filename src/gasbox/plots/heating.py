"""A panel of the heating curve: temperature against heat added, its stretches coloured, its latent heats written."""

from __future__ import annotations

from typing import Final

from matplotlib.axes import Axes

from gasbox.observe import HeatingCourse, LatentHeat, Phase, branches, latent_heats, stretches
from gasbox.observe.stretches import StretchName, smoothed
from gasbox.plots.matter import PHASE_COLORS
from gasbox.plots.style import INK, QUIET, dress, label, legend

__all__ = ["STRETCH_COLORS", "draw_heating_curve"]

STRETCH_COLORS: Final[dict[StretchName, str]] = {
    "solid": PHASE_COLORS[Phase.SOLID],
    "melting": "#56b4e9",
    "liquid": PHASE_COLORS[Phase.LIQUID],
    "boiling": "#e6c229",
    "gas": PHASE_COLORS[Phase.GAS],
    "subliming": "#9467bd",
}
_SMOOTH: Final = 80
"""The curve is the mean over one frame in so many on either side; frames themselves lie faintly behind."""


def draw_heating_curve(axes: Axes, curve: HeatingCourse) -> None:
    """Temperature against the heat added to each disc; cooling back, where there is any, is dashed.

    Plateaus of a finite gas are tilted and rounded; they are drawn as they are.
    """
    heating, cooling = branches(curve)
    shown = _draw_branch(axes, curve.rows(heating), "-")
    if cooling.stop > cooling.start:
        shown |= _draw_branch(axes, curve.rows(cooling), "--")
        axes.plot([], [], color=QUIET, linewidth=1.6, linestyle="--", label="cooling back")
    for name, color in STRETCH_COLORS.items():
        if name in shown:
            axes.plot([], [], color=color, linewidth=3.0, label=name)
    axes.set_title("heating curve")
    axes.set_xlabel(label("heat added, each disc", "energy"))
    axes.set_ylabel(label("temperature", "temperature", lines=2))
    _write(axes, latent_heats(curve.rows(heating)))
    dress(axes)
    legend(axes, place="best")


def _draw_branch(axes: Axes, curve: HeatingCourse, style: str) -> set[str]:
    """Draw each stretch in its colour; the names of those that were drawn."""
    width = max(curve.time.size // _SMOOTH, 0)
    line = smoothed(curve.temperature, width), smoothed(curve.heat, width)
    axes.plot(curve.heat, curve.temperature, color=QUIET, linewidth=0.5, alpha=0.35)
    marked = stretches(curve)
    for stretch in marked:
        # One frame further, so that the colours meet.
        frames = slice(stretch.begin, stretch.end + 1)
        axes.plot(
            line[1][frames],
            line[0][frames],
            color=STRETCH_COLORS[stretch.name],
            linewidth=2.6 if style == "-" else 1.6,
            linestyle=style,
        )
    return {stretch.name for stretch in marked}


def _write(axes: Axes, found: list[LatentHeat]) -> None:
    """Latent heats, each beside its plateau."""
    for number, one in enumerate(found):
        text = f"{one.name}: {one.heat:.3g} ± {one.error:.1g}\nat {one.temperature:.3g}"
        above = number % 2 == 0
        axes.annotate(
            text,
            (0.5 * (one.begin + one.end), one.temperature),
            xytext=(0, 26 if above else -26),
            textcoords="offset points",
            ha="center",
            va="bottom" if above else "top",
            fontsize=8,
            color=INK,
            arrowprops={"arrowstyle": "-", "color": QUIET, "linewidth": 0.7},
        )
    if found:
        low, high = axes.get_ylim()
        axes.set_ylim(low - 0.12 * (high - low), high + 0.12 * (high - low))
