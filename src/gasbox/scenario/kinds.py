"""The kinds of particle of a scenario, discs and molecules alike, with all that follows from their atoms."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.geometry.discs import support, union_area
from gasbox.scenario.molecule_models import model_atoms
from gasbox.scenario.molecules import Atom, Bend, Bond, Molecule
from gasbox.scenario.species import Region, Species

__all__ = ["Kind", "anatomy", "kinds_of", "site_kinds_of", "sound_kinds"]

_AT_CENTRE = 1e-12


@dataclass(frozen=True, eq=False)
class Kind:
    """A kind of particle: a species of discs, or of molecules.

    Attributes
    ----------
    path : where it stands in the scenario, for messages
    name, color, count, temperature, speed, velocities, region, lattice : as the scenario has them
    rotational_temperature, angular_speed : likewise, of molecules
    mass : [mass]
    radius : from the centre of mass to the farthest rim [length]
    half_width : mean over all directions of how far it reaches from its centre of mass [length]; a disc's radius
    area : of all its discs together, where they overlap counted once [length²]
    inertia : moment of inertia about the centre of mass [mass·length²]; 0 of what does not rotate
    sites : index of each of its discs into the kinds of site (`site_kinds_of`)
    radii : (sites,) float64 [length], radius of each
    place : (sites, 2) float64 [length], where these stand, seen from the centre of mass
    bonds, angles : as the scenario has them, lengths and angles at rest filled in
    flexible : whether it is not rigid
    is_molecule : whether the section `molecules` has it
    """

    path: str
    name: str
    color: str
    count: int
    temperature: float | None
    rotational_temperature: float | None
    speed: float | None
    angular_speed: float | None
    velocities: tuple[tuple[float, float], ...] | None
    region: Region | None
    lattice: float | None
    mass: float
    radius: float
    half_width: float
    area: float
    inertia: float
    sites: tuple[int, ...]
    radii: NDArray[np.float64]
    place: NDArray[np.float64]
    bonds: tuple[Bond, ...]
    angles: tuple[Bend, ...]
    flexible: bool
    is_molecule: bool

    def bounds(self, geometry: Geometry) -> tuple[float, float, float, float]:
        """Left, right, lower and upper end [length] of where they are placed."""
        x = self.region.x if self.region else None
        y = self.region.y if self.region else None
        return *(x or (0.0, geometry.width)), *(y or (0.0, geometry.height))


def anatomy(molecule: Molecule) -> tuple[tuple[Atom, ...], tuple[Bond, ...]]:
    """Atoms and bonds of a molecule: its own, or those of its model."""
    if molecule.model is None:
        return molecule.atoms, molecule.bonds
    atoms, bonds = model_atoms(molecule.model, molecule.scale)
    return atoms, molecule.bonds or bonds


def site_kinds_of(species: Sequence[Species], molecules: Sequence[Molecule]) -> tuple[Species, ...]:
    """The kinds of disc: all species, then those atoms of molecules that are of no species."""
    found = list(species)
    for molecule in molecules:
        found += _own_atoms(molecule)
    return tuple(found)


def _own_atoms(molecule: Molecule) -> list[Species]:
    """The atoms of a molecule that are of no species, those that are alike once."""
    own: list[Species] = []
    for number, atom in enumerate(anatomy(molecule)[0]):
        disc = _disc(atom, molecule)
        if atom.species is None and not any(_alike(disc, other) for other in own):
            own.append(disc.model_copy(update={"name": f"{molecule.name}:{number + 1}"[-60:]}))
    return own


def _disc(atom: Atom, molecule: Molecule) -> Species:
    return Species(
        name=molecule.name,
        mass=1.0 if atom.mass is None else atom.mass,
        radius=1.0 if atom.radius is None else atom.radius,
        epsilon=atom.epsilon,
        sigma=atom.sigma,
        charge=atom.charge,
        color=atom.color or molecule.color,
    )


def _alike(one: Species, other: Species) -> bool:
    return one.model_copy(update={"name": other.name}) == other


def kinds_of(species: Sequence[Species], molecules: Sequence[Molecule]) -> tuple[Kind, ...]:
    """All kinds of particle: the species in their order, then the molecules in theirs."""
    names = [entry.name for entry in species]
    found = [_of_species(entry, number) for number, entry in enumerate(species)]
    discs = list(species)
    for number, molecule in enumerate(molecules):
        own = _own_atoms(molecule)
        sites = []
        for atom in anatomy(molecule)[0]:
            if atom.species is not None:
                sites.append(names.index(atom.species))
            else:
                disc = _disc(atom, molecule)
                mine = next(k for k, other in enumerate(own) if _alike(disc, other))
                sites.append(len(discs) + mine)
        discs += own
        found.append(_of_molecule(molecule, number, tuple(sites), discs))
    return tuple(found)


def sound_kinds(species: Sequence[Species | None], molecules: Sequence[Molecule | None]) -> list[Kind]:
    """The kinds of those entries that are valid, and whose atoms are known."""
    valid = [entry for entry in species if entry is not None]
    names = [entry.name for entry in valid]
    sound = [molecule for molecule in molecules if molecule is not None and _is_sound(molecule, names)]
    if len(valid) == len(species) and len(sound) == len(molecules):
        return list(kinds_of(valid, sound))
    found = [_of_species(entry, number) for number, entry in enumerate(species) if entry is not None]
    for number, molecule in enumerate(molecules):
        if molecule in sound:
            assert molecule is not None
            found.append(replace(kinds_of(valid, [molecule])[-1], path=f"molecules[{number}]"))
    return found


def _is_sound(molecule: Molecule, names: Sequence[str]) -> bool:
    if (molecule.model is None) == (not molecule.atoms):
        return False
    atoms, bonds = anatomy(molecule)
    members = [number for bond in bonds for number in bond.atoms]
    members += [number for bend in molecule.angles for number in bend.atoms]
    return max(members, default=0) < len(atoms) and all(atom.species in (None, *names) for atom in atoms)


def _of_species(entry: Species, number: int) -> Kind:
    return Kind(
        path=f"species[{number}]",
        name=entry.name,
        color=entry.color,
        count=entry.count,
        temperature=entry.temperature,
        rotational_temperature=None,
        speed=entry.speed,
        angular_speed=None,
        velocities=entry.velocities,
        region=entry.region,
        lattice=entry.lattice,
        mass=entry.mass,
        radius=entry.radius,
        half_width=entry.radius,
        area=math.pi * entry.radius**2,
        inertia=0.0,
        sites=(number,),
        radii=np.array([entry.radius]),
        place=np.zeros((1, 2)),
        bonds=(),
        angles=(),
        flexible=False,
        is_molecule=False,
    )


def _of_molecule(molecule: Molecule, number: int, sites: tuple[int, ...], discs: Sequence[Species]) -> Kind:
    atoms, bonds = anatomy(molecule)
    place = np.array([atom.position for atom in atoms])
    mass = np.array([discs[site].mass for site in sites])
    radius = np.array([discs[site].radius for site in sites])
    place = place - mass @ place / mass.sum()
    away = np.hypot(*place.T)
    turns = bool(np.any(away > _AT_CENTRE * radius))
    if not turns:
        place = np.zeros_like(place)
    inertia = float(mass @ (away**2 + 0.5 * radius**2)) if molecule.inertia is None else molecule.inertia
    return Kind(
        path=f"molecules[{number}]",
        name=molecule.name,
        color=molecule.color,
        count=molecule.count,
        temperature=molecule.temperature,
        rotational_temperature=molecule.rotational_temperature,
        speed=molecule.speed,
        angular_speed=molecule.angular_speed,
        velocities=None,
        region=molecule.region,
        lattice=None,
        mass=float(mass.sum()),
        radius=float((away + radius).max()),
        half_width=_half_width(place, radius),
        area=union_area(place, radius),
        inertia=inertia if turns else 0.0,
        sites=sites,
        radii=radius,
        place=place,
        bonds=tuple(_at_rest(bond, place) for bond in bonds),
        angles=tuple(_bend_at_rest(bend, place) for bend in molecule.angles),
        flexible=any(bond.stiffness is not None for bond in bonds),
        is_molecule=True,
    )


def _half_width(place: NDArray[np.float64], radius: NDArray[np.float64]) -> float:
    """Perimeter of the convex hull of all discs over 2 pi (Cauchy); of the mean width, half."""
    turn = np.linspace(0.0, 2.0 * math.pi, 720, endpoint=False)
    return float(support(place, radius, turn).mean())


def _at_rest(bond: Bond, place: NDArray[np.float64]) -> Bond:
    if bond.length is not None:
        return bond
    a, b = bond.atoms
    return bond.model_copy(update={"length": float(np.hypot(*(place[a] - place[b])))})


def _bend_at_rest(bend: Bend, place: NDArray[np.float64]) -> Bend:
    if bend.angle is not None:
        return bend
    a, b, c = (place[atom] for atom in bend.atoms)
    one, other = a - b, c - b
    cross, dot = one[0] * other[1] - one[1] * other[0], float(one @ other)
    return bend.model_copy(update={"angle": math.degrees(abs(math.atan2(cross, dot)))})
