"""Panels of matter: who is near whom, how far discs wander, and what they belong to."""

from __future__ import annotations

from typing import Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Patch
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.observe import Displacements, PairDistribution, Phase, phase_shares
from gasbox.plots.gas import draw_gas
from gasbox.plots.panels import Species
from gasbox.plots.style import INK, QUIET, darker, dress, label, legend
from gasbox.state import State

__all__ = ["PHASE_COLORS", "draw_hexatic", "draw_msd", "draw_phases", "draw_rdf", "draw_shares"]

PHASE_COLORS: Final = {Phase.GAS: "#e0892b", Phase.LIQUID: "#1f9e89", Phase.SOLID: "#2b5fb3"}
_MOST_PAIRS: Final = 6
"""Pairs of species that are drawn, the most frequent ones."""
_STYLES: Final = ("-", "--", "-.", ":")


def draw_rdf(axes: Axes, found: PairDistribution, species: Species) -> None:
    """g(r) of each pair of species, and of all discs where there are several."""
    kinds = range(len(species))
    pairs = [(a, b) for a in kinds for b in kinds[a:] if np.any(np.isfinite(found.g[a, b]))][:_MOST_PAIRS]
    for number, (a, b) in enumerate(pairs):
        name = f"{species[a][0]} and {species[b][0]}" if a != b else species[a][0]
        style = "-" if a == b else _STYLES[1 + number % 3]
        color = darker(species[a][1], 0.85)
        axes.plot(found.r, found.g[a, b], color=color, linewidth=1.4, linestyle=style, label=name)
    if len(species) > 1:
        axes.plot(found.r, found.whole, color=INK, linewidth=1.0, alpha=0.6, label="all")
    axes.axhline(1.0, color=QUIET, linewidth=0.8, linestyle=":")
    axes.set_title("radial distribution")
    axes.set_xlabel(label("distance r", "position"))
    axes.set_ylabel("g(r)")
    axes.set_xlim(0.0, float(found.r[-1]) if found.r.size else 1.0)
    axes.set_ylim(bottom=0.0)
    dress(axes)
    if len(species) > 1:
        legend(axes, place="best")


def draw_msd(axes: Axes, found: Displacements, diffusion: float | None = None, begin: float = 0.0) -> None:
    """Mean squared displacement over time, with the line whose slope is the diffusion coefficient.

    Parameters
    ----------
    diffusion : slope/4 [length²/time]; None leaves the line out
    begin : from where on it was fitted [time]
    """
    axes.plot(found.times, found.msd, color=INK, linewidth=1.6, label="measured")
    if diffusion is not None:
        window = found.times >= begin
        time = found.times[window]
        line = np.mean(found.msd[window]) + 4.0 * diffusion * (time - np.mean(time))
        name = f"4 D t, D = {diffusion:.3g} from time {begin:.3g} on"
        axes.plot(time, line, color="#c2410c", linewidth=1.4, linestyle="--", label=name)
    axes.set_title("mean squared displacement")
    axes.set_xlabel(label("time since the start", "time"))
    axes.set_ylabel(label("mean squared displacement", "area", lines=2))
    axes.set_xlim(left=0.0)
    axes.set_ylim(bottom=0.0)
    dress(axes)
    if diffusion is not None:
        legend(axes, place="best")


def draw_hexatic(axes: Axes, time: NDArray[np.float64], order: NDArray[np.float64]) -> None:
    """Hexatic order over time: 1 for one crystal, near 0 for a liquid or gas."""
    axes.plot(time, order, color=INK, linewidth=1.5)
    axes.set_title("hexatic order")
    axes.set_xlabel(label("time", "time"))
    axes.set_ylabel("modulus of the\nmean of psi_6")
    axes.set_ylim(0.0, 1.05)
    dress(axes)


def draw_shares(axes: Axes, time: NDArray[np.float64], shares: NDArray[np.float64]) -> None:
    """Shares of discs in each phase over time.

    Parameters
    ----------
    shares : (frames, 3), of gas, liquid and solid
    """
    for phase in reversed(Phase):
        axes.plot(time, shares[:, phase], color=PHASE_COLORS[phase], linewidth=1.5, label=_name(phase))
    axes.set_title("phases")
    axes.set_xlabel(label("time", "time"))
    axes.set_ylabel("share of discs")
    axes.set_ylim(0.0, 1.05)
    dress(axes)
    legend(axes, place="best")


def draw_phases(axes: Axes, state: State, geometry: Geometry, phases: NDArray[np.int8]) -> None:
    """The gas at one moment, each disc in the colour of its phase, with a legend of their shares.

    Parameters
    ----------
    geometry : at the time of the state; its walls are displaced here
    phases : (n,) as `gasbox.observe.phases` gives them
    """
    colors = [(_name(phase), PHASE_COLORS[phase]) for phase in Phase]
    draw_gas(axes, state, geometry, colors, groups=phases)
    shares = np.nan_to_num(phase_shares(phases))
    handles = [
        Patch(facecolor=PHASE_COLORS[phase], label=f"{_name(phase)} {100.0 * shares[phase]:.0f} %")
        for phase in reversed(Phase)
    ]
    axes.legend(
        handles=handles,
        loc="upper center",
        bbox_to_anchor=(0.5, -0.14),
        ncols=len(handles),
        fontsize=8,
        frameon=False,
        labelcolor=INK,
    )


def _name(phase: Phase) -> str:
    return phase.name.lower()
