"""The frames of a run: one generator for the command line, the recorder, the page and the tests."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from gasbox.errors import UsageError
from gasbox.protocols import Observer
from gasbox.scenario import Forced, Scenario, Stepped, Walk
from gasbox.simulation.simulation import Simulation
from gasbox.state import Frame

__all__ = ["run"]


def run(
    source: Scenario | Simulation,
    *,
    until: float | None = None,
    frames: int | None = None,
    every: float | None = None,
    observers: Iterable[Observer] = (),
) -> Iterator[Frame]:
    """Run a scenario (or go on with a simulation) and yield its frames, the start first.

    Parameters
    ----------
    until : absolute time of the last frame [time]
    frames : number of frames from here; without either the run has no end
    every : simulated time between frames [time]; default: the frame interval
    observers : what reads the run

    Yields
    ------
    Frames whose arrays are the simulation's own: copy what is to be kept.

    Raises
    ------
    UsageError
        Options that make no sense together.
    ScenarioError, DynamicsError
        As for `Simulation`.
    """
    simulation = source if isinstance(source, Simulation) else Simulation(source)
    every = simulation.frame_interval if every is None else every
    last = _frames(simulation, until, frames, every)
    for observer in observers:
        simulation.attach(observer)
    return _frames_of(simulation, every, last, until)


def _frames_of(simulation: Simulation, every: float, last: float, until: float | None) -> Iterator[Frame]:
    start, first = simulation.time, simulation.frame
    yield simulation.frame_view()
    done = 0
    while done < last:
        done += 1
        time = start + done * every
        simulation.advance(until=time if until is None else min(time, until))
        simulation.frame = first + done
        simulation.observe()
        yield simulation.frame_view()


def _frames(simulation: Simulation, until: float | None, frames: int | None, every: float) -> float:
    """How many frames there will be after the start; infinity if there is no end."""
    if not (every > 0 and math.isfinite(every)):
        raise UsageError(f"the time between frames is {every:g}; it must be above zero")
    dynamics = simulation.scenario.dynamics
    if (
        isinstance(dynamics, Stepped | Forced | Walk)
        and abs(math.remainder(every, dynamics.time_step)) > 1e-6 * every
    ):
        raise UsageError(
            f"the time between frames is {every:g}; under the {dynamics.kind} rule it must be a whole multiple of "
            f"the time step, {dynamics.time_step:g}"
        )
    if frames is not None:
        if until is not None:
            raise UsageError("give either frames or until, not both")
        if frames < 0:
            raise UsageError(f"the number of frames is {frames}; it cannot be negative")
        return frames
    if until is None:
        return math.inf
    if not until >= simulation.time:
        raise UsageError(f"until is {until:g}, but the gas is at time {simulation.time:g} already")
    count = (until - simulation.time) / every * (1 - 1e-12)
    return math.ceil(count) if math.isfinite(count) else math.inf
