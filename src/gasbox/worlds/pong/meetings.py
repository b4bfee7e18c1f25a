"""What the ball has met since the last turn, read from the contacts."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from gasbox.state import ContactKind, Contacts

__all__ = ["Meetings"]


@dataclass
class Meetings:
    """Whom and what the ball has met, in order.

    Attributes
    ----------
    ball : its id
    rows : (k, 2) int64, a `ContactKind`, and the id of the other particle or the index of the wall
    """

    ball: int = -1
    rows: NDArray[np.int64] = field(default_factory=lambda: np.zeros((0, 2), np.int64))

    def read(self, contacts: Contacts) -> None:
        """Keep those of the ball."""
        count = contacts.count
        kind, first, second = contacts.kind[:count], contacts.first[:count], contacts.second[:count]
        pair = kind == ContactKind.PAIR
        mine = np.flatnonzero((first == self.ball) | (pair & (second == self.ball)))
        if mine.size:
            other = np.where(pair[mine] & (second[mine] == self.ball), first[mine], second[mine])
            found = np.stack([kind[mine].astype(np.int64), other], axis=1)
            self.rows = np.concatenate([self.rows, found])

    def take(self) -> list[tuple[int, int]]:
        """All of them; they are forgotten."""
        rows, self.rows = self.rows, self.rows[:0]
        return [(int(kind), int(other)) for kind, other in rows]
