"""The classroom rule, step by step."""

from __future__ import annotations

import math

import numpy as np

from gasbox.dynamics.team import Team, processors
from gasbox.geometry import Rectangle
from gasbox.kernels import arguments, stepped
from gasbox.protocols import Status
from gasbox.state import Contacts, Memory, State, Tallies

__all__ = ["Stepped"]

_FEW = 5_000
"""Particles a thread below which more threads are not worth their meetings."""


def _fitting_threads(particles: int) -> int:
    return max(1, min(processors(), particles // _FEW))


class Stepped:
    """Move all discs by velocity * time_step, then execute the collisions of touching, approaching pairs, then walls.

    Time exists in whole steps only: `advance` goes to the last step at or before the time asked for.

    Parameters
    ----------
    state : the particles; its arrays are changed in place
    geometry : the box
    time_step : [time]
    tallies, contacts : where collisions are booked
    memory : ``step``, for going on from a snapshot
    threads : how many work together; None takes as many as there are processors if there are many particles.
        It changes no bit.
    """

    def __init__(
        self,
        state: State,
        geometry: Rectangle,
        time_step: float,
        tallies: Tallies,
        contacts: Contacts,
        memory: Memory | None = None,
        threads: int | None = None,
    ) -> None:
        self.time_step = time_step
        self.tallies = tallies
        self.contacts = contacts
        self._box = arguments.box(geometry)
        self._threads = threads
        self._clock = np.array([int(memory["step"]) if memory else 0], np.int64)
        self.resync(state)

    def resync(self, state: State) -> None:
        """Take over the particles of `state`."""
        self._team = Team(self._threads or _fitting_threads(state.count))
        self._grid = stepped.grid(state.radius, self._box.width, self._box.height)
        self._room = stepped.room(self._grid, state, self._team.threads)
        state.time = self._time

    @property
    def _time(self) -> float:
        return float(self._clock[0]) * self.time_step

    def step_at(self, time: float) -> int:
        """The last step at or before `time`, forgiving a billionth of a step."""
        return math.floor(time / self.time_step + 1e-9)

    def advance(self, state: State, until: float) -> Status:
        """Take whole steps up to the last one at or before `until` [time]."""
        count = np.array([self.contacts.count], np.int64)
        book = arguments.ledger(self.tallies, self.contacts, count, state)
        target = self.step_at(until)
        while True:
            status = self._team.run(
                stepped.advance,
                arguments.gas(state),
                self._box,
                self._grid,
                self._room,
                book,
                self._clock,
                target,
                self.time_step,
            )
            if status != stepped.GROW:
                break
            longest = int(self._room.lists.found.max())
            self._room = self._room._replace(lists=stepped.lists(self._team.threads, 2 * longest))
        self.contacts.count = int(count[0])
        state.time = self._time
        return Status.FULL if status == arguments.FULL else Status.DONE

    def memory(self) -> Memory:
        """``step``: steps done since time 0."""
        return {"step": int(self._clock[0])}
