"""The JSON Schema of a scenario, for editors."""

from __future__ import annotations

from typing import Any

from gasbox.scenario.scenario import Scenario

__all__ = ["schema"]


def schema() -> dict[str, Any]:
    """JSON Schema (draft 2020-12) of a scenario file, with a description for every field."""
    described = Scenario.model_json_schema(by_alias=True)
    described["description"] = "A gas in a box: what is in it, how it moves, and how it is shown."
    described["anyOf"] = [{"required": ["species"]}, {"required": ["molecules"]}]
    address = "https://json-schema.org/draft/2020-12/schema"
    return {"$schema": address, **described, "title": "gasbox scenario"}
