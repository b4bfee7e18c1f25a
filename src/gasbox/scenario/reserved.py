"""Words that are kept for what comes: refused as "not available yet", not as unknown."""

from __future__ import annotations

from typing import Any, Final

from gasbox.errors import Problem
from gasbox.scenario.problems import short

__all__ = ["without_reserved"]

KEYS: Final = frozenset({"world"})


def without_reserved(data: dict[str, Any]) -> tuple[dict[str, Any], list[Problem]]:
    """`data` without what is not available yet, and one problem for each such thing."""
    problems = [Problem(key, short(data[key]), f"{key} is not available yet") for key in data if key in KEYS]
    return {key: value for key, value in data.items() if key not in KEYS}, problems
