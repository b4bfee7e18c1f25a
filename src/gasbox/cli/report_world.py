"""What came of a world, as a table: numbers as they are, what is made of parts with the names of its parts."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Final

from rich.markup import escape
from rich.table import Table

__all__ = ["world_table"]

_LONGEST: Final = 12
"""Of a longer list only the number of its entries is told; all of it stands in the JSON."""


def world_table(summary: dict[str, Any]) -> Table:
    """A row for each number; `summary` as `protocols.World.summary`."""
    table = Table(title="world", title_justify="left", show_header=False)
    for name, text in _rows(summary):
        table.add_row(escape(name.replace("_", " ")), escape(text))
    return table


def _rows(values: dict[str, Any], before: str = "") -> Iterator[tuple[str, str]]:
    for name, value in values.items():
        if isinstance(value, dict):
            yield from _rows(value, f"{before}{name}: ")
        else:
            yield f"{before}{name}", _text(value)


def _text(value: Any) -> str:
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, list):
        return ", ".join(map(_text, value)) if len(value) <= _LONGEST else f"{len(value)} entries"
    return f"{value:.6g}" if isinstance(value, float) else str(value)
