"""Reads listed particles, a million in a few seconds, and says which rows are wrong."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import chain, islice
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from gasbox.errors import Problem
from gasbox.scenario.particles import Particles
from gasbox.scenario.problems import short
from gasbox.scenario.values import GREATEST, LARGEST_COUNT

__all__ = ["read_particles"]

_FIELDS: Final = ("species", "position", "velocity", "angle", "angular_velocity")
_ROTATION: Final = _FIELDS[3:]
_SHOWN: Final = 10
"""Of each kind of wrong row, so many are named."""
_VECTOR: Final = f"must be two finite numbers [x, y], each at most {GREATEST:g}"
_NUMBER: Final = f"must be a finite number, at most {GREATEST:g}"
_NAME: Final = "must be the name of a species"

Path = Callable[[int], str]


def read_particles(raw: Any) -> tuple[Particles | None, list[Problem]]:
    """Particles from JSON values (objects or columns), or None with the problems."""
    if isinstance(raw, Particles):
        return raw, []
    if isinstance(raw, dict):
        return _from_columns(raw)
    if isinstance(raw, list | tuple):
        return _from_objects(raw)
    return None, [Problem("particles", short(raw), "must be a list of objects, or an object of columns")]


def _from_objects(raw: Sequence[Any]) -> tuple[Particles | None, list[Problem]]:
    problems = [problem for row, entry in enumerate(raw) if (problem := _object_problem(row, entry))]
    if problems:
        return None, problems[:_SHOWN]
    columns = {
        "species": [entry["species"] for entry in raw],
        "position": [entry["position"] for entry in raw],
        "velocity": [entry.get("velocity", (0.0, 0.0)) for entry in raw],
    }
    for key in _ROTATION:
        if any(key in entry for entry in raw):
            columns[key] = [entry.get(key, 0.0) for entry in raw]
    return _assemble(columns, lambda field: lambda row: f"particles[{row}].{field}", columns_given=False)


def _object_problem(row: int, entry: Any) -> Problem | None:
    if not isinstance(entry, dict):
        return Problem(
            f"particles[{row}]", short(entry), "must be an object with species, position and velocity"
        )
    for key in entry:
        if key not in _FIELDS:
            return Problem(
                f"particles[{row}].{short(key, bare=True)}", "an unknown key", f"known: {', '.join(_FIELDS)}"
            )
    for key in ("species", "position"):
        if key not in entry:
            return Problem(f"particles[{row}].{key}", "nothing", "is required")
    return None


def _from_columns(raw: dict[Any, Any]) -> tuple[Particles | None, list[Problem]]:
    problems = [
        Problem(f"particles.{short(key, bare=True)}", "an unknown key", f"known: {', '.join(_FIELDS)}")
        for key in raw
        if key not in _FIELDS
    ]
    problems += [
        Problem(f"particles.{key}", "nothing", "is required") for key in _FIELDS[:2] if key not in raw
    ]
    columns = {key: raw[key] for key in _FIELDS if key in raw}
    for key, column in columns.items():
        if not isinstance(column, list | tuple | np.ndarray):
            problems.append(
                Problem(f"particles.{key}", short(column), "must be a list, one entry for each particle")
            )
    if problems:
        return None, problems[:_SHOWN]
    columns.setdefault("velocity", np.zeros((len(columns["position"]), 2)))
    lengths = {key: len(column) for key, column in columns.items()}
    if len(set(lengths.values())) > 1:
        found = ", ".join(f"{count} of {key}" for key, count in lengths.items())
        return None, [Problem("particles", found, "all columns must be of one length")]
    return _assemble(columns, lambda field: lambda row: f"particles.{field}[{row}]", columns_given=True)


def _assemble(
    columns: dict[str, Any], paths: Callable[[str], Path], columns_given: bool
) -> tuple[Particles | None, list[Problem]]:
    count = len(columns["species"])
    if count > LARGEST_COUNT:
        return None, [Problem("particles", f"{count} particles", f"at most {LARGEST_COUNT} particles")]
    species = columns["species"]
    problems = _name_problems(species, paths("species"))
    vectors = {}
    for field in ("position", "velocity"):
        vectors[field] = _vectors(columns[field])
        if vectors[field] is None:
            problems += _vector_problems(columns[field], paths(field))
    position, velocity = vectors["position"], vectors["velocity"]
    rotation: dict[str, NDArray[np.float64]] = {}
    for field in _ROTATION:
        if field in columns:
            numbers = _numbers(columns[field])
            if numbers is None:
                problems += _number_problems(columns[field], paths(field))
            else:
                rotation[field] = numbers
    if problems or position is None or velocity is None:
        return None, problems
    return Particles.of(list(species), position, velocity, columns_given, **rotation), []


def _name_problems(names: Sequence[Any], path: Path) -> list[Problem]:
    if set(map(type, names)) <= {str, np.str_}:
        return []
    wrong = ((row, name) for row, name in enumerate(names) if not isinstance(name, str))
    return [Problem(path(row), short(name), _NAME) for row, name in islice(wrong, _SHOWN)]


def _numbers(rows: Any) -> NDArray[np.float64] | None:
    """(n,) float64 if all rows are finite numbers; None otherwise."""
    if not isinstance(rows, np.ndarray) and not set(map(type, rows)) <= {int, float}:
        return None
    try:
        array = np.asarray(rows)
        if array.ndim != 1 or (array.size and array.dtype.kind not in "iuf"):
            return None
        array = array.astype(np.float64)
    except (OverflowError, ValueError, TypeError):
        return None
    return array if (np.abs(array) <= GREATEST).all() else None


def _number_problems(rows: Any, path: Path) -> list[Problem]:
    wrong = ((row, entry) for row, entry in enumerate(rows) if _numbers([entry]) is None)
    return [Problem(path(row), short(entry), _NUMBER) for row, entry in islice(wrong, _SHOWN)]


def _vectors(rows: Any) -> NDArray[np.float64] | None:
    """(n, 2) float64 if all rows are pairs of finite numbers; None otherwise."""
    if isinstance(rows, np.ndarray):
        if rows.dtype.kind not in "iuf" or rows.shape != (len(rows), 2):
            return None
        array = rows.astype(np.float64)
    else:
        if not set(map(type, rows)) <= {list, tuple} or not set(map(len, rows)) <= {2}:
            return None
        if not set(map(type, chain.from_iterable(rows))) <= {int, float}:
            return None
        try:
            array = np.fromiter(chain.from_iterable(rows), np.float64, 2 * len(rows)).reshape(-1, 2)
        except OverflowError:
            return None
    # A NaN compares false, so it is refused as well.
    return array if (np.abs(array) <= GREATEST).all() else None


def _vector_problems(rows: Any, path: Path) -> list[Problem]:
    if isinstance(rows, np.ndarray) and rows.ndim != 2:
        return [Problem(path(0), f"an array of shape {rows.shape}", _VECTOR)]
    wrong = ((row, entry) for row, entry in enumerate(rows) if _vectors([entry]) is None)
    if isinstance(rows, np.ndarray):
        wrong = (
            (row, entry.tolist()) for row, entry in enumerate(rows) if _vectors([entry.tolist()]) is None
        )
    return [Problem(path(row), short(entry), _VECTOR) for row, entry in islice(wrong, _SHOWN)]
