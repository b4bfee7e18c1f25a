"""What a world has made of gravity and of walls: remembered as numbers, so that a run can go on from any frame."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np

from gasbox.state import Memory, MoveWall, SetGravity, SetWall

__all__ = ["REPLIES", "Replies"]

REPLIES: Final = "replies"
"""Name among what a dynamics remembers."""
_GRAVITY, _MOVE, _PRESENT, _TEMPERATURE, _FREE = range(5)
_OfSurroundings = SetGravity | SetWall | MoveWall


@dataclass
class Replies:
    """The latest of each kind of change, for gravity and for each wall; those before it no longer matter.

    Attributes
    ----------
    latest : (kind, index of the wall) -> time [time], and up to four numbers that say what became of it
    """

    latest: dict[tuple[int, int], tuple[float, ...]] = field(default_factory=dict)
    names: Sequence[str] = ()

    def note(self, time: float, change: _OfSurroundings) -> None:
        """Keep in mind what was changed at `time` [time]; of a motion it must be known from where."""
        match change:
            case SetGravity(gravity=(x, y)):
                self._note(_GRAVITY, 0, time, x, y)
            case MoveWall(wall=wall, displacement=displacement, speed=speed, origin=origin):
                self._note(_MOVE, self.names.index(wall), time, displacement, speed, origin or 0.0)
            case SetWall(wall=wall, present=present, temperature=temperature, free=free):
                number = self.names.index(wall)
                if present is not None:
                    self._note(_PRESENT, number, time, float(present))
                if temperature is not None:
                    self._note(_TEMPERATURE, number, time, temperature)
                if free:
                    self._note(_FREE, number, time)

    def _note(self, kind: int, number: int, time: float, *numbers: float) -> None:
        # The order in which they came is kept: the latest goes last.
        self.latest.pop((kind, number), None)
        self.latest[kind, number] = (time, *numbers)

    def entries(self) -> list[tuple[float, _OfSurroundings]]:
        """(time, change) in the order in which they were made."""
        return [
            (said[0], self._change(kind, number, *said[1:])) for (kind, number), said in self.latest.items()
        ]

    def _change(self, kind: int, number: int, *said: float) -> _OfSurroundings:
        if kind == _GRAVITY:
            return SetGravity((said[0], said[1]))
        wall = self.names[number]
        if kind == _MOVE:
            return MoveWall(wall, said[0], said[1], said[2])
        if kind == _PRESENT:
            return SetWall(wall, present=bool(said[0]))
        return SetWall(wall, temperature=said[0]) if kind == _TEMPERATURE else SetWall(wall, free=True)

    def memory(self) -> Memory:
        """As numbers: ``replies`` (k, 6), padded with zeros."""
        rows = np.zeros((len(self.latest), 6))
        for row, (key, said) in zip(rows, self.latest.items(), strict=True):
            row[:2] = key
            row[2 : 2 + len(said)] = said
        return {REPLIES: rows}

    @classmethod
    def recalled(cls, memory: dict[str, Any], names: Sequence[str]) -> Replies:
        """From what `memory` gave, and the names of all walls."""
        rows = np.asarray(memory.get(REPLIES, ()), np.float64).reshape(-1, 6)
        latest = {(int(row[0]), int(row[1])): tuple(row[2:].tolist()) for row in rows}
        return cls(latest, names)
