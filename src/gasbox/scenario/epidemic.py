"""An epidemic among people who move about."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar, Literal

from pydantic import ConfigDict

from gasbox.scenario.setting import Setting
from gasbox.scenario.values import Section

__all__ = ["Epidemic"]


class Epidemic(Section):
    """An epidemic among people who move about."""

    model_config = ConfigDict(json_schema_extra={"required": ["kind"]})
    SETTINGS: ClassVar[Mapping[str, Setting]] = {}
    """What can be set while it runs, by a schedule or on the page."""

    kind: Literal["epidemic"] = "epidemic"
    """Kind of world."""
