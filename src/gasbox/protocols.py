"""The roles: what a dynamics and an observer must be able to do."""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntEnum
from typing import Any, Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.state import Contacts, Control, Memory, Reply, SetWalkers, SetWorld, State, Tallies

__all__ = ["Controlled", "Dynamics", "Led", "Observer", "Status", "Warns", "World"]


class Status(IntEnum):
    """How `Dynamics.advance` came to an end."""

    DONE = 0
    """The time asked for is reached."""
    FULL = 1
    """The buffer of contacts is full: read it, clear it, and call again."""


@runtime_checkable
class Dynamics(Protocol):
    """A rule of motion. It owns whatever it needs inside (cells, queues) and keeps public arrays up to date."""

    contacts: Contacts
    """Executed collisions since the last `clear`; a capacity of zero switches them off."""
    tallies: Tallies
    """Sums since the start of the scenario."""

    def advance(self, state: State, until: float) -> Status:
        """Move `state` on to the absolute time `until` [time], or to where the buffer of contacts is full.

        Looking never disturbs: however the way is cut into calls, the bits are the same.

        Raises
        ------
        DynamicsError
            The engine cannot go on.
        """
        ...

    def resync(self, state: State) -> None:
        """Take over `state` after somebody else has changed it."""
        ...

    def alter(self, state: State, geometry: Geometry) -> None:
        """Take over another geometry at the time of the state; walls that move do so from where they are."""
        ...

    def memory(self) -> Memory:
        """What must be kept beside the state to go on with the same bits."""
        ...


@runtime_checkable
class Controlled(Protocol):
    """What a dynamics also has if baths act on its gas as a whole."""

    def control(self, state: State, change: Control) -> None:
        """Set thermostat, barostat or heating to something new, at the time of the state.

        Raises
        ------
        UsageError
            This gas cannot have such a bath.
        """
        ...


@runtime_checkable
class Warns(Protocol):
    """What a dynamics also has if it notices that it could not do as it should."""

    def warnings(self) -> tuple[str, ...]:
        """Sentences on what went wrong in this run so far, and what helps."""
        ...


@runtime_checkable
class Led(Protocol):
    """What a dynamics also has if each of its particles can be told where to go."""

    def lead(self, state: State, change: SetWalkers) -> None:
        """Let some walk otherwise, from the time of the state on."""
        ...


class Observer(Protocol):
    """Reads a run and makes numbers of it; it never changes it."""

    reads_contacts: bool
    """Whether `read` wants to be called; if no observer does, contacts are not written at all."""

    def start(self, state: State, tallies: Tallies) -> None:
        """Called once before the run, with the state at its start."""
        ...

    def read(self, contacts: Contacts) -> None:
        """Called with each filled part of the buffer of contacts, in the order of execution."""
        ...

    def observe(self, state: State, tallies: Tallies) -> None:
        """Called at each frame."""
        ...


class World(Protocol):
    """Rules on top of a gas, as of a game: contacts in, changes out.

    At each whole multiple of `interval` it is shown the contacts since the last one (`read`) and the state (`act`), and
    answers with what becomes of walls and particles. It is called at the same times however the run is looked at, and
    must follow from the scenario, its seed, what it was shown and what was asked of it (`take`): then a run can be
    repeated to the bit.
    """

    interval: float
    """Simulated time from one call of `act` to the next [time]."""
    reads_contacts: bool
    """Whether `read` wants to be called."""

    def start(self, state: State, geometry: Geometry) -> Sequence[Reply]:
        """Called once, at the start of a scenario; not of a run that goes on from a snapshot."""
        ...

    def read(self, contacts: Contacts) -> None:
        """Called with each filled part of the buffer of contacts, in the order of execution."""
        ...

    def act(self, state: State, geometry: Geometry) -> Sequence[Reply]:
        """What follows now. The state is the simulation's own: only what is returned changes it."""
        ...

    def take(self, change: SetWorld) -> None:
        """Give a setting another value.

        Raises
        ------
        UsageError
            There is no such setting, or it cannot have this value.
        """
        ...

    def memory(self) -> Memory:
        """All that must be kept to go on with the same bits: name -> number or array."""
        ...

    def recall(self, memory: Memory) -> None:
        """Go on from what `memory` gave."""
        ...

    def summary(self) -> dict[str, Any]:
        """What it came to so far, as JSON values."""
        ...

    def series(self) -> dict[str, NDArray[np.float64]]:
        """What it has counted over time: name -> (k,), among them ``time`` [time]; empty if it counts nothing."""
        ...

    def view(self) -> dict[str, Any]:
        """What a page shows of it beside the particles, as JSON values; it is sent whenever it differs."""
        ...
