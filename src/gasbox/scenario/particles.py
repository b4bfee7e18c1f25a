"""Particles that a scenario lists one by one: as objects, or for many, as columns."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, core_schema

__all__ = ["Particles"]

_FEW: Final = 100
"""Up to here particles are written as objects, which people read; above as columns."""

_VECTOR: Final = {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2}


@dataclass(frozen=True, eq=False)
class Particles:
    """Listed particles, as arrays.

    Attributes
    ----------
    names : names of species, each once
    index : (n,) int32, which of `names` each particle is
    position : (n, 2) float64 [length]
    velocity : (n, 2) float64 [length/time]
    angle, angular_velocity : (n,) float64 [rad], [rad/time], of molecules; None where nobody says any
    columns : whether they were given as columns, for the paths in messages
    """

    names: tuple[str, ...]
    index: NDArray[np.int32]
    position: NDArray[np.float64]
    velocity: NDArray[np.float64]
    columns: bool = True
    angle: NDArray[np.float64] | None = None
    angular_velocity: NDArray[np.float64] | None = None

    @classmethod
    def of(
        cls,
        species: Sequence[str],
        position: NDArray[np.float64],
        velocity: NDArray[np.float64],
        columns: bool = True,
        angle: NDArray[np.float64] | None = None,
        angular_velocity: NDArray[np.float64] | None = None,
    ) -> Particles:
        """Particles from names of species and arrays (n, 2): position [length], velocity [length/time].

        Of molecules also angle (n,) [rad] and angular velocity (n,) [rad/time]."""
        table = {name: number for number, name in enumerate(dict.fromkeys(species))}
        index = np.fromiter(map(table.__getitem__, species), np.int32, len(species))
        turned = None if angle is None else np.array(angle)
        turning = None if angular_velocity is None else np.array(angular_velocity)
        return cls(tuple(table), index, np.array(position), np.array(velocity), columns, turned, turning)

    def __post_init__(self) -> None:
        for array in (self.index, self.position, self.velocity, self.angle, self.angular_velocity):
            if array is not None:
                array.setflags(write=False)

    def rotation(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Angle (n,) [rad] and angular velocity (n,) [rad/time], zero where nothing is said."""
        zero = np.zeros(self.count)
        return (
            zero if self.angle is None else self.angle.copy(),
            zero.copy() if self.angular_velocity is None else self.angular_velocity.copy(),
        )

    @property
    def count(self) -> int:
        """Number of listed particles."""
        return int(self.index.shape[0])

    def path(self, row: int, field: str) -> str:
        """Path of one entry, in the form in which it was given."""
        return f"particles.{field}[{row}]" if self.columns else f"particles[{row}].{field}"

    def arrays(
        self, species_names: Sequence[str]
    ) -> tuple[NDArray[np.int32], NDArray[np.float64], NDArray[np.float64]]:
        """Index into `species_names` (n,), position (n, 2) [length], velocity (n, 2) [length/time].

        Raises
        ------
        KeyError
            A name that is not among `species_names`; a validated scenario has none.
        """
        table = {name: number for number, name in enumerate(species_names)}
        numbers = np.array([table[name] for name in self.names], dtype=np.int32)
        species = numbers[self.index] if self.count else np.zeros(0, np.int32)
        return species, self.position.copy(), self.velocity.copy()

    def to_json(self) -> list[dict[str, Any]] | dict[str, list[Any]]:
        """As JSON values: few as objects, many as columns."""
        species = [self.names[number] for number in self.index.tolist()]
        columns = {"species": species, "position": self.position.tolist(), "velocity": self.velocity.tolist()}
        for name in ("angle", "angular_velocity"):
            if getattr(self, name) is not None:
                columns[name] = getattr(self, name).tolist()
        if self.count > _FEW:
            return columns
        return [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, Particles)
            and np.array_equal(self.position, other.position)
            and np.array_equal(self.velocity, other.velocity)
            and all(map(np.array_equal, self.rotation(), other.rotation()))
            and [self.names[i] for i in self.index] == [other.names[i] for i in other.index]
        )

    __hash__ = None  # type: ignore[assignment]

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Only instances: a million particles never pass through pydantic one by one."""
        return core_schema.is_instance_schema(
            cls, serialization=core_schema.plain_serializer_function_ser_schema(cls.to_json)
        )

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> JsonSchemaValue:
        properties = {
            "species": {"type": "string", "description": "Name of a species."},
            "position": {**_VECTOR, "description": "Centre [x, y], inside the container [length]."},
            "velocity": {**_VECTOR, "description": "Velocity [vx, vy]; without it, at rest [length/time]."},
            "angle": {"type": "number", "description": "By which a molecule is turned [rad]."},
            "angular_velocity": {"type": "number", "description": "Of a molecule [rad/time]."},
        }
        columns = {name: {"type": "array", "items": entry} for name, entry in properties.items()}
        shape = {"type": "object", "required": ["species", "position"], "additionalProperties": False}
        return {
            "description": "Particles listed one by one, as objects or as columns.",
            "anyOf": [
                {"type": "array", "items": {**shape, "properties": properties}},
                {**shape, "properties": columns},
            ],
        }
