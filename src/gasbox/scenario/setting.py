"""What can be set in a world while it runs: the values that a setting may have."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

__all__ = ["Setting"]


@dataclass(frozen=True)
class Setting:
    """One setting: a number in a range, one of a few words, a name, or yes or no.

    Attributes
    ----------
    meaning : in a few words, for the page and for messages
    least, greatest : of a number
    unit : of a number, as [length/time]; empty of a pure one
    words : that it may be; empty of a number
    is_switch : whether it is true or false
    is_name : whether it is the name of a species; the world knows of which
    """

    meaning: str
    least: float = -math.inf
    greatest: float = math.inf
    unit: str = ""
    words: Sequence[str] = ()
    is_switch: bool = False
    is_name: bool = False

    def check(self, value: float | str | bool) -> float | str | bool:
        """The value, if it may be so.

        Raises
        ------
        ValueError
            It may not, with what is allowed.
        """
        if self.is_switch:
            if not isinstance(value, bool):
                raise ValueError("must be true or false")
        elif self.is_name:
            if not isinstance(value, str):
                raise ValueError("must be the name of a species")
        elif self.words:
            if value not in self.words:
                raise ValueError(f"must be one of {', '.join(self.words)}")
        elif isinstance(value, bool | str) or not (
            math.isfinite(value) and self.least <= value <= self.greatest
        ):
            bounded = math.isfinite(self.least) or math.isfinite(self.greatest)
            raise ValueError(
                f"must be a number from {self.least:g} to {self.greatest:g}"
                if bounded
                else "must be a finite number"
            )
        return value
