"""Observers that read contacts: one keeps every collision, one counts them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.observe.collisions import CollisionRates, collision_rates
from gasbox.state import ContactKind, Contacts, State, Tallies

__all__ = ["ContactCounter", "ContactLog"]


class ContactLog:
    """Keeps the first `limit` contacts of a run, in the order of execution.

    Attributes
    ----------
    left_out : number of contacts beyond the limit
    """

    reads_contacts = True

    def __init__(self, limit: int = 1_000_000) -> None:
        self._limit = limit
        self._parts: list[Contacts] = []
        self._kept = 0
        self.left_out = 0

    def start(self, state: State, tallies: Tallies) -> None:
        """Forget all contacts."""
        self._parts, self._kept, self.left_out = [], 0, 0

    def read(self, contacts: Contacts) -> None:
        """Keep a copy of these rows, as far as there is room."""
        rows = min(contacts.count, self._limit - self._kept)
        self.left_out += contacts.count - rows
        if rows > 0:
            self._parts.append(_copy(contacts, rows))
            self._kept += rows

    def observe(self, state: State, tallies: Tallies) -> None:
        """Not needed."""

    def contacts(self) -> Contacts:
        """All that was kept, as one table."""
        parts = self._parts or [Contacts.empty(0)]
        return Contacts(
            self._kept,
            np.concatenate([part.kind for part in parts]),
            np.concatenate([part.time for part in parts]),
            np.concatenate([part.first for part in parts]),
            np.concatenate([part.second for part in parts]),
            np.concatenate([part.impulse for part in parts]),
        )


class ContactCounter:
    """Counts contacts by pair of species, by wall, and by particle.

    Parameters
    ----------
    species, walls : how many of each there are

    Attributes
    ----------
    per_particle : (n,) int64, pair collisions of each particle, in the order of id
    """

    reads_contacts = True

    def __init__(self, species: int, walls: int) -> None:
        self._sums = Tallies.zero(species, walls)
        self._id: NDArray[np.int64] = np.zeros(0, np.int64)
        self._species: NDArray[np.int32] = np.zeros(0, np.int32)
        self._begin = self._end = 0.0
        self.per_particle: NDArray[np.int64] = np.zeros(0, np.int64)

    def start(self, state: State, tallies: Tallies) -> None:
        """Forget all counts and learn which particle is of which species."""
        walls, species = self._sums.wall_collisions.shape
        self._sums = Tallies.zero(species, walls)
        self._id, self._species = state.id.copy(), state.species.copy()
        self._begin = self._end = state.time
        self.per_particle = np.zeros(state.count, np.int64)

    def read(self, contacts: Contacts) -> None:
        """Count these rows."""
        kind, first, second = (
            column[: contacts.count] for column in (contacts.kind, contacts.first, contacts.second)
        )
        pair, wall = kind == ContactKind.PAIR, kind == ContactKind.WALL
        one, other = self._rows(first[pair]), self._rows(second[pair])
        np.add.at(self.per_particle, one, 1)
        np.add.at(self.per_particle, other, 1)
        low = np.minimum(self._species[one], self._species[other])
        high = np.maximum(self._species[one], self._species[other])
        np.add.at(self._sums.pair_collisions, (low, high), 1)
        np.add.at(self._sums.wall_collisions, (second[wall], self._species[self._rows(first[wall])]), 1)

    def observe(self, state: State, tallies: Tallies) -> None:
        """Note how far time has come."""
        self._end = state.time

    def rates(self) -> CollisionRates | None:
        """Collisions per time from the start to the last frame; None before the second."""
        return collision_rates(self._sums, self._end - self._begin)

    def _rows(self, ids: NDArray[np.int64]) -> NDArray[np.int64]:
        """Rows of the state in which these ids stand; it is sorted by id."""
        return np.searchsorted(self._id, ids)


def _copy(contacts: Contacts, rows: int) -> Contacts:
    return Contacts(
        rows,
        contacts.kind[:rows].copy(),
        contacts.time[:rows].copy(),
        contacts.first[:rows].copy(),
        contacts.second[:rows].copy(),
        contacts.impulse[:rows].copy(),
    )
