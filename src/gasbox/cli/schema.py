"""`gasbox schema`: the JSON Schema of scenarios."""

from __future__ import annotations

import json

__all__ = ["schema"]


def schema() -> None:
    """Print the JSON Schema of scenarios, for editors and other programs."""
    from gasbox.scenario import schema as scenario_schema

    print(json.dumps(scenario_schema(), indent=2, ensure_ascii=False))
