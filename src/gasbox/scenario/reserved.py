"""Words that are kept for what comes: refused as "not available yet", not as unknown."""

from __future__ import annotations

from typing import Any, Final

from gasbox.errors import Problem
from gasbox.scenario.problems import short

__all__ = ["without_reserved"]

KEYS: Final = frozenset(
    {"gravity", "walls", "obstacles", "forces", "thermostat", "molecules", "world", "schedule", "units"}
)
SHAPES: Final = frozenset({"circle", "polygon", "regular-polygon"})
KINDS: Final = frozenset({"forced"})


def without_reserved(data: dict[str, Any]) -> tuple[dict[str, Any], list[Problem]]:
    """`data` without what is not available yet, and one problem for each such thing."""
    problems = [Problem(key, short(data[key]), f"{key} is not available yet") for key in data if key in KEYS]
    rest = {key: value for key, value in data.items() if key not in KEYS}
    for section, key, words in (("container", "shape", SHAPES), ("dynamics", "kind", KINDS)):
        part = rest.get(section)
        word = part.get(key) if isinstance(part, dict) else None
        if isinstance(word, str) and word in words:
            problems.append(Problem(f"{section}.{key}", short(word), f"{word} is not available yet"))
            del rest[section]
    return rest, problems
