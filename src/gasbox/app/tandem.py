"""Two gases that run in step: neither goes ahead of the other, and both play, stop and begin anew together."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Final, Protocol

from gasbox.app.pace import FRAMES_PER_SECOND
from gasbox.state import SetWorld

if TYPE_CHECKING:
    from gasbox.app.session import Session
    from gasbox.scenario import Scenario
    from gasbox.simulation import Simulation

__all__ = ["Encore", "Home", "Partner", "Tandem"]

_AHEAD: Final = 2.0
"""Ticks of simulated time by which one may be ahead of the other."""
_SLIP: Final = 0.25 * FRAMES_PER_SECOND
"""Ticks of simulated time by which they may have slipped apart when both stop: the one behind makes up for it."""


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


class Encore:
    """A partner for a gas that is played again: when it begins anew it gets the same settings again, at its start.

    Attributes
    ----------
    settings : name of each setting of the world that lasts -> its value
    """

    def __init__(self, session: Session, settings: Mapping[str, float]) -> None:
        self.session = session
        self.settings = dict(settings)
        self._scenario = session.scenario

    def limit(self) -> float:
        """Nobody else is there."""
        return math.inf

    def changed(self) -> None:
        """It is no matter of its settings."""

    def stepped(self) -> None:
        """It is no matter of its settings."""

    def renewed(self, simulation: Simulation) -> None:
        """Order the settings again, before time goes on; another scenario has its own."""
        if simulation.scenario is self._scenario:
            for name, value in self.settings.items():
                self.session.change(SetWorld(name, value))


class Tandem:
    """Lets a second session run in step with a first one, which leads.

    Parameters
    ----------
    first, second : settings of each that last when both begin anew, and their sessions; of the same scenario
    """

    def __init__(self, first: Encore, second: Encore) -> None:
        self.encores = first, second
        self.first, self.second = first.session, second.session
        self._scenario = self.first.scenario
        self._begin()

    def _begin(self) -> None:
        first, second = self.first, self.second
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
        slip = _SLIP * self.first.speed * one.frame_interval
        if one.time < other.time <= one.time + slip:
            goal = other.time
            self.first.ask(lambda: self.first.show.reach(goal))
        elif other.time < one.time <= other.time + slip:
            self.second.show.reach(one.time)

    def begin_anew(self, simulation: Simulation) -> None:
        """The first has begun anew; with another scenario they part."""
        if simulation.scenario is not self._scenario:
            self.part()
            return
        self.encores[0].renewed(simulation)
        self.second.reset()


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
        self._tandem.begin_anew(simulation)


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
        self._tandem.encores[1].renewed(simulation)
