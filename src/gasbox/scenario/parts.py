"""The parts of a scenario as rules between fields see them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from gasbox.scenario.baths import Barostat, Heating, Thermostat
from gasbox.scenario.container import Container
from gasbox.scenario.dynamics import EventDriven, Forced, Stepped, Walk
from gasbox.scenario.forces import Forces
from gasbox.scenario.histograms import Histograms
from gasbox.scenario.kinds import Kind, anatomy, sound_kinds
from gasbox.scenario.molecules import Molecule
from gasbox.scenario.obstacles import Obstacle
from gasbox.scenario.particles import Particles
from gasbox.scenario.schedule import ScheduledChange
from gasbox.scenario.snapshot import Snapshot
from gasbox.scenario.species import Species
from gasbox.scenario.values import Section
from gasbox.scenario.walls import WallSettings
from gasbox.scenario.world import World

__all__ = ["Parts"]


@dataclass(frozen=True)
class Parts:
    """The parts of a scenario, None where a part is absent or invalid by itself."""

    container: Container | None
    species: tuple[Species | None, ...]
    particles: Particles | None
    dynamics: Stepped | EventDriven | Forced | Walk | None
    frame_interval: float | None
    histograms: Histograms | None
    snapshot: Snapshot | None
    walls: Mapping[str, WallSettings | None] = field(default_factory=dict)
    obstacles: tuple[Obstacle | None, ...] = ()
    gravity: tuple[float, float] | None = (0.0, 0.0)
    schedule: tuple[ScheduledChange | None, ...] = ()
    forces: Forces | None = None
    thermostat: Thermostat | None = None
    barostat: Barostat | None = None
    heating: Heating | None = None
    molecules: tuple[Molecule | None, ...] = ()
    world: World | None = None

    @property
    def names(self) -> tuple[str, ...] | None:
        """Names of the species and of the molecules; None if any is invalid."""
        every = (*self.species, *self.molecules)
        names = tuple(entry.name for entry in every if entry is not None)
        return names if len(names) == len(every) else None

    def kinds(self) -> list[Kind]:
        """The kinds of particle, as far as they are valid and their atoms are known."""
        return sound_kinds(self.species, self.molecules)

    def discs(self) -> dict[str, int]:
        """Number of discs in each kind of particle, by name."""
        found = {f"species[{n}]" if one is None else one.name: 1 for n, one in enumerate(self.species)}
        for number, molecule in enumerate(self.molecules):
            if molecule is None:
                found[f"molecules[{number}]"] = 1
            else:
                found[molecule.name] = len(anatomy(molecule)[0])
        return found

    @property
    def are_valid(self) -> bool:
        """Whether all that the surroundings of the gas are made of is valid by itself."""
        rest: tuple[Section | None, ...] = (
            *self.walls.values(),
            *self.obstacles,
            *self.schedule,
            *self.species,
            *self.molecules,
        )
        return self.container is not None and self.gravity is not None and None not in rest
