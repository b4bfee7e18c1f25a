"""Moves a simulation on in real time, without threads: whoever owns it calls `beat`."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from gasbox.app.pace import FRAMES_PER_SECOND, Account, Slices, Ticks

if TYPE_CHECKING:
    from gasbox.simulation import Simulation

__all__ = ["BUDGET", "Motion"]

BUDGET: Final = 0.012
"""Seconds per tick that the engine may use; the rest belongs to encoding and to the other threads."""


class Motion:
    """A simulation and the way in which its time follows ours.

    Event-driven gases move by any fraction of a frame. Stepped ones move by whole steps, which below speed 1
    are spread over the ticks.
    """

    def __init__(
        self, simulation: Simulation, speed: float, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self.simulation = simulation
        self.speed = speed
        self._clock = clock
        self._quantum = float(getattr(simulation.scenario.dynamics, "time_step", 0.0))
        self._slices = Slices(first=max(self._quantum, simulation.frame_interval / 16))
        self._account = Account(simulation.frame_interval)
        self._ticks = Ticks(clock())
        self._last = clock()
        self._goal = simulation.time
        self.moved = False
        """Whether the last beat changed anything."""

    @property
    def frame(self) -> int:
        """Whole frames of simulated time since time 0."""
        return math.floor(self.simulation.time / self.simulation.frame_interval + 1e-6)

    @property
    def speed_reached(self) -> float | None:
        """The speed reached over the last second; None before it was measured."""
        return self._account.speed()

    @property
    def keeping_up(self) -> bool:
        """Whether the speed that was asked for is reached."""
        return self._account.keeping_up()

    def begin(self, speed: float) -> None:
        """Count real time from now: after a pause, a change of speed, or when the page is seen again."""
        now = self._clock()
        self.speed = speed
        self._ticks = Ticks(now)
        self._last = now
        self._goal = self.simulation.time
        self._account.clear()
        if self._quantum == 0:
            # Twice, because the first call of all may do more than usual.
            self._slices.costs(min(self._empty_call(), self._empty_call()))

    def _empty_call(self) -> float:
        begun = self._clock()
        self.simulation.advance(until=self.simulation.time)
        return self._clock() - begun

    def beat(self, limit: float = math.inf) -> float:
        """Advance as far as is due, within the budget and up to `limit` [time]; the seconds until the next beat."""
        begun = self._clock()
        ticks = self._ticks.due(begun)
        start = self.simulation.time
        if ticks:
            interval = self.simulation.frame_interval
            asked = ticks * self.speed * interval
            missed = max(0.0, (begun - self._last) * FRAMES_PER_SECOND - ticks - 1) * self.speed * interval
            self._goal += asked
            self._advance(min(self._goal, limit), begun + BUDGET)
            # Less than a step cannot be made yet, and what was only put off for another gas that runs in step
            # comes with the next ticks: neither is given up.
            put_off = self._quantum if limit == math.inf else self._quantum + 2.0 * asked
            behind = max(0.0, self._goal - self.simulation.time - put_off)
            self._goal -= behind
            self._account.add(begun, begun - self._last, self.simulation.time - start, behind + missed)
            self._last = begun
        self.moved = self.simulation.time != start
        return self._ticks.wait(self._clock())

    def step(self) -> None:
        """On to the next whole frame, however long it takes."""
        self.simulation.advance(until=(self.frame + 1) * self.simulation.frame_interval)
        self._goal = self.simulation.time

    def _advance(self, goal: float, deadline: float) -> None:
        """Slice by slice up to `goal` [time], until the clock shows `deadline` [s]."""
        simulation, begun = self.simulation, self._clock()
        while (until := self._next(simulation.time, goal, deadline - begun)) is not None:
            before = simulation.time
            simulation.advance(until=until)
            now = self._clock()
            self._slices.took(simulation.time - before, now - begun)
            begun = now
            if deadline - now < 0.2 * BUDGET:
                return

    def _next(self, now: float, goal: float, seconds: float) -> float | None:
        """Where the next slice ends, or None if `goal` is reached as far as whole steps allow."""
        # A part of the time left, because a slice may take longer than the one before.
        size = self._slices.size(0.7 * seconds)
        if self._quantum == 0:
            return min(goal, now + size) if goal > now else None
        steps = math.floor((goal - now) / self._quantum + 1e-6)
        if steps < 1:
            return None
        steps = min(steps, max(1, int(size / self._quantum)))
        return (round(now / self._quantum) + steps) * self._quantum
