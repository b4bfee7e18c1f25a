"""Lets a world act on a run: when it is its turn, and what becomes of what it answers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from gasbox.dynamics import Forced, make_room
from gasbox.errors import Problem, ScenarioError, UsageError
from gasbox.initial import separate, worst_overlap
from gasbox.protocols import Led, World
from gasbox.scenario import EventDriven
from gasbox.state import (
    Memory,
    MoveWall,
    RemoveParticles,
    Reply,
    SetGate,
    SetGravity,
    SetParticles,
    SetWalkers,
    SetWall,
)
from gasbox.worlds import Replies

if TYPE_CHECKING:
    from gasbox.simulation.simulation import Simulation

__all__ = ["Guide"]

_PREFIX: Final = "world_"
"""Before the names of what a world remembers."""
_SLACK: Final = 1e-6
"""Of an interval: so near to its end it is over."""


class Guide:
    """A world beside its simulation.

    Parameters
    ----------
    simulation : all but its observers is ready
    world : has not begun yet; it begins here, or goes on from the snapshot
    """

    def __init__(self, simulation: Simulation, world: World) -> None:
        self.world = world
        self._simulation = simulation
        self._replies = Replies({}, simulation.geometry.wall_names)
        if world.reads_contacts:
            simulation.write_contacts()
        self._turn = math.floor(simulation.time / world.interval + _SLACK) + 1
        snapshot = simulation.scenario.snapshot
        remembered = {} if snapshot is None else snapshot.memory
        mine = {
            name.removeprefix(_PREFIX): value
            for name, value in remembered.items()
            if name.startswith(_PREFIX)
        }
        if mine:
            self._replies = Replies.recalled(remembered, simulation.geometry.wall_names)
            _recall(world, mine)
        else:
            self._follow(world.start(simulation.state, simulation.geometry))

    @property
    def next(self) -> float:
        """When it is the world's turn again [time]."""
        return self._turn * self.world.interval

    def act(self) -> None:
        """Let the world act, and do what it says."""
        self._turn += 1
        self._follow(self.world.act(self._simulation.state, self._simulation.geometry))

    def memory(self) -> Memory:
        """What must be kept of the world to go on with the same bits."""
        mine = {f"{_PREFIX}{name}": value for name, value in self.world.memory().items()}
        # There is always something, by which a snapshot tells that the world has begun.
        return {**mine, f"{_PREFIX}turn": self._turn, **self._replies.memory()}

    def _follow(self, replies: Sequence[Reply]) -> None:
        changed, crowded = False, np.zeros(0, np.int64)
        for reply in replies:
            match reply:
                case SetGravity() | SetWall() | MoveWall() | SetGate():
                    change = self._simulation.from_here(reply) if isinstance(reply, MoveWall) else reply
                    self._simulation.surround(change)
                    self._replies.note(self._simulation.time, change)
                case SetParticles():
                    changed |= self._set(reply)
                    if reply.position is not None or reply.species is not None:
                        crowded = np.union1d(crowded, reply.ids)
                case SetWalkers():
                    if not isinstance(self._simulation.dynamics, Led):
                        raise UsageError("the world has told particles where to go that cannot walk")
                    self._simulation.dynamics.lead(self._simulation.state, reply)
                case RemoveParticles(ids=ids):
                    self._simulation.state.keep(~np.isin(self._simulation.state.id, ids))
                    changed = True
        if changed:
            self._take_over(crowded)

    def _set(self, change: SetParticles) -> bool:
        """Write what has changed into the state; whether it was anything."""
        simulation, state = self._simulation, self._simulation.state
        rows = self._rows(change.ids)
        if change.position is not None:
            state.position[rows] = simulation.geometry.wrap(np.asarray(change.position, np.float64))
        if change.velocity is not None:
            state.velocity[rows] = change.velocity
        if change.species is not None:
            kinds = simulation.scenario.kinds
            state.species[rows] = change.species
            state.mass[rows] = np.array([kind.mass for kind in kinds])[change.species]
            state.radius[rows] = np.array([kind.radius for kind in kinds])[change.species]
            self._set_discs(rows, change.species)
        return rows.size > 0

    def _set_discs(self, rows: NDArray[np.int64], species: NDArray[np.int32]) -> None:
        """Where there are molecules, discs that become another species are so for the forces, too."""
        state = self._simulation.state
        if state.sites is None:
            return
        site = state.sites.first[rows]
        if np.any(state.sites.first[rows + 1] - site > 1) or np.any(
            species >= len(self._simulation.scenario.species)
        ):
            raise UsageError("the world has made something else of molecules, or molecules of something else")
        state.sites.species[site] = species
        state.sites.mass[site], state.sites.radius[site] = state.mass[rows], state.radius[rows]

    def _rows(self, ids: NDArray[np.int64]) -> NDArray[np.int64]:
        state = self._simulation.state
        rows = np.searchsorted(state.id, ids)
        if rows.size and (rows.max() >= state.count or not np.array_equal(state.id[rows], ids)):
            raise UsageError("the world has changed particles that are not there")
        return rows

    def _take_over(self, crowded: NDArray[np.int64]) -> None:
        """Let the dynamics go on from the state as it is now, in which those (k,) stand elsewhere or are others.

        Hard discs must not overlap in it, and forces must not be extreme.
        """
        simulation, state = self._simulation, self._simulation.state
        state.turn_sites()
        here = simulation.geometry.at(state.wall_displacement)
        hard = isinstance(simulation.scenario.dynamics, EventDriven)
        if crowded.size and hard and worst_overlap(state, here) is not None:
            separate(state, here)
        simulation.dynamics.resync(state)
        if crowded.size and isinstance(simulation.dynamics, Forced):
            moved = np.isin(state.id, crowded)
            make_room(simulation.dynamics, state, here, moved, simulation.scenario.seed)


def _recall(world: World, memory: Memory) -> None:
    """Let a world go on from what a file says that it remembers.

    Raises
    ------
    ScenarioError
        It makes no sense to this world.
    """
    try:
        world.recall(memory)
    except (LookupError, TypeError, ValueError) as error:
        found = f"what this world can't go on from ({type(error).__name__}: {error})"
        raise ScenarioError(
            [Problem("snapshot.memory", found, "what a world of this kind has saved")]
        ) from None
