"""Exact flight from collision to collision."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.errors import DynamicsError
from gasbox.geometry import Rectangle
from gasbox.kernels import arguments, event_driven
from gasbox.kernels.event_driven.tables import (
    CROSSINGS,
    EVENTS,
    LABEL,
    NOW,
    PREDICTIONS,
    SORT_AT,
    STALES,
    T0,
    TESTS,
    VX,
    X,
)
from gasbox.protocols import Status
from gasbox.state import Contacts, Memory, State, Tallies

__all__ = ["EventDriven", "epoch_length"]


def epoch_length(state: State, geometry: Rectangle) -> float:
    """Length of an epoch [time]: a power of two in which a disc flies some 500 radii, or a few times across the box.

    References move to the next epoch at whole multiples of it, so that late times lose no digits.
    """
    speed = math.sqrt(float((state.velocity**2).sum(axis=1).mean())) if state.count else 0.0
    if speed == 0.0:
        return 2.0**20
    way = max(500.0 * float(np.median(state.radius)), geometry.width, geometry.height)
    return 2.0 ** round(math.log2(way / speed))


class EventDriven:
    """Discs fly freely from collision to collision; none is ever missed.

    The reference of a disc (position, velocity, time) is that of its last change of velocity. The time of a collision
    is a pure function of two references, so the bits depend on the collisions alone: not on cells, queue, or looking.

    Parameters
    ----------
    state : the particles; its arrays are changed in place
    geometry : the box
    tallies, contacts : where collisions are booked
    memory : the references and the epoch, for going on from a snapshot
    """

    sort_after = 32
    """Events a particle after which the rows are sorted in space again."""

    def __init__(
        self,
        state: State,
        geometry: Rectangle,
        tallies: Tallies,
        contacts: Contacts,
        memory: Memory | None = None,
    ) -> None:
        self.tallies = tallies
        self.contacts = contacts
        self._geometry = geometry
        self._box = arguments.box(geometry)
        if memory is None:
            self._epoch_length = epoch_length(state, geometry)
            self._epoch = math.floor(state.time / self._epoch_length)
            self.resync(state)
            return
        self._epoch_length = float(memory["epoch_length"])
        self._epoch = int(memory["epoch"])
        self._refer(state, memory["position"], memory["velocity"], memory["time"])

    @property
    def _start(self) -> float:
        return self._epoch * self._epoch_length

    def resync(self, state: State) -> None:
        """Take over `state` as it stands: its positions and velocities become the references."""
        self._refer(state, state.position, state.velocity, state.time - self._start)

    def _refer(
        self,
        state: State,
        position: NDArray[np.float64],
        velocity: NDArray[np.float64],
        time: NDArray[np.float64] | float,
    ) -> None:
        """Make new tables from references (n, 2), (n, 2), (n,), for a state at its own time."""
        size = (self._geometry.width, self._geometry.height)
        periodic = (self._geometry.periodic_x, self._geometry.periodic_y)
        self._tables = event_driven.tables(state.radius, state.mass, state.species, size, periodic)
        flight = self._tables.flight
        flight[:, X : X + 2] = position
        flight[:, VX : VX + 2] = velocity
        flight[:, T0] = time
        self._events_before = 0
        self._rate = self._expected_rate(state)
        self._rebuild(state.time - self._start)

    def _expected_rate(self, state: State) -> float:
        """Events per time to expect before any were counted; rather too many, since empty buckets cost little."""
        if not state.count:
            return 1.0
        speed = math.sqrt(float((state.velocity**2).sum(axis=1).mean()))
        spacing = math.sqrt(self._geometry.area / state.count)
        return max(8.0 * state.count * speed / spacing, 1.0 / self._epoch_length)

    def _rebuild(self, now: float) -> None:
        """Sort the rows, then find all events anew: tuning only, it touches no reference and so no bit."""
        event_driven.sort_rows(self._tables, self._box, now)
        counter = self._tables.counter
        counter[SORT_AT] = counter[EVENTS] + max(self.sort_after * self._tables.mass.size, 16)
        event_driven.rebuild(self._tables, self._box, now, self._epoch_length, self._rate)

    def _next_epoch(self) -> None:
        events = int(self._tables.counter[EVENTS])
        event_driven.shift(self._tables.flight, self._box, self._epoch_length)
        self._epoch += 1
        self._rate = max(events - self._events_before, 1) / self._epoch_length
        self._events_before = events
        self._rebuild(0.0)

    def advance(self, state: State, until: float) -> Status:
        """Execute all events up to and including the absolute time `until` [time]."""
        rows = np.array([self.contacts.count], np.int64)
        book = arguments.ledger(self.tallies, self.contacts, rows, state)
        while True:
            local = min(until - self._start, self._epoch_length)
            status = event_driven.advance(self._tables, self._box, book, local, self._start)
            if status == event_driven.SORT:
                self._rebuild(float(self._tables.number[NOW]))
            elif status == arguments.DONE and until - self._start >= self._epoch_length:
                self._next_epoch()
            else:
                break
        self.contacts.count = int(rows[0])
        if status == arguments.NO_PROGRESS:
            moment = self._start + float(self._tables.number[NOW])
            raise DynamicsError(
                f"very many collisions at one moment (time {moment:g}): the discs are jammed or touch "
                "all around; start them a little apart"
            )
        if status == arguments.FULL:
            return Status.FULL
        flight, link = self._tables.flight, self._tables.link
        event_driven.project(flight, link, self._box, until - self._start, arguments.gas(state))
        state.time = until
        return Status.DONE

    def memory(self) -> Memory:
        """``epoch_length``, ``epoch`` and the references: ``position``, ``velocity``, ``time`` (since its start)."""
        flight = np.empty_like(self._tables.flight)
        flight[self._tables.link[:, LABEL]] = self._tables.flight
        return {
            "epoch_length": self._epoch_length,
            "epoch": self._epoch,
            "position": flight[:, X : X + 2].copy(),
            "velocity": flight[:, VX : VX + 2].copy(),
            "time": flight[:, T0].copy(),
        }

    def effort(self) -> dict[str, int]:
        """What finding the events has cost so far: numbers that don't depend on the machine."""
        counter = self._tables.counter
        names = {"events": EVENTS, "pair_tests": TESTS, "predictions": PREDICTIONS}
        names |= {"crossings": CROSSINGS, "stale_events": STALES}
        return {name: int(counter[column]) for name, column in names.items()}
