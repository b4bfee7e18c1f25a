"""Exact flight from collision to collision."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.dynamics.changes import as_enclosure
from gasbox.dynamics.epochs import epoch_length, expected_rate
from gasbox.dynamics.halls import make_hall, set_waves, start_walls, turn_walls, wall_rows
from gasbox.errors import DynamicsError
from gasbox.geometry import Enclosure, Geometry, Rectangle
from gasbox.kernels import arguments, event_driven
from gasbox.kernels.event_driven.tables import (
    COLUMNS,
    CROSSINGS,
    CROWDED,
    EVENTS,
    FIRST,
    LABEL,
    LEVEL,
    NOW,
    PREDICTIONS,
    RADIUS,
    ROWS,
    SORT_AT,
    SPECIES,
    STALES,
    T0,
    TESTS,
    VX,
    X,
)
from gasbox.kernels.hall import Hall, with_cells
from gasbox.kernels.hall.motion import next_turn, shift_walls, show_walls
from gasbox.kernels.molecules.spin import ANGLE, TURNING, show_turns, spin
from gasbox.protocols import Status
from gasbox.state import Contacts, Memory, State, Tallies

__all__ = ["EventDriven"]

_REFERENCES = ("position", "velocity", "time", "angle", "angular_velocity")


class EventDriven:
    """Discs fly freely from collision to collision; none is ever missed.

    The reference of a disc (position, velocity, time) is that of its last change of velocity. The time of a collision
    is a pure function of two references, so the bits depend on the collisions alone: not on cells, queue, or looking.

    Parameters
    ----------
    state : the particles; its arrays are changed in place
    geometry : the box, or the enclosure
    tallies, contacts : where collisions are booked
    memory : the references and the epoch, for going on from a snapshot
    seed : of the random numbers of thermal walls
    """

    sort_after = 32
    """Events a particle after which the rows are sorted in space again."""

    def __init__(
        self,
        state: State,
        geometry: Geometry,
        tallies: Tallies,
        contacts: Contacts,
        memory: Memory | None = None,
        seed: int = 0,
    ) -> None:
        self.tallies = tallies
        self.contacts = contacts
        self._seed = seed
        self._hall: Hall | None = None
        self._enter(geometry, state)
        if memory is None:
            self._epoch_length = epoch_length(state, geometry)
            self._epoch = math.floor(state.time / self._epoch_length)
            self._set_walls(state)
            self.resync(state)
            return
        self._epoch_length = float(memory["epoch_length"])
        self._epoch = int(memory["epoch"])
        self._set_walls(state, memory.get("walls"))
        self._refer(state, memory)

    def _enter(self, geometry: Geometry, state: State) -> None:
        # The kernels know the sides of a plain rectangle for discs alone.
        turns = state.sites is not None and state.sites.count > state.count
        self._geometry = as_enclosure(geometry) if turns else geometry
        self._box = arguments.box(geometry)
        species = self.tallies.pair_collisions.shape[0]
        self._bare = make_hall(self._geometry, species, self._seed)

    def _set_walls(self, state: State, rows: NDArray[np.float64] | None = None) -> None:
        """Set walls in motion: as remembered, or at the time of the state, pistons where the state has them."""
        if self._bare is not None:
            start_walls(self._bare, self._geometry, state, self._start, rows)
            self._show_walls(state)

    def _show_walls(self, state: State) -> None:
        if self._bare is not None and self._geometry.moves:
            if not state.wall_displacement.size:
                state.wall_displacement = np.zeros(len(self._bare.wall))
                state.wall_velocity = np.zeros(len(self._bare.wall))
            show_walls(self._bare, state.time - self._start, state.wall_displacement, state.wall_velocity)

    def alter(self, state: State, geometry: Geometry) -> None:
        """Take over another geometry at the time of the state; walls that move do so from where they are."""
        self._enter(geometry, state)
        self._set_walls(state)
        self.resync(state)

    @property
    def _start(self) -> float:
        return self._epoch * self._epoch_length

    def resync(self, state: State) -> None:
        """Take over `state` as it stands: its positions and velocities become the references."""
        here = {"position": state.position, "velocity": state.velocity, "time": state.time - self._start}
        self._refer(state, here)

    def _refer(self, state: State, references: Memory) -> None:
        """Make new tables from references (as `memory` has them), for a state at its own time."""
        self._box = self._box_around(state)
        size, periodic = (self._box.width, self._box.height), (self._box.periodic_x, self._box.periodic_y)
        self._tables = event_driven.tables(state.radius, state.mass, state.species, size, periodic)
        flight = self._tables.flight
        flight[:, X : X + 2] = references["position"]
        flight[:, VX : VX + 2] = references["velocity"]
        flight[:, T0] = references["time"]
        self._spin = spin(state, self.tallies.pair_collisions.shape[0])
        if self._spin is not None:
            self._spin.turn[:, ANGLE] = references.get("angle", state.angle)
            self._spin.turn[:, TURNING] = references.get("angular_velocity", state.angular_velocity)
            # Molecules are looked for in their bounding circles, and these overlap.
            self._tables.levels[:, CROWDED] = 0
        self._hall = None if self._bare is None else self._with_cells(self._bare)
        self._events_before = 0
        self._rate = expected_rate(state, self._geometry, self._epoch_length)
        self._rebuild(state.time - self._start)

    def _box_around(self, state: State) -> arguments.Box:
        """The box that the cells divide; where a side has moved out, a larger one."""
        box = arguments.box(self._geometry)
        if not state.wall_displacement.size or not isinstance(self._geometry, Enclosure):
            return box
        if not isinstance(self._geometry.container, Rectangle):
            return box
        return box._replace(
            width=max(box.width, box.width + state.wall_displacement[1]),
            height=max(box.height, box.height + state.wall_displacement[3]),
        )

    def _with_cells(self, hall: Hall) -> Hall:
        """The hall with lists of the elements near each cell."""
        levels, link = self._tables.levels, self._tables.link
        if self._geometry.moves:
            # Beyond the box discs crowd in the outermost cells, however narrow these are.
            levels[:, CROWDED] = 0
        largest = np.zeros(len(levels))
        np.maximum.at(largest, link[:, LEVEL], self._tables.flight[:, RADIUS])
        size = np.array([self._box.width, self._box.height])
        columns, rows, first = (levels[:, column].copy() for column in (COLUMNS, ROWS, FIRST))
        return with_cells(hall, size, self._geometry.periodic, columns, rows, first, largest)

    def _rebuild(self, now: float) -> None:
        """Sort the rows, then find all events anew: tuning only, it touches no reference and so no bit."""
        event_driven.sort_rows(self._tables, self._box, self._hall, self._spin, now)
        counter = self._tables.counter
        counter[SORT_AT] = counter[EVENTS] + max(self.sort_after * self._tables.mass.size, 16)
        event_driven.rebuild(
            self._tables, self._box, self._hall, self._spin, now, self._epoch_length, self._rate
        )

    def _next_epoch(self) -> None:
        events = int(self._tables.counter[EVENTS])
        event_driven.shift(self._tables.flight, self._box, self._hall, self._spin, self._epoch_length)
        if self._hall is not None:
            shift_walls(self._hall, self._epoch_length)
        self._epoch += 1
        if self._hall is not None:
            set_waves(self._hall, self._geometry, self._start)
        self._rate = max(events - self._events_before, 1) / self._epoch_length
        self._events_before = events
        self._rebuild(0.0)

    def advance(self, state: State, until: float) -> Status:
        """Execute all events up to and including the absolute time `until` [time]."""
        rows = np.array([self.contacts.count], np.int64)
        book = arguments.ledger(self.tallies, self.contacts, rows, state)
        while True:
            local = min(until - self._start, self._epoch_length)
            status = event_driven.advance(
                self._tables, self._box, self._hall, self._spin, book, local, self._start
            )
            if status == event_driven.SORT:
                self._rebuild(float(self._tables.number[NOW]))
            elif status == event_driven.TURN:
                self._turn()
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
        local = until - self._start
        event_driven.project(flight, link, self._box, self._hall, local, arguments.gas(state))
        if self._spin is not None:
            elapsed = local - flight[:, T0]
            show_turns(self._spin, link[:, LABEL].copy(), elapsed, state.angle, state.angular_velocity)
        state.turn_sites()
        state.time = until
        self._show_walls(state)
        if self._hall is not None and np.any(link[:, SPECIES] < 0):
            self._see_off(state)
        return Status.DONE

    def _turn(self) -> None:
        """Let walls whose motion has come to a corner or a stop go on, and all discs look for them anew."""
        assert self._hall is not None
        now = next_turn(self._hall)
        for wall in turn_walls(self._hall, self._geometry, now, self._start):
            event_driven.meet_moved(self._tables, self._hall, self._spin, self._box, wall, -1, now)

    def _see_off(self, state: State) -> None:
        """Let go of the discs that have left: tables without them, from the same references."""
        memory = self.memory()
        stays = np.ones(state.count, np.bool_)
        stays[self._tables.link[self._tables.link[:, SPECIES] < 0, LABEL]] = False
        state.keep(stays)
        self._refer(state, {name: memory[name][stays] for name in _REFERENCES if name in memory})

    def memory(self) -> Memory:
        """``epoch_length``, ``epoch`` and the references: ``position``, ``velocity``, ``time`` (since its start).

        Of molecules ``angle`` and ``angular_velocity``, too.
        """
        order = np.argsort(self._tables.link[:, LABEL])
        flight = self._tables.flight[order]
        memory: Memory = {
            "epoch_length": self._epoch_length,
            "epoch": self._epoch,
            "position": flight[:, X : X + 2].copy(),
            "velocity": flight[:, VX : VX + 2].copy(),
            "time": flight[:, T0].copy(),
        }
        if self._spin is not None:
            memory["angle"] = self._spin.turn[order, ANGLE]
            memory["angular_velocity"] = self._spin.turn[order, TURNING]
        if self._bare is not None and self._geometry.moves:
            memory["walls"] = wall_rows(self._bare)
        return memory

    def effort(self) -> dict[str, int]:
        """What finding the events has cost so far: numbers that don't depend on the machine."""
        counter = self._tables.counter
        names = {"events": EVENTS, "pair_tests": TESTS, "predictions": PREDICTIONS}
        names |= {"crossings": CROSSINGS, "stale_events": STALES}
        return {name: int(counter[column]) for name, column in names.items()}
