"""Two gases that run in step: neither goes ahead of the other, and both play, stop and begin anew together."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final, Protocol

from gasbox.app.pace import FRAMES_PER_SECOND

if TYPE_CHECKING:
    from gasbox.app.session import Session
    from gasbox.scenario import Scenario
    from gasbox.simulation import Simulation

__all__ = ["Home", "Partner", "Tandem"]

_AHEAD: Final = 2.0
"""Ticks of simulated time by which one may be ahead of the other."""
_NEAR: Final = 0.25 * FRAMES_PER_SECOND
"""Ticks of simulated time that one makes up for when both stop."""


class Home(Protocol):
    """Where sessions come from: there may be another one beside a session."""

    def open(self, scenario: Scenario) -> Session:
        """A new session, which has no gas yet."""
        ...

    def dismiss(self, session: Session) -> None:
        """End a session, and free its place. Waits for the beat at hand."""
        ...


class Partner(Protocol):
    """What a gas hears and tells of the one that runs in step with it. Called in the thread of its session."""

    def limit(self) -> float:
        """How far it may go now [time]."""
        ...

    def changed(self) -> None:
        """Play, pause or speed have changed."""
        ...

    def stepped(self) -> None:
        """It went on by one frame."""
        ...

    def renewed(self, simulation: Simulation) -> None:
        """There is another gas, or the same from its start."""
        ...


class Tandem:
    """Lets a second session run in step with a first one, which leads.

    The second must show the same scenario.
    """

    def __init__(self, first: Session, second: Session) -> None:
        self.first, self.second = first, second
        self._scenario = first.scenario
        second.set_speed(first.speed)
        first.show.partner, second.show.partner = _Leader(self), _Follower(self)
        second.play(first.playing)

    def part(self) -> None:
        """Each goes its own way again."""
        self.first.show.partner = self.second.show.partner = None
        self.first.wake()

    def limit(self, other: Session) -> float:
        """How far the one beside `other` may go [time]."""
        simulation = other.show.gas
        if simulation is None or other.trouble is not None:
            return math.inf
        step = float(getattr(simulation.scenario.dynamics, "time_step", 0.0))
        return simulation.time + max(_AHEAD * self.first.speed * simulation.frame_interval, step)

    def mirror(self) -> None:
        """The second does as the first; when both stop, at the same time."""
        self.second.set_speed(self.first.speed)
        self.second.play(self.first.playing)
        if not self.first.playing:
            self.second.ask(self._level)

    def _level(self) -> None:
        """In the second's thread, after it has stopped: the one that is behind makes up for it."""
        one, other = self.first.show.gas, self.second.show.gas
        if one is None or other is None:
            return
        near = _NEAR * self.first.speed * one.frame_interval
        if one.time < other.time <= one.time + near:
            goal = other.time
            self.first.ask(lambda: self.first.show.reach(goal))
        elif other.time < one.time <= other.time + near:
            self.second.show.reach(one.time)

    def begin_anew(self, scenario: Scenario) -> None:
        """The first has begun anew; with another scenario they part."""
        if scenario is self._scenario:
            self.second.reset()
        else:
            self.part()


class _Leader:
    """The partner of the first."""

    def __init__(self, tandem: Tandem) -> None:
        self._tandem = tandem

    def limit(self) -> float:
        return self._tandem.limit(self._tandem.second)

    def changed(self) -> None:
        self._tandem.mirror()

    def stepped(self) -> None:
        self._tandem.second.step()

    def renewed(self, simulation: Simulation) -> None:
        self._tandem.begin_anew(simulation.scenario)


class _Follower:
    """The partner of the second."""

    def __init__(self, tandem: Tandem) -> None:
        self._tandem = tandem

    def limit(self) -> float:
        return self._tandem.limit(self._tandem.first)

    def changed(self) -> None:
        """It never begins."""

    def stepped(self) -> None:
        """It never begins."""

    def renewed(self, simulation: Simulation) -> None:
        """It never begins."""
