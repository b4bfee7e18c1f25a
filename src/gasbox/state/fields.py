"""One table of all particle fields; attributes, files, wire and documentation follow it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from gasbox.units import UNIT

__all__ = ["FIELDS", "ROTATION", "Field"]


@dataclass(frozen=True)
class Field:
    """One particle field: its name, the shape of one particle's value, its type and unit, and what it means."""

    name: str
    shape: tuple[int, ...]
    dtype: str
    unit: str
    meaning: str


FIELDS: Final[tuple[Field, ...]] = (
    Field("id", (), "int64", "", "persistent number of the particle; rows are in the order of id"),
    Field("species", (), "int32", "", "index into the scenario's list of species"),
    Field("mass", (), "float64", UNIT["mass"], "mass"),
    Field("radius", (), "float64", UNIT["radius"], "radius"),
    Field("position", (2,), "float64", UNIT["position"], "centre of the disc; y points up"),
    Field("velocity", (2,), "float64", UNIT["velocity"], "velocity of the centre"),
)
"""All fields of a particle, in the order in which files and tables show them."""

ROTATION: Final[tuple[Field, ...]] = (
    Field("angle", (), "float64", UNIT["angle"], "by which a molecule is turned, counter-clockwise"),
    Field("angular_velocity", (), "float64", UNIT["angular_velocity"], "angular velocity, counter-clockwise"),
)
"""What a particle has beside these where there are molecules."""
