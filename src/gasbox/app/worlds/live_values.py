"""What the settings of a world are just now."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gasbox.app.sample import Sample
from gasbox.state import SetWorld

__all__ = ["LiveValues"]


class LiveValues:
    """Values as they were at the start, unless they were set since then. Reads each change once.

    Parameters
    ----------
    start : name of a setting -> its value in the scenario
    """

    def __init__(self, start: Mapping[str, Any]) -> None:
        self._start = start
        self._version = -1
        self._read = 0
        self._set: dict[str, Any] = {}

    def of(self, name: str, sample: Sample) -> Any:
        """The value of a setting; None if it never had one."""
        if sample.version != self._version or len(sample.changes) < self._read:
            self._version, self._read, self._set = sample.version, 0, {}
        for _, change in sample.changes[self._read :]:
            if isinstance(change, SetWorld):
                self._set[change.name] = change.value
        self._read = len(sample.changes)
        return self._set.get(name, self._start.get(name))
