"""The roles: what a dynamics and an observer must be able to do."""

from __future__ import annotations

from enum import IntEnum
from typing import Protocol, runtime_checkable

from gasbox.geometry import Geometry
from gasbox.state import Contacts, Control, Memory, State, Tallies

__all__ = ["Controlled", "Dynamics", "Observer", "Status", "Warns"]


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
