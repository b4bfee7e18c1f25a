"""Panels of molecules from a recording: energies of each degree of freedom, laws of rotation, orientation."""

from __future__ import annotations

from functools import partial
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox import observe
from gasbox.cli.frames import MOST_FRAMES, MOST_FRAMES_OF_PAIRS, show, spread
from gasbox.plots import Panel, draw_law, draw_modes, draw_order, draw_orientation, draw_turning
from gasbox.recording import Recording
from gasbox.scenario import Kind
from gasbox.theory import rotors

__all__ = ["FIGURES_OF_MOLECULES", "molecule_panels"]

FIGURES_OF_MOLECULES: Final = {
    "modes": "energy of each degree of freedom over time",
    "rotation": "angular velocities and whole energies of molecules",
    "orientation": "how molecules are turned to each other, and how long they remember",
}
"""Figures of molecules, and what they show."""

_BINS: Final = 40
_WIDTHS: Final = 3.5
"""How many standard deviations an axis of angular velocities reaches to either side."""
_HOTTEST: Final = 7.0
"""Where an axis of energies ends, in units of T."""
_REACH: Final = 6.0
"""How far pairs are drawn, in radii of the molecule, or half-way across the box."""
_MOST_KINDS: Final = 3
"""Kinds of molecule that get panels of their own, the most frequent ones."""


def molecule_panels(
    name: str, recording: Recording, first: int, temperature: float | None = None
) -> list[Panel]:
    """The panels of one figure of `FIGURES_OF_MOLECULES`; none if nothing rotates there.

    Parameters
    ----------
    first : frame from which on means are taken
    temperature : mean over these frames [energy]
    """
    state = recording.read(first).state
    kinds = [(k, kind) for k, kind in enumerate(recording.scenario.kinds) if kind.inertia > 0.0]
    counts = [int(np.count_nonzero(state.species == k)) for k, _ in kinds]
    order = sorted(range(len(kinds)), key=lambda place: -counts[place])[:_MOST_KINDS]
    present = [kinds[place] for place in order if counts[place]]
    if not present:
        return []
    match name:
        case "modes" if recording.frames > 1:
            modes = observe.Modes(recording.geometry_at(0))
            show(recording, [modes], spread(0, recording.frames, MOST_FRAMES))
            return [partial(draw_modes, modes=modes.series(), temperature=temperature)]
        case "rotation":
            return [panel for k, kind in present for panel in _laws(recording, first, k, kind, temperature)]
        case "orientation":
            pairs = [panel for k, kind in present for panel in _orientation(recording, first, k, kind)]
            memory = [
                panel for k, kind in present for panel in _memory(recording, first, k, kind, temperature)
            ]
            return [*pairs, *memory, *_order(recording)]
        case _:
            return []


def _laws(
    recording: Recording, first: int, number: int, kind: Kind, temperature: float | None
) -> list[Panel]:
    """Histograms of one kind of molecule with their laws: means over frames from `first` on."""
    warmth = temperature or _warmest(recording, first, number)
    end = _WIDTHS * float(np.sqrt(warmth / kind.inertia))
    freedom = 2 * len(kind.sites) if kind.flexible else 3
    rates = np.linspace(-end, end, _BINS + 1)
    energies = np.linspace(0.0, _HOTTEST * warmth, _BINS + 1)
    kinds = len(recording.scenario.kinds)
    spins = observe.HistogramAverage([rates] * kinds, "angular-velocity")
    whole = observe.HistogramAverage([energies] * kinds, "whole-energy")
    show(recording, [spins, whole], spread(first, recording.frames, MOST_FRAMES))
    turning, energy = spins.histograms()[number], whole.histograms()[number]
    normal = gamma = None
    if temperature:
        normal = turning.total * np.diff(rotors.angular_velocity_cdf(rates, kind.inertia, temperature))
        gamma = energy.total * np.diff(rotors.energy_cdf(energies, temperature, freedom))
    panels: list[Panel] = []
    if not kind.flexible:
        # Of flexible ones the moment of inertia is no constant.
        axis = "angular velocity", "angular_velocity"
        panels = [
            partial(
                draw_law,
                shown=turning,
                expected=normal,
                color=kind.color,
                title=kind.name,
                axis=axis,
                law="normal law",
            )
        ]
    axis = "kinetic energy in all", "energy"
    return [
        *panels,
        partial(
            draw_law,
            shown=energy,
            expected=gamma,
            color=kind.color,
            title=kind.name,
            axis=axis,
            law="Gamma law",
        ),
    ]


def _warmest(recording: Recording, first: int, number: int) -> float:
    """Twice the mean energy of rotation [energy], or 1: for an axis where nobody says a temperature."""
    energy = observe.rotational_energies(recording.read(first).state)
    mean = float(np.mean(energy[recording.read(first).state.species == number]))
    return 2.0 * mean if mean > 0.0 else 1.0


def _orientation(recording: Recording, first: int, number: int, kind: Kind) -> list[Panel]:
    geometry = recording.geometry_at(0)
    far = min(_REACH * kind.radius, 0.5 * float(min(geometry.size)))
    pairs = observe.OrientationCorrelation(geometry, _BINS, far, number)
    show(recording, [pairs], spread(first, recording.frames, MOST_FRAMES_OF_PAIRS))
    found = pairs.value()
    if not np.any(found.pairs):
        return []
    return [partial(draw_orientation, found=found, title=f"{kind.name}: orientation of pairs")]


def _memory(
    recording: Recording, first: int, number: int, kind: Kind, temperature: float | None
) -> list[Panel]:
    """Of frames from `first` on that are equally far apart in time."""
    turning = observe.Turning(number)
    last = min(recording.frames, first + MOST_FRAMES)
    steps = np.diff(recording.times[first:last])
    if steps.size < 2 or np.ptp(steps) > 1e-6 * np.max(steps):
        return []
    show(recording, [turning], range(first, last))
    found = turning.value()
    free: list[NDArray[np.float64]] = []
    if temperature and not kind.flexible:
        free = [rotors.free_turning(found.times, kind.inertia, temperature, fold) for fold in (1, 2)]
    return [partial(draw_turning, found=found, free=free, title=f"{kind.name}: memory of orientation")]


def _order(recording: Recording) -> list[Panel]:
    numbers = spread(0, recording.frames, MOST_FRAMES)
    orders = [observe.nematic_order(recording.read(number).state) for number in numbers]
    values = np.array([np.nan if one is None else one.order for one in orders])
    state = recording.read(-1).state
    turning = int(np.sum(observe.degrees_of_rotation(state)))
    chance = rotors.mean_order(max(turning, 1))
    return [partial(draw_order, time=recording.times[list(numbers)], order=values, chance=chance)]
