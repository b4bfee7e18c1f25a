"""What makes a saved gas go on with the same bits."""

from __future__ import annotations

from typing import Any

import numpy as np
from pydantic import field_validator, model_serializer

from gasbox.scenario.schedule import ScheduledChange
from gasbox.scenario.values import Finite, Section

__all__ = ["Snapshot"]


class Snapshot(Section):
    """The section that turns a scenario into a saved state; then `particles` is the whole gas."""

    version: str
    """Version of the program that wrote it."""
    time: Finite
    """Simulated time [time]."""
    memory: dict[str, Any]
    """What the dynamics remembers beside the particles: numbers and arrays."""
    tallies: dict[str, Any]
    """Sums over all collisions since the start of the scenario: lists of numbers."""
    ids: tuple[int, ...] | None = None
    """Numbers of the particles, in ascending order; without them 0, 1, 2, ..."""
    changes: tuple[ScheduledChange, ...] = ()
    """What was changed so far: by the schedule, or by hand."""

    @field_validator("memory")
    @classmethod
    def _arrays(cls, value: dict[str, Any]) -> dict[str, Any]:
        return {name: _array(name, entry) for name, entry in value.items()}

    @field_validator("tallies")
    @classmethod
    def _lists(cls, value: dict[str, Any]) -> dict[str, Any]:
        return {name: np.asarray(_array(name, entry)).tolist() for name, entry in value.items()}

    def to_json(self) -> dict[str, Any]:
        """As JSON values."""
        memory = {
            name: entry.tolist() if hasattr(entry, "tolist") else entry for name, entry in self.memory.items()
        }
        said: dict[str, Any] = {"version": self.version, "time": self.time, "memory": memory}
        said["tallies"] = self.tallies
        if self.ids is not None:
            said["ids"] = list(self.ids)
        if self.changes:
            said["changes"] = [change.model_dump(mode="json", exclude_none=True) for change in self.changes]
        return said

    @model_serializer
    def _serialise(self) -> dict[str, Any]:
        return self.to_json()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Snapshot) and self.to_json() == other.to_json()

    __hash__ = None  # type: ignore[assignment]


def _array(name: str, entry: Any) -> Any:
    """A finite number as it is, nested lists of finite numbers as an array; ValueError for anything else."""
    try:
        array = np.asarray(entry)
    except (ValueError, OverflowError, RecursionError):
        raise ValueError(f"{name!r} must be a number or a regular list of numbers") from None
    if array.dtype.kind not in "iuf" or not np.isfinite(array).all():
        # An empty list is an empty array of floats, so it passes.
        raise ValueError(f"{name!r} must hold finite numbers only")
    return entry if array.ndim == 0 else array
