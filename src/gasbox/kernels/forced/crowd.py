"""All tables of the discs, and of the molecules that they make up, together."""

from __future__ import annotations

from typing import NamedTuple

from gasbox.kernels.forced.bodies import Bodies
from gasbox.kernels.forced.tables import Atoms, Lists, Room, Slots, Strips

__all__ = ["Crowd"]


class Crowd(NamedTuple):
    """All tables of the discs together; `bodies` is None where each particle is a disc."""

    atoms: Atoms
    slots: Slots
    lists: Lists
    strips: Strips
    room: Room
    bodies: Bodies | None
