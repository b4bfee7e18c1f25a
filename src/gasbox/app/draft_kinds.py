"""What the side panel holds of the kinds of particle while somebody edits them: plain texts."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Any

from gasbox.scenario import Molecule, Species

__all__ = ["MoleculeDraft", "SpeciesDraft", "text_of", "value_of"]

_HIDDEN = ("region", "velocities", "lattice", "epsilon", "sigma", "charge")
"""What the panel does not show of a species."""
_SHOWN = ("name", "color", "count", "temperature", "speed", "rotational_temperature")
"""What it shows of a molecule."""


def text_of(value: float) -> str:
    """A number as it is shown, with all its digits."""
    return f"{value:g}" if float(f"{value:g}") == value else repr(value)


def value_of(text: str | None) -> Any:
    """What was typed as JSON where it is a number, else as it stands, so that the check can say what it found."""
    stripped = (text or "").strip().replace("\u2212", "-")
    if not stripped:
        return None
    try:
        value = json.loads(stripped)
    except ValueError:
        return stripped
    return value if isinstance(value, int | float) and not isinstance(value, bool) else stripped


@dataclass
class SpeciesDraft:
    """One species as typed.

    Attributes
    ----------
    start : how velocities are drawn: ``temperature``, ``speed``, or ``velocities`` (as listed in the file)
    kept : what the panel does not show (region, listed velocities, forces), as in the file
    """

    name: str
    mass: str
    radius: str
    color: str
    count: str
    start: str = "temperature"
    warmth: str = ""
    kept: dict[str, Any] = field(default_factory=dict)

    @classmethod
    def of(cls, species: Species, given: dict[str, Any]) -> SpeciesDraft:
        """As the scenario has it; `given` is the same species as in the file."""
        start = (
            "velocities"
            if species.velocities is not None
            else "speed"
            if species.speed is not None
            else "temperature"
        )
        warmth = species.speed if start == "speed" else species.temperature
        return cls(
            species.name,
            text_of(species.mass),
            text_of(species.radius),
            str(species.color),
            str(species.count),
            start,
            "" if warmth is None else text_of(warmth),
            {key: given[key] for key in _HIDDEN if given.get(key) is not None},
        )

    def to_dict(self) -> dict[str, Any]:
        """As it goes into a scenario."""
        shown: dict[str, Any] = {
            "name": self.name.strip(),
            "mass": value_of(self.mass),
            "radius": value_of(self.radius),
            "color": self.color,
            "count": value_of(self.count),
        }
        if self.start != "velocities":
            shown[self.start] = value_of(self.warmth)
        kept = {
            key: value
            for key, value in self.kept.items()
            if key != "velocities" or self.start == "velocities"
        }
        return {**{key: value for key, value in shown.items() if value is not None}, **kept}


@dataclass
class MoleculeDraft:
    """One kind of molecule as typed.

    Attributes
    ----------
    start : how velocities are drawn: ``temperature`` or ``speed``
    turning : temperature of the rotation at the start; nothing for that of the flight
    kept : what the panel does not show (atoms, bonds and the rest), as in the file
    """

    name: str
    color: str
    count: str
    start: str = "temperature"
    warmth: str = ""
    turning: str = ""
    kept: dict[str, Any] = field(default_factory=dict)

    @classmethod
    def of(cls, molecule: Molecule, given: dict[str, Any]) -> MoleculeDraft:
        """As the scenario has it; `given` is the same molecule as in the file."""
        start = "temperature" if molecule.speed is None else "speed"
        warmth = molecule.temperature if molecule.speed is None else molecule.speed
        turning = molecule.rotational_temperature
        return cls(
            molecule.name,
            str(molecule.color),
            str(molecule.count),
            start,
            "" if warmth is None else text_of(warmth),
            "" if turning is None else text_of(turning),
            {key: value for key, value in given.items() if key not in _SHOWN},
        )

    def to_dict(self) -> dict[str, Any]:
        """As it goes into a scenario."""
        shown = {
            "name": self.name.strip(),
            "color": self.color,
            "count": value_of(self.count),
            self.start: value_of(self.warmth),
            "rotational_temperature": value_of(self.turning),
        }
        return {**{key: value for key, value in shown.items() if value is not None}, **self.kept}
