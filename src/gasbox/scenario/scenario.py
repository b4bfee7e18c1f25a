"""The scenario: all that a gas starts from, validated and frozen."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from functools import cached_property
from typing import Annotated, Any, Final, Literal

from pydantic import Field, ModelWrapValidatorHandler, Strict, ValidationError, model_validator
from pydantic_core import ErrorDetails

from gasbox.errors import Problem, ScenarioError
from gasbox.geometry import Geometry
from gasbox.scenario.baths import Barostat, Heating, Thermostat
from gasbox.scenario.colors import PALETTE
from gasbox.scenario.columns import read_particles
from gasbox.scenario.container import Container
from gasbox.scenario.dynamics import Dynamics, EventDriven
from gasbox.scenario.forces import Forces
from gasbox.scenario.histograms import Histograms
from gasbox.scenario.kinds import Kind, kinds_of, site_kinds_of
from gasbox.scenario.known_keys import KNOWN_KEYS, keys_of
from gasbox.scenario.layout import layout
from gasbox.scenario.molecules import Molecule
from gasbox.scenario.obstacles import Obstacle
from gasbox.scenario.particles import Particles
from gasbox.scenario.parts import Parts
from gasbox.scenario.problems import short, translate
from gasbox.scenario.rules import broken_rules
from gasbox.scenario.schedule import ScheduledChange
from gasbox.scenario.snapshot import Snapshot
from gasbox.scenario.species import Species
from gasbox.scenario.surroundings import geometry_of
from gasbox.scenario.units import Units
from gasbox.scenario.valid_parts import valid_parts
from gasbox.scenario.values import LARGEST_SPECIES, WHOLE, Positive, Section, Vector
from gasbox.scenario.walls import WallSettings
from gasbox.scenario.world import World

__all__ = ["Scenario"]

_MOST_PROBLEMS: Final = 200
"""A file with more problems than this is told the number of the others."""


class Scenario(Section):
    """A gas in a box: what is in it, how it moves, and how it is shown.

    Raises
    ------
    ScenarioError
        With every problem of the data, also those between fields. Nothing else is raised for bad data.
    """

    schema_address: Annotated[str | None, Field(alias="$schema")] = None
    """Address of the JSON Schema, for editors."""
    format: Literal["gasbox-scenario/1"] = "gasbox-scenario/1"
    """Kind and version of the file."""
    title: Annotated[str, Field(max_length=200)] = ""
    """Title, in a few words."""
    watch_for: Annotated[str, Field(max_length=1000)] = ""
    """One sentence on what to watch for."""
    seed: Annotated[int, Strict(), Field(ge=0, lt=2**63), WHOLE] = 0
    """Seed of all random numbers."""
    container: Container
    """The box."""
    walls: dict[str, WallSettings] = Field(default_factory=dict)
    """Properties of sides of the container: left, right, bottom, top of a rectangle; rim; side-1, side-2, ..."""
    obstacles: Annotated[tuple[Obstacle, ...], Field(max_length=10_000)] = ()
    """What stands in the container."""
    gravity: Vector = (0.0, 0.0)
    """Acceleration of all discs [length/time²]."""
    species: Annotated[tuple[Species, ...], Field(max_length=LARGEST_SPECIES)] = ()
    """The kinds of disc."""
    molecules: Annotated[tuple[Molecule, ...], Field(max_length=LARGEST_SPECIES)] = ()
    """The kinds of molecule, made of discs."""
    particles: Particles | None = None
    """Particles listed one by one, in addition to those counted in `species`."""
    dynamics: Dynamics = EventDriven()
    """The rule of motion."""
    forces: Forces | None = None
    """Forces between discs, under dynamics `forced`."""
    thermostat: Thermostat | None = None
    """What holds the temperature, under dynamics `forced`."""
    barostat: Barostat | None = None
    """What holds the pressure, under dynamics `forced` in a periodic box."""
    heating: Heating | None = None
    """Heat that is added, under dynamics `forced`."""
    world: World | None = None
    """Rules on top of the gas: a game, an epidemic, a demon."""
    units: Units | None = None
    """Real units, shown beside the scenario's own."""
    frame_interval: Positive | None = None
    """Simulated time of one frame [time]; without it, chosen from the gas. At 1x, 60 a second."""
    histograms: Histograms = Histograms()
    """How the histograms are drawn."""
    schedule: Annotated[tuple[ScheduledChange, ...], Field(max_length=10_000)] = ()
    """What changes at given times."""
    snapshot: Snapshot | None = None
    """Present in a saved state only; then `particles` is the whole gas and the counts are history."""

    @model_validator(mode="wrap")
    @classmethod
    def _all_problems(cls, data: Any, handler: ModelWrapValidatorHandler[Scenario]) -> Scenario:
        """Validate everything that can be, and raise all problems together."""
        if isinstance(data, Scenario):
            return handler(data)
        if not isinstance(data, dict):
            raise ScenarioError([Problem("", short(data), "a scenario is one JSON object {...}")])
        data, problems = _with_colors(data), []
        particles: Particles | None = None
        wrong_rows: list[Problem] = []
        if data.get("particles") is not None:
            particles, wrong_rows = read_particles(data["particles"])
            data = {**data, "particles": particles}
        scenario, wrong_fields = _validate(data, handler)
        problems += wrong_fields + wrong_rows
        problems += broken_rules(valid_parts(data, particles) if scenario is None else _parts(scenario))
        if problems or scenario is None:
            raise ScenarioError(_bounded(problems))
        return scenario

    def geometry(self) -> Geometry:
        """What the gas moves in, at its start: a plain rectangle, or an enclosure where there is more to it."""
        names = (*(entry.name for entry in self.species), *(entry.name for entry in self.molecules))
        return geometry_of(self.container, self.walls, self.obstacles, self.gravity, names)

    @cached_property
    def kinds(self) -> tuple[Kind, ...]:
        """The kinds of particle: the species in their order, then the molecules."""
        return kinds_of(self.species, self.molecules)

    @cached_property
    def site_kinds(self) -> tuple[Species, ...]:
        """The kinds of disc: the species in their order, then those atoms of molecules that are of none."""
        return site_kinds_of(self.species, self.molecules)

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Scenario:
        """A copy, with some fields replaced; they are not validated again."""
        copied = super().model_copy(update=update, deep=deep)
        for name in ("kinds", "site_kinds"):
            copied.__dict__.pop(name, None)
        return copied

    def to_dict(self) -> dict[str, Any]:
        """The scenario as JSON values; `parse` reads it back to an equal one."""
        large = {"particles", "snapshot"}
        values = self.model_dump(mode="json", by_alias=True, exclude_none=True, exclude=large)
        # These may hold millions of numbers: they go straight from arrays to lists.
        values |= {name: part.to_json() for name in large if (part := getattr(self, name)) is not None}
        unsaid = {
            "walls": {},
            "obstacles": [],
            "gravity": [0.0, 0.0],
            "schedule": [],
            "species": [],
            "molecules": [],
        }
        return {
            key: values[key] for key in keys_of(Scenario) if key in values and values[key] != unsaid.get(key)
        }

    def to_json(self) -> str:
        """The scenario as JSON text; floats read back to the same bits."""
        return layout(self.to_dict())

    def hash(self) -> str:
        """SHA-256, hexadecimal, of what the scenario says, whatever the order of keys and the layout."""
        said = {key: value for key, value in self.to_dict().items() if key != "$schema"}
        text = json.dumps(said, sort_keys=True, separators=(",", ":"))
        return hashlib.sha256(text.encode()).hexdigest()


