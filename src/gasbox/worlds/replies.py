"""What a world has made of gravity and of walls: remembered as numbers, so that a run can go on from any frame."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from gasbox.errors import Problem, ScenarioError
from gasbox.state import Memory, MoveWall, SetGate, SetGravity, SetWall, Surrounding, Way

__all__ = ["GATES", "REPLIES", "Replies"]

REPLIES: Final = "replies"
"""Name among what a dynamics remembers."""
GATES: Final = "replies_at_gates"
"""As `REPLIES`, of gates."""
_GRAVITY, _MOVE, _PRESENT, _TEMPERATURE, _FREE = range(5)
_ALL, _NOBODY = -1, -2
"""In place of the index of a species that passes a gate."""


@dataclass
class Replies:
    """The latest of each kind of change, for gravity and for each wall; those before it no longer matter.

    Attributes
    ----------
    latest : (kind, index of the wall) -> time [time], and up to four numbers that say what became of it
    names : of all walls
    gates : index of the wall -> time [time], and who passes it
    """

    latest: dict[tuple[int, int], tuple[float, ...]] = field(default_factory=dict)
    names: Sequence[str] = ()
    gates: dict[int, tuple[float, SetGate]] = field(default_factory=dict)

    def note(self, time: float, change: Surrounding) -> None:
        """Keep in mind what was changed at `time` [time]; of a motion it must be known from where."""
        match change:
            case SetGravity(gravity=(x, y)):
                self._note(_GRAVITY, 0, time, x, y)
            case MoveWall(wall=wall, displacement=displacement, speed=speed, origin=origin):
                self._note(_MOVE, self.names.index(wall), time, displacement, speed, origin or 0.0)
            case SetGate(wall=wall):
                self.gates[self.names.index(wall)] = time, change
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

    def entries(self) -> list[tuple[float, Surrounding]]:
        """(time, change) in the order in which they were made."""
        found = [
            (said[0], self._change(kind, number, *said[1:])) for (kind, number), said in self.latest.items()
        ]
        return sorted([*found, *self.gates.values()], key=lambda entry: entry[0])

    def _change(self, kind: int, number: int, *said: float) -> Surrounding:
        if kind == _GRAVITY:
            return SetGravity((said[0], said[1]))
        wall = self.names[number]
        if kind == _MOVE:
            return MoveWall(wall, said[0], said[1], said[2])
        if kind == _PRESENT:
            return SetWall(wall, present=bool(said[0]))
        return SetWall(wall, temperature=said[0]) if kind == _TEMPERATURE else SetWall(wall, free=True)

    def memory(self) -> Memory:
        """As numbers: ``replies`` (k, 6), padded with zeros, and of gates a row for each species that passes."""
        rows = np.zeros((len(self.latest), 6))
        for row, (key, said) in zip(rows, self.latest.items(), strict=True):
            row[:2] = key
            row[2 : 2 + len(said)] = said
        return {REPLIES: rows, GATES: np.array(list(self._gate_rows()), np.float64).reshape(-1, 6)}

    def _gate_rows(self) -> Iterator[tuple[float, ...]]:
        """Wall, time, whether backward, species, least and greatest speed (-1 for no greatest)."""
        for number, (time, gate) in self.gates.items():
            for backward, way in enumerate((gate.forward, gate.backward)):
                if way is None or way.species == ():
                    yield number, time, backward, _NOBODY, 0.0, 0.0
                    continue
                fastest = -1.0 if math.isinf(way.greatest_speed) else way.greatest_speed
                for species in (_ALL,) if way.species is None else way.species:
                    yield number, time, backward, species, way.least_speed, fastest

    @classmethod
    def recalled(cls, memory: dict[str, Any], names: Sequence[str]) -> Replies:
        """From what `memory` gave, and the names of all walls.

        Raises
        ------
        ScenarioError
            It is not what `memory` gives, for so many walls.
        """
        try:
            return cls._recalled(memory, names)
        except (LookupError, ValueError, OverflowError):
            allowed = "what a world has made of gravity and walls, as a snapshot saves it"
            raise ScenarioError([Problem(f"snapshot.memory.{REPLIES}", "something else", allowed)]) from None

    @classmethod
    def _recalled(cls, memory: dict[str, Any], names: Sequence[str]) -> Replies:
        rows = np.asarray(memory.get(REPLIES, ()), np.float64).reshape(-1, 6)
        latest = {(int(row[0]), int(row[1])): tuple(row[2:].tolist()) for row in rows}
        rows = np.asarray(memory.get(GATES, ()), np.float64).reshape(-1, 6)
        gates = {
            number: (
                float(mine[0, 1]),
                SetGate(names[number], *(_way(mine[mine[:, 2] == way]) for way in (0, 1))),
            )
            for number in dict.fromkeys(rows[:, 0].astype(int).tolist())
            for mine in [rows[rows[:, 0] == number]]
        }
        found = [*latest, *((_GRAVITY, number) for number in gates)]
        if not all(_GRAVITY <= kind <= _FREE and 0 <= number < len(names) for kind, number in found):
            raise IndexError("a wall that is not there")
        return cls(latest, names, gates)


def _way(rows: NDArray[np.float64]) -> Way | None:
    """From the rows of a gate in one direction."""
    species = rows[:, 3].astype(int).tolist()
    if species == [_NOBODY]:
        return None
    least, fastest = rows[0, 4:].tolist()
    return Way(None if species == [_ALL] else tuple(species), least, math.inf if fastest < 0.0 else fastest)
