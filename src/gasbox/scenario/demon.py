"""Maxwell's demon at a gate."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar, Literal

from pydantic import ConfigDict

from gasbox.scenario.setting import Setting
from gasbox.scenario.values import Section

__all__ = ["Demon"]


class Demon(Section):
    """Maxwell's demon at a gate."""

    model_config = ConfigDict(json_schema_extra={"required": ["kind"]})
    SETTINGS: ClassVar[Mapping[str, Setting]] = {}
    """What can be set while it runs, by a schedule or on the page."""

    kind: Literal["demon"] = "demon"
    """Kind of world."""
