"""When to record: at every frame, or at regular times that need not be those of frames."""

from __future__ import annotations

import dataclasses
import math
import time
from collections.abc import Iterator

import numpy as np

from gasbox.errors import UsageError
from gasbox.scenario import Stepped, Walk
from gasbox.simulation import Simulation
from gasbox.state import Frame

__all__ = ["recorded_frames"]

_ROUNDING = 1e-6
"""Of an interval: as far as two times may be apart and still be the same moment."""
_PIECES_ACROSS = 100
"""In so many of the shortest pieces the fastest disc crosses the box."""
_LONGEST = 0.2
"""Seconds after which somebody who pressed Ctrl-C wants to see that it was noticed."""


def recorded_frames(
    simulation: Simulation, frames: Iterator[Frame], end: float, interval: float | None
) -> Iterator[Frame | None]:
    """The frames to record, numbered from 0, and None at every other moment at which the run can be stopped.

    Between two frames the simulation is halted where a recorded time falls, and often enough to be stopped
    or watched however long a frame takes: looking never disturbs.

    Parameters
    ----------
    frames : the frames of the run
    end : time of the last frame [time]
    interval : between recorded frames [time]; None records each frame

    Raises
    ------
    UsageError
        The interval makes no sense.
    """
    if interval is not None:
        _check(simulation, interval)
    return _moments(simulation, frames, end, interval)


def _moments(
    simulation: Simulation, frames: Iterator[Frame], end: float, interval: float | None
) -> Iterator[Frame | None]:
    start, done, pace = simulation.time, 0, _Pace(simulation)
    rounding = _ROUNDING * (interval or 0)
    for frame in frames:
        due = interval is None or simulation.time >= start + done * interval - rounding
        yield dataclasses.replace(frame, number=done) if due else None
        done += due
        following = min(simulation.time + simulation.frame_interval, end)
        while interval is not None and start + done * interval < following - rounding:
            yield from pace.towards(start + done * interval)
            simulation.advance(until=start + done * interval)
            yield dataclasses.replace(simulation.frame_view(), number=done)
            done += 1
        yield from pace.towards(following)


class _Pace:
    """Walks a simulation in pieces that take a moment each."""

    def __init__(self, simulation: Simulation) -> None:
        self._simulation = simulation
        # Never shorter, or a machine that hangs for a while would bring it to a standstill.
        self._least = self._piece = _short_time(simulation)

    def towards(self, target: float) -> Iterator[None]:
        """Go on in pieces until less than one is missing."""
        while self._simulation.time + self._piece < target:
            begin = time.monotonic()
            self._simulation.advance(until=self._simulation.time + self._piece)
            spent = time.monotonic() - begin
            if spent < _LONGEST / 2:
                self._piece *= 2
            elif spent > _LONGEST:
                self._piece = max(self._piece / 2, self._least)
            yield None


def _short_time(simulation: Simulation) -> float:
    """Simulated time [time] in which little happens, but that takes longer to simulate than to ask for."""
    dynamics = simulation.scenario.dynamics
    if isinstance(dynamics, Stepped | Walk):
        return dynamics.time_step
    fastest = float(np.max(np.abs(simulation.state.velocity), initial=0.0))
    crossing = float(np.min(simulation.geometry.size)) / fastest if fastest > 0 else math.inf
    return min(simulation.frame_interval, crossing / _PIECES_ACROSS)


def _check(simulation: Simulation, interval: float) -> None:
    if not (interval > 0 and math.isfinite(interval)):
        raise UsageError(f"--record-every is {interval:g}; it must be above zero")
    dynamics = simulation.scenario.dynamics
    if (
        isinstance(dynamics, Stepped | Walk)
        and abs(math.remainder(interval, dynamics.time_step)) > _ROUNDING * interval
    ):
        raise UsageError(
            f"--record-every is {interval:g}; under the {dynamics.kind} rule it must be a whole multiple of the time "
            f"step, {dynamics.time_step:g}"
        )
