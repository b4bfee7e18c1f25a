"""The kinds of number and text that a scenario holds, with the ranges that the engines can work with."""

from __future__ import annotations

from typing import Annotated, Any, Final

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, Strict

__all__ = [
    "GREATEST",
    "LARGEST_COUNT",
    "LARGEST_SPECIES",
    "LEAST",
    "WHOLE",
    "Finite",
    "NotNegative",
    "Positive",
    "Section",
    "Vector",
]

LEAST: Final = 1e-50
"""Least positive number: products of a few still don't vanish in double precision."""
GREATEST: Final = 1e50
"""Greatest number: products of a few still don't overflow in double precision."""
LARGEST_COUNT: Final = 10_000_000
"""Most particles of a scenario."""
LARGEST_SPECIES: Final = 250
"""Most species of a scenario (their index travels as one byte)."""


def _whole(value: Any) -> Any:
    """5.0 is as good a whole number as 5: JSON has one kind of number only."""
    return int(value) if isinstance(value, float) and value.is_integer() else value


WHOLE: Final = BeforeValidator(_whole)
"""Stands last in the annotation of a whole number, after its range."""

Finite = Annotated[float, Strict(), Field(allow_inf_nan=False, ge=-GREATEST, le=GREATEST)]
Positive = Annotated[float, Strict(), Field(allow_inf_nan=False, ge=LEAST, le=GREATEST)]
NotNegative = Annotated[float, Strict(), Field(allow_inf_nan=False, ge=0, le=GREATEST)]
Vector = tuple[Finite, Finite]


class Section(BaseModel):
    """A part of a scenario: frozen, and with no room for unknown keys."""

    model_config = ConfigDict(frozen=True, extra="forbid", use_attribute_docstrings=True)
