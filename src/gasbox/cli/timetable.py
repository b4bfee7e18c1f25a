"""When to record: at every frame, or at regular times that need not be those of frames."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator

from gasbox.errors import UsageError
from gasbox.scenario import Stepped
from gasbox.simulation import Simulation
from gasbox.state import Frame

__all__ = ["recorded_frames"]

_ROUNDING = 1e-6
"""Of an interval: as far as two times may be apart and still be the same moment."""


def recorded_frames(
    simulation: Simulation, frames: Iterator[Frame], end: float, interval: float | None
) -> Iterator[Frame | None]:
    """The frames to record, numbered from 0, and None for each frame that is not to be recorded.

    Between two frames the simulation is stopped where a recorded time falls: looking never disturbs.

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
    if interval is None:
        return _all(frames)
    _check(simulation, interval)
    return _timed(simulation, frames, end, interval)


def _all(frames: Iterator[Frame]) -> Iterator[Frame]:
    for number, frame in enumerate(frames):
        yield dataclasses.replace(frame, number=number)


def _timed(
    simulation: Simulation, frames: Iterator[Frame], end: float, interval: float
) -> Iterator[Frame | None]:
    start, done, rounding = simulation.time, 0, _ROUNDING * interval
    for frame in frames:
        due = frame.state.time >= start + done * interval - rounding
        yield dataclasses.replace(frame, number=done) if due else None
        done += due
        following = min(frame.state.time + simulation.frame_interval, end)
        while start + done * interval < following - rounding:
            simulation.advance(until=start + done * interval)
            yield dataclasses.replace(simulation.frame_view(), number=done)
            done += 1


def _check(simulation: Simulation, interval: float) -> None:
    if not (interval > 0 and math.isfinite(interval)):
        raise UsageError(f"--record-every is {interval:g}; it must be above zero")
    dynamics = simulation.scenario.dynamics
    if (
        isinstance(dynamics, Stepped)
        and abs(math.remainder(interval, dynamics.time_step)) > _ROUNDING * interval
    ):
        raise UsageError(
            f"--record-every is {interval:g}; under the stepped rule it must be a whole multiple of the time "
            f"step, {dynamics.time_step:g}"
        )
