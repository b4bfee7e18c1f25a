"""The gas as those see it who look for places: what stands already, what needs a place, and how large it is."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.errors import Problem
from gasbox.geometry import Geometry
from gasbox.geometry.discs import union_area
from gasbox.rng import Stream, generator
from gasbox.scenario.density import Crowd, crowds, density_problems
from gasbox.scenario.kinds import Kind
from gasbox.scenario.lattices import Lattice, lattice_places, lattices
from gasbox.scenario.particles import Particles
from gasbox.scenario.species import Species

__all__ = ["Placement", "placement_problems"]

_CORE: Final = 0.45
"""Of sigma: the radius with which discs are placed that forces keep apart; from closer places they would fly apart."""


@dataclass(frozen=True)
class Placement:
    """Which discs stand where, and which have to share what room.

    Attributes
    ----------
    geometry : the container
    kinds : all kinds of particle
    discs : all kinds of disc, of which these are made
    particles : those that are listed
    soft : whether forces act: then discs may overlap
    seed : of the scenario
    """

    geometry: Geometry
    kinds: tuple[Kind, ...]
    discs: tuple[Species, ...]
    particles: Particles | None
    soft: bool
    seed: int = 0

    @property
    def disc_radii(self) -> NDArray[np.float64]:
        """(discs,) [length], with which discs are placed beside each other; from walls they keep their own radius."""
        if not self.soft:
            return np.array([entry.radius for entry in self.discs])
        sigma = [2 * entry.radius if entry.sigma is None else entry.sigma for entry in self.discs]
        return _CORE * np.array(sigma)

    def sized(self) -> tuple[Kind, ...]:
        """The kinds with these radii."""
        if not self.soft:
            return self.kinds
        radii = self.disc_radii
        return tuple(_with_radii(kind, radii[list(kind.sites)]) for kind in self.kinds)

    def lattices(self) -> tuple[Lattice, ...]:
        """What stands on lattices."""
        return lattices(self.geometry, self.kinds, self.soft)

    def on_lattices(self) -> dict[int, NDArray[np.float64]]:
        """Positions (count, 2) [length] of the discs of each kind that stands on a lattice.

        Which of the species that share one stands where is drawn.
        """
        found: dict[int, NDArray[np.float64]] = {}
        for lattice in self.lattices():
            places = lattice_places(self.geometry, lattice)
            if len(lattice.members) > 1:
                random = generator(self.seed, Stream.POSITIONS, 1 + lattice.members[0])
                places = places[random.permutation(len(places))]
            counts = np.cumsum([self.kinds[member].count for member in lattice.members])
            found |= dict(zip(lattice.members, np.split(places, counts[:-1]), strict=True))
        return found

    def crowds(self) -> tuple[Crowd, ...]:
        """Particles that are placed at random, by the parts of the container that they share."""
        standing = self.on_lattices()
        sized = [
            replace(kind, count=0) if number in standing else kind for number, kind in enumerate(self.sized())
        ]
        return crowds(self.geometry, sized, self._with(standing), self.soft)

    def _with(self, standing: dict[int, NDArray[np.float64]]) -> Particles | None:
        """All discs that have their places: those that are listed, and those on lattices."""
        if not standing:
            return self.particles
        names, position = [], [np.zeros((0, 2))]
        if self.particles is not None:
            names = [self.particles.names[number] for number in self.particles.index.tolist()]
            position.append(self.particles.position)
        for number, places in standing.items():
            names += [self.kinds[number].name] * len(places)
            position.append(places)
        every = np.concatenate(position)
        return Particles.of(names, every, np.zeros_like(every))


def _with_radii(kind: Kind, radii: NDArray[np.float64]) -> Kind:
    reach = float((np.hypot(*kind.place.T) + radii).max())
    return replace(kind, radii=radii, radius=reach, area=union_area(kind.place, radii))


def placement_problems(placement: Placement) -> Iterator[Problem]:
    """Lattices that are too narrow or too small, and parts of the container that are asked to hold too much."""
    wrong = list(_on_lattices(placement))
    yield from wrong
    if not wrong:
        what = "molecules" if any(kind.is_molecule and kind.count for kind in placement.kinds) else "discs"
        if placement.soft:
            what += " of discs 0.9 sigma wide" if what == "molecules" else " 0.9 sigma wide"
        paths = [kind.path for kind in placement.kinds]
        yield from density_problems(placement.geometry, placement.crowds(), paths, what)


def _on_lattices(placement: Placement) -> Iterator[Problem]:
    for lattice in placement.lattices():
        path = f"species[{lattice.members[0]}].lattice"
        if lattice.spacing < lattice.least:
            allowed = (
                f'at least a diameter, {lattice.least:g}: only under dynamics kind "forced" discs may overlap'
            )
            yield Problem(path, f"{lattice.spacing:g}", allowed)
            continue
        most = len(lattice_places(placement.geometry, lattice))
        if most < lattice.count:
            found = f"{lattice.count} discs on a lattice of spacing {lattice.spacing:g}"
            allowed = f"at most {most} have room there; use fewer discs, a smaller spacing or a larger box"
            yield Problem(path, found, allowed)