def _with_colors(data: dict[str, Any]) -> dict[str, Any]:
    """Each species and molecule without a colour gets the one of its place in the palette."""
    first = 0
    for key in ("species", "molecules"):
        entries = data.get(key)
        if not isinstance(entries, list | tuple):
            continue
        colored = [
            {"color": PALETTE[number % len(PALETTE)], **entry} if isinstance(entry, dict) else entry
            for number, entry in enumerate(entries, first)
        ]
        data, first = {**data, key: colored}, len(entries)
    return data


def _validate(
    data: dict[str, Any], handler: ModelWrapValidatorHandler[Scenario]
) -> tuple[Scenario | None, list[Problem]]:
    try:
        return handler(data), []
    except ValidationError as error:
        details = error.errors(include_url=False)
        return None, [translate(detail, _KNOWN) for detail in details if not _follows(detail, details)]


def _follows(detail: ErrorDetails, details: list[ErrorDetails]) -> bool:
    """Whether an error only follows from another one, which says what is really wrong."""
    place = detail["loc"]
    # A list of which no entry is valid counts as empty.
    return detail["type"] == "too_short" and any(
        other["loc"] != place and other["loc"][: len(place)] == place for other in details
    )


def _parts(scenario: Scenario) -> Parts:
    """A scenario that is valid as far as its sections go, as rules between fields see it."""
    return Parts(
        scenario.container,
        scenario.species,
        scenario.particles,
        scenario.dynamics,
        scenario.frame_interval,
        scenario.histograms,
        scenario.snapshot,
        scenario.walls,
        scenario.obstacles,
        scenario.gravity,
        scenario.schedule,
        scenario.forces,
        scenario.thermostat,
        scenario.barostat,
        scenario.heating,
        scenario.molecules,
        scenario.world,
    )


def _bounded(problems: list[Problem]) -> list[Problem]:
    rest = len(problems) - _MOST_PROBLEMS
    return (
        problems if rest <= 0 else [*problems[:_MOST_PROBLEMS], Problem("", "", f"and {rest} more problems")]
    )


_KNOWN: Final = {(): keys_of(Scenario), **KNOWN_KEYS}
