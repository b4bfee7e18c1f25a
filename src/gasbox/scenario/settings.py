"""Changes single fields of a scenario, as ``--set species.0.count=500`` does."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from typing import Any

from gasbox.errors import UsageError
from gasbox.scenario.problems import short
from gasbox.scenario.reading import parse
from gasbox.scenario.scenario import Scenario

__all__ = ["with_settings"]


def with_settings(scenario: Scenario, settings: Mapping[str, str], source: str = "scenario") -> Scenario:
    """`scenario` with fields changed, validated again.

    Parameters
    ----------
    settings : path, as ``species.0.count`` or ``species[0].count`` -> value, JSON if it is, else text

    Raises
    ------
    UsageError
        A path leads nowhere.
    ScenarioError
        With all problems of the changed scenario.
    """
    data = scenario.model_dump(mode="json", by_alias=True, exclude_none=True, exclude={"particles"})
    if scenario.particles is not None:
        edited = any(_steps(path)[0] == "particles" for path in settings)
        data["particles"] = scenario.particles.to_json() if edited else scenario.particles
    kind = settings.get("dynamics.kind")
    if kind is not None and kind != data["dynamics"]["kind"]:
        data["dynamics"] = {}  # another kind has other settings, and starts from its own defaults
    for path, value in settings.items():
        _set(data, path, _read(value))
    return parse(data, source)


def _read(value: str) -> Any:
    try:
        return json.loads(value, parse_constant=str)
    except (ValueError, RecursionError):
        return value


def _steps(path: str) -> list[str]:
    return re.sub(r"\[(\d+)\]", r".\1", path).split(".")


def _set(data: dict[str, Any], path: str, value: Any) -> None:
    place: Any = data
    steps = _steps(path)
    for depth, step in enumerate(steps):
        where = ".".join(steps[:depth]) or "the scenario"
        if isinstance(place, list):
            if not step.isdecimal() or int(step) >= len(place):
                raise UsageError(
                    f"{short(path)}: {where} has the entries 0 to {len(place) - 1}, not {short(step)}"
                )
            key: Any = int(step)
        elif isinstance(place, dict):
            key = step
        else:
            raise UsageError(f"{short(path)}: {where} is a single value and has no {short(step)}")
        if depth == len(steps) - 1:
            place[key] = value
        else:
            place = place[key] if isinstance(place, list) else place.setdefault(key, {})
