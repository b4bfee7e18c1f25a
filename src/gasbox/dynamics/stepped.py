"""The classroom rule, step by step."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.dynamics.halls import make_hall, start_walls, turn_paths, wall_rows
from gasbox.dynamics.mishaps import mishaps_told
from gasbox.dynamics.team import Team, fitting_threads
from gasbox.geometry import Enclosure, Geometry, Rectangle
from gasbox.kernels import arguments, stepped
from gasbox.kernels.hall.motion import show_walls
from gasbox.protocols import Status
from gasbox.state import Contacts, Memory, State, Tallies

__all__ = ["Stepped"]

_ROOM = 1.25
"""Room for a side that moves out, when the cells are laid out again."""


class Stepped:
    """Move all discs by velocity * time_step, then execute the collisions of touching, approaching pairs, then walls.

    Molecules turn, and their discs collide until no pair of them approaches; see the page on the model. The numbers of
    `warnings` belong to this run, as those of a summary do.

    Time exists in whole steps only: `advance` goes to the last step at or before the time asked for.

    Parameters
    ----------
    state : the particles; its arrays are changed in place
    geometry : the box, or the enclosure
    time_step : [time]
    tallies, contacts : where collisions are booked
    memory : ``step`` (and ``walls``), for going on from a snapshot
    threads : how many work together; None takes as many as there are processors if there are many particles.
        It changes no bit.
    seed : of the random numbers of thermal walls
    """

    def __init__(
        self,
        state: State,
        geometry: Geometry,
        time_step: float,
        tallies: Tallies,
        contacts: Contacts,
        memory: Memory | None = None,
        threads: int | None = None,
        seed: int = 0,
    ) -> None:
        self.time_step = time_step
        self.tallies = tallies
        self.contacts = contacts
        self._threads = threads
        self._seed = seed
        self._team: Team | None = None
        self._mishaps = stepped.no_mishaps()
        # What another dynamics, or another time step, has left goes on at the nearest step.
        step = round(state.time / time_step)
        if memory and abs(int(memory["step"]) * time_step - state.time) < 0.5 * time_step:
            step = int(memory["step"])
        self._clock = np.array([step], np.int64)
        state.time = self._time
        self._enter(state, geometry, memory.get("walls") if memory else None)

    def _enter(self, state: State, geometry: Geometry, rows: NDArray[np.float64] | None = None) -> None:
        """Take over a geometry; walls that move go on as remembered in `rows`, or from where the state has them."""
        self._geometry = geometry
        self._hall = make_hall(geometry, self.tallies.pair_collisions.shape[0], self._seed)
        if self._hall is not None:
            start_walls(self._hall, geometry, state, 0.0, rows)
            self._show_walls(state)
        self.resync(state)

    def alter(self, state: State, geometry: Geometry) -> None:
        """Take over another geometry at the time of the state; walls that move do so from where they are."""
        self._enter(state, geometry)

    def resync(self, state: State) -> None:
        """Take over the particles of `state`."""
        self._bodies = stepped.bodies(state, *self._mishaps)
        self._discs = arguments.gas(state) if self._bodies is None else stepped.site_gas(state)
        radius = self._discs.radius
        threads = self._threads or fitting_threads(radius.size)
        if self._team is None or self._team.wanted != threads:
            self._team = Team(threads)
        self._box = self._box_around(state)
        self._grid = stepped.grid(radius, self._box.width, self._box.height)
        self._room = stepped.room(self._grid, self._discs, self._team.threads)
        self._walls = self._fitting_walls(radius)
        state.time = self._time

    def _fitting_walls(self, radius: NDArray[np.float64]) -> stepped.Walls | None:
        if self._hall is None:
            return None
        place, rate = np.zeros((2, len(self._hall.wall)))
        show_walls(self._hall, self._time, place, rate)
        return stepped.walls(self._hall, self._grid, radius, self._box, place)

    def _box_around(self, state: State) -> arguments.Box:
        """The box that the cells divide; where a side has moved out, a larger one with some room to go on."""
        box = arguments.box(self._geometry)
        if not self._moves_out:
            return box
        out = np.maximum(state.wall_displacement[[1, 3]], 0.0) * _ROOM
        return box._replace(width=box.width + float(out[0]), height=box.height + float(out[1]))

    @property
    def _moves_out(self) -> bool:
        """Whether sides of the box can move."""
        geometry = self._geometry
        return (
            geometry.moves and isinstance(geometry, Enclosure) and isinstance(geometry.container, Rectangle)
        )

    def _show_walls(self, state: State) -> None:
        if self._hall is not None and self._geometry.moves:
            if not state.wall_displacement.size:
                state.wall_displacement, state.wall_velocity = np.zeros((2, len(self._hall.wall)))
            show_walls(self._hall, self._time, state.wall_displacement, state.wall_velocity)

    @property
    def _time(self) -> float:
        return float(self._clock[0]) * self.time_step

    def step_at(self, time: float) -> int:
        """The last step at or before `time`, forgiving a billionth of a step."""
        return math.floor(time / self.time_step + 1e-9)

    def advance(self, state: State, until: float) -> Status:
        """Take whole steps up to the last one at or before `until` [time]."""
        target = self.step_at(until)
        status = arguments.DONE
        while True:
            status = self._take_steps(state, min(target, self._turn_walls()))
            if status == stepped.GROW:
                longest = int(self._room.lists.found.max())
                self._room = self._room._replace(
                    lists=stepped.lists(self._room.lists.key.shape[0], 2 * longest)
                )
                continue
            if status == arguments.FULL:
                break
            self._see_off(state)
            if self._clock[0] >= target:
                break
        state.time = self._time
        self._show_walls(state)
        if self._bodies is None:
            state.turn_sites()
        return Status.FULL if status == arguments.FULL else Status.DONE

    def _take_steps(self, state: State, stop: int) -> int:
        """Let the kernel go on to a step, or to where it needs something."""
        assert self._team is not None
        count = np.array([self.contacts.count], np.int64)
        book = arguments.ledger(self.tallies, self.contacts, count, state)
        discs, bodies = arguments.gas(state), self._bodies
        if bodies is not None:
            discs, book = self._discs, book._replace(id=self._discs.id)
        status = self._team.run(
            stepped.advance,
            discs,
            self._box,
            self._grid,
            self._room,
            self._walls,
            bodies,
            book,
            self._clock,
            stop,
            self.time_step,
        )
        self.contacts.count = int(count[0])
        return status

    def _turn_walls(self) -> int:
        """Let walls on a path set out on the piece of the next step; return the last step before a piece ends."""
        if self._hall is None or not isinstance(self._geometry, Enclosure):
            return int(np.iinfo(np.int64).max)
        return turn_paths(self._hall, self._geometry, int(self._clock[0]), self.time_step)

    def _see_off(self, state: State) -> None:
        """Let go of the discs that have left, and lay out the cells anew where a side has moved out of them."""
        if self._walls is None:
            return
        if self._walls.cursor[3]:
            stay = self._walls.gone == 0
            state.keep(stay if self._bodies is None else stay[self._bodies.first[:-1]])
            self._show_walls(state)
            self.resync(state)
        elif self._moves_out:
            self._show_walls(state)
            needed = arguments.box(self._geometry)
            out = np.maximum(state.wall_displacement[[1, 3]], 0.0)
            if needed.width + out[0] > self._box.width or needed.height + out[1] > self._box.height:
                self.resync(state)

    def warnings(self) -> tuple[str, ...]:
        """Sentences on what went wrong with molecules in this run so far."""
        return mishaps_told(*self._mishaps)

    def memory(self) -> Memory:
        """``step``: steps done since time 0; of an enclosure that moves also ``walls``, how each does."""
        memory: Memory = {"step": int(self._clock[0])}
        if self._hall is not None and self._geometry.moves:
            memory["walls"] = wall_rows(self._hall)
        return memory
