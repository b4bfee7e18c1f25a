"""Maxwell's demon at a gate."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, ClassVar, Final, Literal, get_args

from pydantic import ConfigDict, Field, Strict

from gasbox.scenario.setting import Setting
from gasbox.scenario.values import GREATEST, LEAST, Positive, Section

__all__ = ["Demon", "DemonRule"]

DemonRule = Literal["speed", "species", "direction", "none", "closed"]
"""By what a demon decides; with none of it, everybody passes, or nobody."""

_SETTINGS: Final[Mapping[str, Setting]] = {
    "rule": Setting("by what it decides", words=get_args(DemonRule)),
    "threshold": Setting("speed that parts fast from slow", LEAST, GREATEST, "[length/time]"),
    "species": Setting("species for the right side", is_name=True),
    "reversed": Setting("left for right", is_switch=True),
}


class Demon(Section):
    """Maxwell's demon at a gate.

    Left and right are the sides of the line of the gate, without its ends; of one that lies, read below and above.
    """

    model_config = ConfigDict(json_schema_extra={"required": ["kind", "gate"]})
    SETTINGS: ClassVar[Mapping[str, Setting]] = _SETTINGS
    """What can be set while it runs, by a schedule or on the page."""

    kind: Literal["demon"] = "demon"
    """Kind of world."""
    gate: Annotated[str, Field(min_length=1, max_length=60)]
    """Name of the segment that is the gate."""
    rule: DemonRule = "speed"
    """Who passes: "speed": fast discs to the right and slow ones to the left; "species": one to the right and all
    others to the left; "direction": all to the right and nobody to the left; "none": everybody; "closed": nobody."""
    threshold: Positive | None = None
    """Faster discs are fast [length/time]; without it, the median of all speeds at the start."""
    species: str | None = None
    """Name of the species for the right side; without it, the first."""
    reversed: Annotated[bool, Strict()] = False
    """Left for right in all rules."""
    interval: Positive = 0.25
    """From one look at the gas to the next [time]; another rule holds from the next look on."""
