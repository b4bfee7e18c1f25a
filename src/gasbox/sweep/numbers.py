"""The summary of a run as a flat list of numbers, so that many runs can be compared."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Final

__all__ = ["numbers"]

_OF_THE_MACHINE: Final = frozenset(
    {"frames", "wall_seconds", "collisions_per_second", "particle_steps_per_second"}
)
"""What says nothing of the gas."""


def numbers(summary: Mapping[str, Any]) -> dict[str, float]:
    """Path -> number: parts are joined by points, as in ``species.light.temperature`` or ``momentum.0``.

    Yes and no become 1 and 0, what has no value becomes nan, words are left out.
    """
    kept = {name: value for name, value in summary.items() if name not in _OF_THE_MACHINE}
    return dict(_flat("", kept))


def _flat(path: str, value: Any) -> Iterator[tuple[str, float]]:
    if isinstance(value, Mapping):
        for name, entry in value.items():
            yield from _flat(f"{path}.{name}" if path else str(name), entry)
    elif isinstance(value, Sequence) and not isinstance(value, str):
        for number, entry in enumerate(value):
            yield from _flat(f"{path}.{_name(entry, number)}", entry)
    elif value is None:
        yield path, math.nan
    elif isinstance(value, bool | int | float):
        yield path, float(value)


def _name(entry: Any, number: int) -> str:
    """What stands in a path for an entry of a list: its name, if it has one."""
    name = entry.get("name") if isinstance(entry, Mapping) else None
    return name if isinstance(name, str) else str(number)
