"""What the side panel holds while somebody edits the gas: plain texts, until they are applied."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Any

from gasbox.scenario import Scenario, Species

__all__ = ["Draft", "SpeciesDraft"]

_COLORS = ("#4c9be8", "#f2a33a", "#5cb85c", "#c86dd7", "#e0605e", "#3fb8af", "#9a8c5a", "#7d8bd8")


def _text(value: float) -> str:
    return f"{value:g}" if float(f"{value:g}") == value else repr(value)


def _value(text: str | None) -> Any:
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
    kept : what the panel does not show (region, listed velocities), as in the file
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
            _text(species.mass),
            _text(species.radius),
            str(species.color),
            str(species.count),
            start,
            "" if warmth is None else _text(warmth),
            {key: given[key] for key in ("region", "velocities") if given.get(key) is not None},
        )

    def to_dict(self) -> dict[str, Any]:
        """As it goes into a scenario."""
        shown: dict[str, Any] = {
            "name": self.name.strip(),
            "mass": _value(self.mass),
            "radius": _value(self.radius),
            "color": self.color,
            "count": _value(self.count),
        }
        if self.start != "velocities":
            shown[self.start] = _value(self.warmth)
        kept = {
            key: value
            for key, value in self.kept.items()
            if key != "velocities" or self.start == "velocities"
        }
        return {**{key: value for key, value in shown.items() if value is not None}, **kept}


@dataclass
class Draft:
    """The whole gas as typed; `rest` is what the panel does not show."""

    species: list[SpeciesDraft]
    seed: str
    width: str
    height: str
    periodic_x: bool
    periodic_y: bool
    kind: str
    time_step: str
    rest: dict[str, Any]

    @classmethod
    def of(cls, scenario: Scenario) -> Draft:
        """As the scenario has it. Of a snapshot, the start that it came from; its particles are left out."""
        given = scenario.to_dict()
        rest = {
            key: value
            for key, value in given.items()
            if key not in ("species", "seed", "container", "dynamics", "snapshot")
        }
        if scenario.snapshot is not None:
            rest.pop("particles", None)
        container, dynamics = scenario.container, scenario.dynamics
        return cls(
            [SpeciesDraft.of(one, of) for one, of in zip(scenario.species, given["species"], strict=True)],
            str(scenario.seed),
            _text(container.width),
            _text(container.height),
            "x" in container.periodic,
            "y" in container.periodic,
            dynamics.kind,
            _text(getattr(dynamics, "time_step", 1.0)),
            rest,
        )

    def add_species(self) -> None:
        """One more species, like the last one, with a name and a colour of its own."""
        taken = {one.name for one in self.species}
        name = next(f"gas {i}" for i in range(len(taken) + 1, 2 * len(taken) + 3) if f"gas {i}" not in taken)
        color = next((c for c in _COLORS if c not in {one.color for one in self.species}), _COLORS[0])
        last = (
            self.species[-1]
            if self.species
            else SpeciesDraft("", "1", "1", color, "100", "temperature", "0.02")
        )
        start = "temperature" if last.start == "velocities" else last.start
        self.species.append(
            SpeciesDraft(name, last.mass, last.radius, color, "100", start, last.warmth or "0.02")
        )

    def to_dict(self) -> dict[str, Any]:
        """The scenario as typed, still unchecked."""
        periodic = [axis for axis, on in (("x", self.periodic_x), ("y", self.periodic_y)) if on]
        dynamics: dict[str, Any] = {"kind": self.kind}
        if self.kind == "stepped":
            dynamics["time_step"] = _value(self.time_step)
        return {
            **self.rest,
            "seed": _value(self.seed),
            "container": {
                "shape": "rectangle",
                "width": _value(self.width),
                "height": _value(self.height),
                **({"periodic": periodic} if periodic else {}),
            },
            "species": [one.to_dict() for one in self.species],
            "dynamics": dynamics,
        }
