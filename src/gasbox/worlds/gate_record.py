"""What came to a gate, from which side, and whether it was let pass."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.state import ContactKind, Contacts

__all__ = ["GateRecord"]


class GateRecord:
    """Counts meetings of discs with one wall.

    One that is let pass is counted when its centre crosses the line, one that is refused when it bounces.

    Parameters
    ----------
    wall : index of the gate
    normal : unit vector from the first side to the second

    Attributes
    ----------
    passed, refused : (2,) int64, from the first side, from the second
    decisions : how many of them were decided by a rule that looks at a disc
    let : how many of those were let pass
    """

    def __init__(self, wall: int, normal: tuple[float, float]) -> None:
        self._wall, self._normal = wall, np.array(normal)
        self.passed: NDArray[np.int64] = np.zeros(2, np.int64)
        self.refused: NDArray[np.int64] = np.zeros(2, np.int64)
        self.decisions = self.let = 0

    def read(self, contacts: Contacts, decides: bool) -> None:
        """Count what these contacts tell; `decides`: whether the rule in force looks at discs."""
        kind = contacts.kind[: contacts.count]
        mine = (contacts.second[: contacts.count] == self._wall) & (kind != ContactKind.PAIR)
        if not mine.any():
            return
        along = contacts.impulse[: contacts.count][mine] @ self._normal
        crosses = kind[mine] == ContactKind.CROSSING
        # The momentum of who crosses points where it goes; who bounces is pushed back to where it came from.
        passed = np.bincount(along[crosses] < 0.0, minlength=2)
        refused = np.bincount(along[~crosses] > 0.0, minlength=2)
        self.passed += passed
        self.refused += refused
        if decides:
            self.let += int(passed.sum())
            self.decisions += int(passed.sum() + refused.sum())
