"""Keeps the points of a sweep in a file, so that it can be interrupted and continued."""

from __future__ import annotations

import dataclasses
import json
import math
import os
from pathlib import Path
from typing import Any, Final

from gasbox.errors import FileError, UsageError
from gasbox.sweep.grid import Recipe
from gasbox.sweep.point import Point
from gasbox.sweep.verdict import MATTERS

__all__ = ["Diary"]

_FORMAT: Final = "gasbox-phase-diagram/1"


class Diary:
    """The points found so far. The file is replaced as a whole each time, so it is never half written.

    Parameters
    ----------
    path : JSON file; read if it is there
    recipe : how points are run

    Raises
    ------
    FileError
        The file cannot be read, or is something else.
    UsageError
        Its points were run in another way.
    """

    def __init__(self, path: Path, recipe: Recipe) -> None:
        self.path = path
        self.recipe = recipe
        self._points: dict[tuple[float, float], Point] = {}
        if path.exists():
            kept, points = _read(path)
            if kept != recipe:
                raise UsageError(
                    f"{path} holds points of another kind ({_difference(kept, recipe)}); choose another file"
                )
            self._points = {(one.temperature, one.density): one for one in points}
        elif not path.parent.is_dir():
            raise FileError(f"cannot write {path}: there is no folder {path.parent}")

    @property
    def points(self) -> list[Point]:
        """All points, by temperature and density."""
        return [self._points[key] for key in sorted(self._points)]

    def missing(self, wanted: list[tuple[float, float]]) -> list[tuple[float, float]]:
        """Those of the points (temperature, density) that are still to be done."""
        return [point for point in wanted if point not in self._points]

    def add(self, point: Point) -> None:
        """Keep one more point.

        Raises
        ------
        FileError
            The file cannot be written.
        """
        self._points[point.temperature, point.density] = point
        rows = [dataclasses.asdict(one) for one in self.points]
        kept = {"format": _FORMAT, "recipe": dataclasses.asdict(self.recipe), "points": rows}
        beside = self.path.with_name(f"{self.path.name}.part")
        try:
            beside.write_text(json.dumps(kept, indent=1) + "\n", "utf-8")
            os.replace(beside, self.path)
        except OSError as error:
            raise FileError(f"cannot write {self.path}: {error.strerror or error}") from None


def _read(path: Path) -> tuple[Recipe, list[Point]]:
    try:
        kept = json.loads(path.read_text("utf-8"))
    except OSError as error:
        raise FileError(f"cannot read {path}: {error.strerror or error}") from None
    except ValueError:
        raise FileError(f"{path} is not a phase diagram of gasbox: it is no JSON") from None
    if not isinstance(kept, dict) or kept.get("format") != _FORMAT:
        raise FileError(f'{path} is not a phase diagram of gasbox: its format is not "{_FORMAT}"')
    try:
        return Recipe(**kept["recipe"]), [_point(row) for row in kept["points"]]
    except (KeyError, TypeError, ValueError):
        raise FileError(f"{path} is damaged: it does not hold what a phase diagram holds") from None


def _point(row: dict[str, Any]) -> Point:
    point = Point(**row)
    numbers = [value for value in dataclasses.asdict(point).values() if not isinstance(value, str)]
    if point.matter not in MATTERS or not all(map(math.isfinite, numbers)):
        raise ValueError
    return point


def _difference(one: Recipe, other: Recipe) -> str:
    names = [field.name for field in dataclasses.fields(Recipe)]
    return ", ".join(
        f"{name} {getattr(one, name):g}, not {getattr(other, name):g}"
        for name in names
        if getattr(one, name) != getattr(other, name)
    )
