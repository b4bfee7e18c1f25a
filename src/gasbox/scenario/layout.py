"""JSON text that people can read: a line for each species and each listed particle, never for each number."""

from __future__ import annotations

import json
from typing import Any

__all__ = ["layout"]


def layout(data: dict[str, Any]) -> str:
    """`data` as JSON text. Floats are written so that they read back to the same bits."""
    lines = [f"  {json.dumps(key)}: {_value(value)}" for key, value in data.items()]
    return "{\n" + ",\n".join(lines) + "\n}\n"


def _value(value: Any) -> str:
    if isinstance(value, list) and value and all(isinstance(entry, dict) for entry in value):
        return "[\n" + ",\n".join(f"    {_line(entry)}" for entry in value) + "\n  ]"
    return _line(value)


def _line(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)
