"""Every error that gasbox raises on purpose.

GasboxError
├── ScenarioError    a scenario (or snapshot) that cannot be accepted; lists every problem found
├── FileError        a file that cannot be read or written, or is damaged
├── UsageError       options or arguments that make no sense together
└── DynamicsError    an engine that cannot go on

The first three are the user's to mend (exit status 2); the last is ours or the scenario's (exit status 1).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

__all__ = ["DynamicsError", "FileError", "GasboxError", "Problem", "ScenarioError", "UsageError"]


class GasboxError(Exception):
    """Base of all errors that gasbox raises on purpose."""


@dataclass(frozen=True)
class Problem:
    """One thing wrong with a scenario: where, what was found, what is allowed."""

    path: str
    """Path of the field, as in ``species[1].radius``; empty for the file as a whole."""
    found: str
    """What stands there, in short."""
    allowed: str
    """What may stand there."""

    def __str__(self) -> str:
        where = f"{self.path}: " if self.path else ""
        found = f"found {self.found}; " if self.found else ""
        return f"{where}{found}{self.allowed}"


class ScenarioError(GasboxError):
    """A scenario that cannot be accepted, with every problem that was found."""

    def __init__(self, problems: Iterable[Problem], source: str = "scenario") -> None:
        self.problems = tuple(problems)
        self.source = source
        count = len(self.problems)
        head = f"{source}: {count} problem{'s' if count != 1 else ''}"
        super().__init__("\n".join([head, *(f"  {problem}" for problem in self.problems)]))


class FileError(GasboxError):
    """A file that cannot be read or written, or is damaged."""


class UsageError(GasboxError):
    """Options or arguments that make no sense together."""


class DynamicsError(GasboxError):
    """An engine that cannot go on."""
