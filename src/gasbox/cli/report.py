"""What a run came to, for people as a table and for programs as JSON."""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Iterable, Iterator
from typing import Any, Final

from rich.console import Console
from rich.markup import escape
from rich.table import Table

from gasbox.cli.report_world import world_table
from gasbox.units import UNIT

__all__ = ["finite", "meaning", "print_json", "print_summary", "warn"]

_ROWS = (
    ("time", "time", UNIT["time"]),
    ("frames", "frames", ""),
    ("particles", "particles", ""),
    ("collisions", "collisions of pairs", ""),
    ("wall_collisions", "collisions with walls", ""),
    ("energy", "kinetic energy", UNIT["energy"]),
    ("potential_energy", "potential energy", UNIT["energy"]),
    ("internal_energy", "internal energy", UNIT["energy"]),
    ("rest_energy", "given by the rule for rest", UNIT["energy"]),
    ("momentum", "momentum", UNIT["momentum"]),
    ("temperature", "temperature", UNIT["temperature"]),
    ("temperature_translational", "temperature of flight", UNIT["temperature"]),
    ("temperature_rotational", "temperature of rotation", UNIT["temperature"]),
    ("temperature_vibrational", "temperature of vibration", UNIT["temperature"]),
    ("pressure", "pressure on the walls", UNIT["pressure"]),
    ("pressure_virial", "pressure by the virial", UNIT["pressure"]),
    ("mean_free_path", "mean free path", UNIT["position"]),
    ("wall_seconds", "duration of the loop", "s"),
    ("collisions_per_second", "collisions a second", ""),
    ("particle_steps_per_second", "particle steps a second", ""),
)
_SPECIES = (
    ("count", "particles"),
    ("temperature", "temperature"),
    ("mean_speed", "mean speed"),
    ("rms_speed", "rms speed"),
    ("center_of_mass", "centre of mass"),
)


_SIDES: Final = frozenset({"left", "right", "bottom", "top"})
_UNLESS_ZERO: Final = frozenset({"potential_energy", "internal_energy", "rest_energy"})
"""Rows that say nothing in a plain box."""
_UNLESS_NONE: Final = frozenset({"temperature_rotational", "temperature_vibrational"})
"""Rows of molecules, which may be stiff, or of one atom."""
_OF_MOLECULES: Final = (
    ("temperature_rotational", "of rotation"),
    ("temperature_vibrational", "of vibration"),
)
"""Columns of which those are shown in which something stands."""


def meaning(name: str) -> tuple[str, str]:
    """How a number of a summary is called in tables and pictures, and its unit."""
    known = {row[0]: row[1:] for row in _ROWS}
    return known.get(name, (name.replace("_", " ").replace(".", " "), ""))


def warn(warnings: Iterable[str]) -> None:
    """Print warnings on standard error."""
    for warning in warnings:
        print(f"Warning: {warning}", file=sys.stderr)


def print_json(summary: dict[str, Any]) -> None:
    """Print one JSON object; what is no finite number becomes null, as JSON has no other."""
    print(json.dumps(finite(summary), allow_nan=False, indent=2, ensure_ascii=False))


def print_summary(summary: dict[str, Any], title: str) -> None:
    """Print a table of the whole gas and one of its species."""
    console = Console(highlight=False)
    table = Table(title=escape(title) or None, title_justify="left", show_header=False)
    for name, meaning, unit in _ROWS:
        if name in _UNLESS_NONE and summary.get(name) is None:
            continue
        if name in summary and (name not in _UNLESS_ZERO or _has_more_energy(summary)):
            table.add_row(meaning, _text(summary[name]), unit)
    console.print(table)
    shown = [
        column
        for column in _OF_MOLECULES
        if any(entry.get(column[0]) is not None for entry in summary["species"])
    ]
    columns = [*_SPECIES[:2], *shown, *_SPECIES[2:]]
    species = Table("species", *(meaning for _, meaning in columns))
    for entry in summary["species"]:
        species.add_row(escape(entry["name"]), *(_text(entry[name]) for name, _ in columns))
    console.print(species)
    if _is_more_than_a_box(summary):
        console.print(_walls(summary["walls"], [entry["name"] for entry in summary["species"]]))
    if "world" in summary:
        console.print(world_table(summary["world"]))


def _is_more_than_a_box(summary: dict[str, Any]) -> bool:
    """Whether the walls have something to tell beside one pressure."""
    walls = summary["walls"]
    told = any(wall["work"] or wall["heat"] or any(_ways(wall)) for wall in walls)
    return bool(told or summary["potential_energy"] or {wall["name"] for wall in walls} - _SIDES)


def _walls(walls: list[dict[str, Any]], species: list[str]) -> Table:
    """A row for each wall, with only those columns in which something stands."""
    passed = any(any(_ways(wall)) for wall in walls)
    kept = [name for name in ("work", "heat", "carried") if any(wall[name] for wall in walls)]
    table = Table("wall", "pressure", "hits", *kept, *(["passed (forward, backward)"] if passed else []))
    for wall in walls:
        pressure, error = wall["pressure"], wall["pressure_error"]
        felt = _text(pressure) if error is None else f"{_text(pressure)} ± {error:.2g}"
        row = [escape(wall["name"]), felt, _text(wall["collisions"]), *(_text(wall[name]) for name in kept)]
        ways = [
            f"{escape(name)} {wall['passed'][name]['forward']}, {wall['passed'][name]['backward']}"
            for name in species
            if any(wall["passed"][name].values())
        ]
        table.add_row(*row, *(["; ".join(ways) or "-"] if passed else []))
    return table


def _ways(wall: dict[str, Any]) -> Iterator[int]:
    """All counts of those that passed a wall."""
    for ways in wall["passed"].values():
        yield from ways.values()


def _has_more_energy(summary: dict[str, Any]) -> bool:
    return bool(summary["potential_energy"] or summary["rest_energy"])


def _text(value: Any) -> str:
    if value is None:
        return "-"
    if isinstance(value, list):
        return f"({', '.join(map(_text, value))})"
    return f"{value:.6g}" if isinstance(value, float) else f"{value}"


def finite(value: Any) -> Any:
    """The same with null for what is no finite number."""
    if isinstance(value, dict):
        return {key: finite(entry) for key, entry in value.items()}
    if isinstance(value, list):
        return [finite(entry) for entry in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
