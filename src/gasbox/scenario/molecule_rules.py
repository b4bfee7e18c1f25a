"""Rules on molecules: whether their atoms are known, hold together, and have an answer in the rule of motion."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from gasbox.errors import Problem
from gasbox.scenario.dynamics import Forced
from gasbox.scenario.kinds import anatomy
from gasbox.scenario.molecules import Atom, Bond, Molecule
from gasbox.scenario.parts import Parts
from gasbox.scenario.problems import near, short
from gasbox.scenario.species import Species
from gasbox.scenario.values import LARGEST_SPECIES

__all__ = ["molecule_problems"]

_OF_DISCS: Final = ("mass", "radius", "epsilon", "sigma", "charge")
_OF_ROTATION: Final = ("rotational_temperature", "angular_speed", "inertia")
_ROWS: Final = 10
"""Of wrong rows, so many are named."""


def molecule_problems(parts: Parts) -> Iterator[Problem]:
    """All that is wrong with molecules, by themselves and with the rest of the scenario."""
    if not parts.species and not parts.molecules:
        yield Problem("species", "nothing", "is required, unless there are molecules")
    yield from _names(parts)
    for number, molecule in enumerate(parts.molecules):
        if molecule is not None:
            yield from _molecule(f"molecules[{number}]", molecule, parts)
    yield from _turned_discs(parts)
    yield from _gates(parts)
    total = len(parts.species) + sum(len(entry.atoms) or 5 for entry in parts.molecules if entry is not None)
    if total > LARGEST_SPECIES:
        yield Problem("molecules", f"{total} kinds of disc in all", f"at most {LARGEST_SPECIES}")


def _gates(parts: Parts) -> Iterator[Problem]:
    """Walls that let hard molecules pass one way or at some speeds: one that is half through may have to turn back."""
    if isinstance(parts.dynamics, Forced):
        return
    large = {entry.name for entry in parts.molecules if entry is not None and len(anatomy(entry)[0]) > 1}
    for number, obstacle in enumerate(parts.obstacles):
        passes = None if obstacle is None else obstacle.passes
        if passes is None or not large.intersection(passes.species or large):
            continue
        if (
            passes.each_way
            or passes.direction != "both"
            or passes.least_speed > 0.0
            or passes.greatest_speed is not None
        ):
            allowed = (
                "molecules pass a wall both ways and at any speed, or not at all: name in species who passes"
            )
            yield Problem(f"obstacles[{number}].passes", "a gate for molecules", allowed)


def _names(parts: Parts) -> Iterator[Problem]:
    """A name that a species or another molecule has already."""
    first = {entry.name: f"species[{n}]" for n, entry in enumerate(parts.species) if entry is not None}
    for number, molecule in enumerate(parts.molecules):
        if molecule is None:
            continue
        if molecule.name in first:
            allowed = f"each molecule needs its own name; {first[molecule.name]} has it already"
            yield Problem(f"molecules[{number}].name", short(molecule.name), allowed)
        first.setdefault(molecule.name, f"molecules[{number}]")


def _molecule(path: str, molecule: Molecule, parts: Parts) -> Iterator[Problem]:
    if molecule.model is None and not molecule.atoms:
        yield Problem(f"{path}.atoms", "nothing", "is required: give atoms, or a model")
        return
    if molecule.model is not None and molecule.atoms:
        yield Problem(f"{path}.atoms", "atoms beside a model", "give either atoms or a model")
        return
    if molecule.model is None and molecule.scale != 1.0:
        yield Problem(f"{path}.scale", f"{molecule.scale:g}", "goes with a model only")
    atoms, bonds = anatomy(molecule)
    for number, atom in enumerate(atoms):
        yield from _atom(f"{path}.atoms[{number}]", atom, parts.species)
    turns = len({atom.position for atom in atoms}) > 1
    yield from _motion(path, molecule, turns)
    yield from _bonds(path, molecule, len(atoms), bonds, parts)
    charged = parts.forces is not None and parts.forces.charges is not None
    for number, atom in enumerate(molecule.atoms):
        if isinstance(parts.dynamics, Forced) and atom.charge and not charged:
            allowed = "a charge acts only where a section forces.charges says how"
            yield Problem(f"{path}.atoms[{number}].charge", f"{atom.charge:g}", allowed)


def _atom(path: str, atom: Atom, species: tuple[Species | None, ...]) -> Iterator[Problem]:
    if atom.species is None:
        return
    known = [entry.name for entry in species if entry is not None]
    if atom.species not in known and all(species):
        names = ", ".join(map(short, dict.fromkeys(known))) or "none is there"
        yield Problem(
            f"{path}.species", short(atom.species), f"must be a species: {names}{near(atom.species, known)}"
        )
    for key in _OF_DISCS:
        if getattr(atom, key) is not None:
            yield Problem(f"{path}.{key}", f"{getattr(atom, key):g}", "the species says it already")


def _motion(path: str, molecule: Molecule, turns: bool) -> Iterator[Problem]:
    given = [key for key in ("temperature", "speed") if getattr(molecule, key) is not None]
    if len(given) > 1:
        yield Problem(path, " and ".join(given), "only one of temperature, speed")
    elif not given and molecule.count > 0:
        allowed = f"{molecule.count} molecules need velocities: give one of temperature, speed"
        yield Problem(path, "none of them", allowed)
    for key in _OF_ROTATION:
        if getattr(molecule, key) is not None and not turns:
            allowed = "goes with molecules of more than one atom, which rotate"
            yield Problem(f"{path}.{key}", f"{getattr(molecule, key):g}", allowed)
    if molecule.rotational_temperature is not None and molecule.angular_speed is not None:
        allowed = "only one of rotational_temperature, angular_speed"
        yield Problem(path, "rotational_temperature and angular_speed", allowed)


def _bonds(
    path: str, molecule: Molecule, atoms: int, bonds: tuple[Bond, ...], parts: Parts
) -> Iterator[Problem]:
    sections: list[tuple[str, tuple[int, ...]]] = [
        (f"{path}.bonds[{n}].atoms", bond.atoms) for n, bond in enumerate(bonds)
    ]
    sections += [(f"{path}.angles[{n}].atoms", bend.atoms) for n, bend in enumerate(molecule.angles)]
    wrong, first = False, dict[tuple[int, ...], str]()
    for place, members in sections:
        if max(members) >= atoms or len(set(members)) < len(members):
            wrong = True
            yield Problem(place, short(list(members)), f"must be different atoms, from 0 to {atoms - 1}")
            continue
        one = (min(members), *members[1:-1], max(members))
        if one in first:
            yield Problem(place, short(list(members)), f"each only once; {first[one]} has it already")
        first.setdefault(one, place)
    elastic = [bond.stiffness is not None for bond in bonds]
    if wrong or not any(elastic):
        if molecule.angles and not wrong:
            yield Problem(f"{path}.angles", "angles of a rigid molecule", "give the bonds a stiffness, too")
        return
    if not all(elastic):
        number = elastic.index(False)
        allowed = "is required: either all bonds are elastic, or the molecule is rigid"
        yield Problem(f"{path}.bonds[{number}].stiffness", "nothing", allowed)
    yield from _at_one_place(path, molecule, bonds)
    if not _connected(atoms, bonds):
        yield Problem(
            f"{path}.bonds", "atoms that no bond holds", "bonds must connect all atoms of the molecule"
        )
    if molecule.inertia is not None:
        yield Problem(
            f"{path}.inertia", f"{molecule.inertia:g}", "of a flexible molecule it follows from the atoms"
        )
    if parts.dynamics is not None and not isinstance(parts.dynamics, Forced):
        found = f"dynamics of kind {short(parts.dynamics.kind)}"
        yield Problem(f"{path}.bonds", found, 'elastic bonds need dynamics kind "forced"')


def _at_one_place(path: str, molecule: Molecule, bonds: tuple[Bond, ...]) -> Iterator[Problem]:
    """Atoms between which there is no direction in which a bond could pull."""
    places = [atom.position for atom in anatomy(molecule)[0]]
    for number, bond in enumerate(bonds):
        if len({places[atom] for atom in bond.atoms}) < 2:
            allowed = "atoms that a bond holds apart stand at different places"
            yield Problem(f"{path}.bonds[{number}].atoms", short(list(bond.atoms)), allowed)
    for number, bend in enumerate(molecule.angles):
        one, middle, other = (places[atom] for atom in bend.atoms)
        if middle in (one, other):
            allowed = "an angle is between atoms at different places"
            yield Problem(f"{path}.angles[{number}].atoms", short(list(bend.atoms)), allowed)


def _turned_discs(parts: Parts) -> Iterator[Problem]:
    """Listed particles that are no molecules and yet turned."""
    listed = parts.particles
    if listed is None or parts.names is None:
        return
    turning = {kind.name for kind in parts.kinds() if kind.inertia > 0.0}
    still = np.array([name not in turning for name in listed.names], np.bool_)[listed.index]
    for key, values in zip(("angle", "angular_velocity"), listed.rotation(), strict=True):
        for row in np.flatnonzero(still & (values != 0.0))[:_ROWS].tolist():
            allowed = "goes with molecules of more than one atom, which rotate"
            yield Problem(listed.path(row, key), f"{values[row]:g}", allowed)


def _connected(atoms: int, bonds: tuple[Bond, ...]) -> bool:
    """Whether bonds lead from each atom to each other."""
    reached = {0}
    for _ in range(atoms):
        for bond in bonds:
            if reached & set(bond.atoms):
                reached |= set(bond.atoms)
    return len(reached) == atoms
