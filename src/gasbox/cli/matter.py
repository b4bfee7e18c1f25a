"""Panels of matter from a recording: who is near whom, how far discs wander, solid, liquid and gas."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Final

import numpy as np

from gasbox import observe
from gasbox.cli.frames import MOST_FRAMES, MOST_FRAMES_OF_PAIRS, show, spread
from gasbox.plots import (
    Panel,
    draw_heating_curve,
    draw_hexatic,
    draw_msd,
    draw_phases,
    draw_rdf,
    draw_shares,
)
from gasbox.recording import Recording
from gasbox.scenario import Scenario
from gasbox.state import SetBarostat

__all__ = ["FIGURES_OF_MATTER", "matter_panels", "neighbour_distance", "outer_pressure"]

FIGURES_OF_MATTER: Final = {
    "rdf": "radial distribution function",
    "msd": "mean squared displacement",
    "hexatic": "hexatic order and phases over time",
    "heating-curve": "temperature against heat added",
    "phases": "the last frame, discs coloured by phase",
}
"""Figures of matter, and what they show."""

_NEAR: Final = 1.5
"""Neighbours reach so far, in units of sigma: between the first ring of neighbours and the second."""
_FAR: Final = 6.0
"""How far g(r) is drawn, in units of sigma, or half-way across the box."""
_BINS: Final = 150
_LEAST_HEAT: Final = 1e-3
"""Heat added, as a share of the temperature, below which there is no heating curve."""


def matter_panels(name: str, recording: Recording, first: int) -> list[Panel]:
    """The panels of one figure of `FIGURES_OF_MATTER`; none if this recording has nothing to show there.

    Parameters
    ----------
    first : frame from which on g(r) is averaged
    """
    scenario = recording.scenario
    kinds = [(entry.name, entry.color) for entry in scenario.kinds]
    near, geometry, frames = neighbour_distance(scenario), recording.geometry_at(0), recording.frames
    match name:
        case "rdf" if recording.read(first).state.count > 1:
            far = min(_FAR * near / _NEAR, 0.5 * float(min(geometry.size)))
            pairs = observe.RadialDistribution(geometry, len(kinds), _BINS, far)
            show(recording, [pairs], spread(first, frames, MOST_FRAMES_OF_PAIRS))
            return [partial(draw_rdf, found=pairs.value(), species=kinds)]
        case "msd" if frames > 2:
            way = observe.MeanSquaredDisplacement(geometry)
            # All frames: between two of them no disc may go half-way round the box.
            show(recording, [way], range(frames))
            found = way.value()
            slope = observe.diffusion_coefficient(found)
            return [partial(draw_msd, found=found, diffusion=slope, begin=0.5 * float(found.times[-1]))]
        case "hexatic" if frames > 1:
            curve = observe.HeatingCurve(geometry, distance=near)
            order: list[float] = []
            numbers = spread(0, frames, MOST_FRAMES)
            for number in numbers:
                frame, here = recording.read(number), recording.geometry_at(number)
                curve.observe(frame.state, frame.tallies)
                order.append(observe.hexatic_order(frame.state, here, near))
            course = curve.value()
            return [
                partial(draw_hexatic, time=recording.times[list(numbers)], order=np.array(order)),
                partial(draw_shares, time=course.time, shares=course.shares),
            ]
        case "heating-curve" if frames > 4:
            heating = observe.HeatingCurve(geometry, outer_pressure(recording), near)
            show(recording, [heating], spread(0, frames, MOST_FRAMES))
            course = heating.value()
            least = _LEAST_HEAT * float(np.nanmax(course.temperature, initial=0.0))
            return [partial(draw_heating_curve, curve=course)] if np.ptp(course.heat) > least else []
        case "phases":
            last, end = recording.read(-1).state, recording.geometry_at(-1)
            return [partial(draw_phases, state=last, geometry=end, phases=observe.phases(last, end, near))]
        case _:
            return []


def neighbour_distance(scenario: Scenario) -> float:
    """Distance within which discs are neighbours [length]: 1.5 times the mean sigma, or diameter, of all kinds."""
    sizes = [entry.sigma or 2.0 * entry.radius for entry in scenario.species]
    sizes += [2.0 * kind.half_width for kind in scenario.kinds[len(sizes) :]]
    counts = [kind.count for kind in scenario.kinds]
    return _NEAR * float(np.average(sizes, weights=counts if any(counts) else None))


def outer_pressure(recording: Recording) -> Callable[[float], float]:
    """Pressure at which the barostat aims [mass/time²], as a function of time; 0 where there is none."""
    barostat = recording.scenario.barostat
    planned = [(entry.at, entry.change()) for entry in recording.scenario.schedule]
    aims = {
        (time, change)
        for time, change in [*planned, *recording.changes]
        if isinstance(change, SetBarostat) and change.pressure is not None
    }
    times, pressures = [-np.inf], [0.0 if barostat is None else barostat.pressure]
    for time, change in sorted(aims, key=lambda entry: entry[0]):
        assert change.pressure is not None
        # A new aim starts from where the pressure is then; what was planned beyond that is dropped.
        here = float(np.interp(time, times, pressures))
        kept = [k for k, moment in enumerate(times) if moment < time]
        times = [*(times[k] for k in kept), time, time + change.over]
        pressures = [*(pressures[k] for k in kept), here, change.pressure]
    return lambda time: float(np.interp(time, times, pressures))
