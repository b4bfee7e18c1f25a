"""What the side panel holds while somebody edits the gas: plain texts, until they are applied."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, ClassVar

from gasbox.app.draft_kinds import MoleculeDraft, SpeciesDraft, text_of, value_of
from gasbox.scenario import Forced, Scenario, Stepped, Walk

__all__ = ["ContainerDraft", "Draft"]

_OF_FORCES = ("forces", "thermostat", "barostat", "heating")
"""Sections that only dynamics `forced` knows."""
_COLORS = ("#4c9be8", "#f2a33a", "#5cb85c", "#c86dd7", "#e0605e", "#3fb8af", "#9a8c5a", "#7d8bd8")


@dataclass
class ContainerDraft:
    """The container as typed. What belongs to another shape than the chosen one is kept, but not said.

    Attributes
    ----------
    shape : rectangle, circle, regular-polygon, or polygon, whose vertices only a file can change
    kept : what the panel does not show, as in the file
    """

    shape: str = "rectangle"
    width: str = "100"
    height: str = "100"
    periodic_x: bool = False
    periodic_y: bool = False
    radius: str = "50"
    sides: str = "6"
    kept: dict[str, Any] = field(default_factory=dict)

    SHOWN: ClassVar[dict[str, tuple[str, ...]]] = {
        "rectangle": ("width", "height"),
        "circle": ("radius",),
        "regular-polygon": ("sides", "radius"),
        "polygon": (),
    }
    """Fields of each shape."""

    @classmethod
    def of(cls, scenario: Scenario) -> ContainerDraft:
        """As the scenario has it; sizes of other shapes are such that they would fit the same gas."""
        given, box = scenario.to_dict()["container"], scenario.geometry()
        size = {
            "width": box.width,
            "height": box.height,
            "radius": min(box.width, box.height) / 2,
            "sides": 6,
        }
        said = {key: text_of(given.get(key, value)) for key, value in size.items()}
        axes = given.get("periodic", ())
        kept = {key: value for key, value in given.items() if key not in (*size, "shape", "periodic")}
        return cls(given["shape"], periodic_x="x" in axes, periodic_y="y" in axes, kept=kept, **said)

    def to_dict(self) -> dict[str, Any]:
        """As it goes into a scenario."""
        said = {key: value_of(getattr(self, key)) for key in self.SHOWN[self.shape]}
        if self.shape == "rectangle":
            periodic = [axis for axis, on in (("x", self.periodic_x), ("y", self.periodic_y)) if on]
            return {"shape": self.shape, **said, **({"periodic": periodic} if periodic else {})}
        allowed = {"polygon": ("vertices",), "regular-polygon": ("rotation",)}.get(self.shape, ())
        return {"shape": self.shape, **said, **{key: self.kept[key] for key in allowed if key in self.kept}}


@dataclass
class Draft:
    """The whole gas as typed; `rest` is what the panel does not show."""

    species: list[SpeciesDraft]
    seed: str
    container: ContainerDraft
    gravity_x: str
    gravity_y: str
    kind: str
    time_step: str
    short_step: str
    """Time step under forces."""
    rest: dict[str, Any]
    shape: str = "rectangle"
    """Of the container in the box now."""
    molecules: list[MoleculeDraft] = field(default_factory=list)
    walk: dict[str, Any] = field(default_factory=dict)
    """How people walk, as in the file."""

    @property
    def kinds(self) -> int:
        """How many kinds of particle there are."""
        return len(self.species) + len(self.molecules)

    @property
    def step(self) -> str:
        """The time step of the kind that is chosen."""
        return self.short_step if self.kind == "forced" else self.time_step

    @step.setter
    def step(self, text: str) -> None:
        if self.kind == "forced":
            self.short_step = text
        else:
            self.time_step = text

    @classmethod
    def of(cls, scenario: Scenario) -> Draft:
        """As the scenario has it. Of a snapshot, the start that it came from; its particles are left out."""
        given = scenario.to_dict()
        shown = ("species", "molecules", "seed", "container", "gravity", "dynamics", "snapshot")
        rest = {key: value for key, value in given.items() if key not in shown}
        if scenario.snapshot is not None:
            rest.pop("particles", None)
        dynamics = scenario.dynamics
        return cls(
            [
                SpeciesDraft.of(one, of)
                for one, of in zip(scenario.species, given.get("species", []), strict=True)
            ],
            str(scenario.seed),
            ContainerDraft.of(scenario),
            text_of(scenario.gravity[0]),
            text_of(scenario.gravity[1]),
            dynamics.kind,
            text_of(dynamics.time_step if isinstance(dynamics, Stepped | Walk) else Stepped().time_step),
            text_of(dynamics.time_step if isinstance(dynamics, Forced) else Forced().time_step),
            rest,
            scenario.container.shape,
            [
                MoleculeDraft.of(one, of)
                for one, of in zip(scenario.molecules, given.get("molecules", []), strict=True)
            ],
            given["dynamics"] if isinstance(dynamics, Walk) else {},
        )

    def add_species(self) -> None:
        """One more species, like the last one, with a name and a colour of its own."""
        taken = {one.name for one in self.species} | {one.name for one in self.molecules}
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
        """The scenario as typed, still unchecked. Walls go with their shape, and what acts under forces with these."""
        dynamics: dict[str, Any] = {**(self.walk if self.kind == "walk" else {}), "kind": self.kind}
        if self.kind != "event-driven":
            dynamics["time_step"] = value_of(self.step)
        gravity = [value_of(part) or 0.0 for part in (self.gravity_x, self.gravity_y)]
        rest = {**self.rest, **({"gravity": gravity} if gravity != [0.0, 0.0] else {})}
        if self.container.shape != self.shape:
            rest.pop("walls", None)
        if self.kind != "forced":
            for key in _OF_FORCES:
                rest.pop(key, None)
        return {
            **rest,
            "seed": value_of(self.seed),
            "container": self.container.to_dict(),
            "species": [one.to_dict() for one in self.species],
            **({"molecules": [one.to_dict() for one in self.molecules]} if self.molecules else {}),
            "dynamics": dynamics,
        }
