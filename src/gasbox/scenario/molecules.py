"""A kind of molecule: discs that hold together, and how many of it the gas starts with."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, Strict

from gasbox.scenario.colors import PALETTE
from gasbox.scenario.species import Region
from gasbox.scenario.values import LARGEST_COUNT, WHOLE, Finite, NotNegative, Positive, Section, Vector

__all__ = ["MOST_ATOMS", "Atom", "Bend", "Bond", "Molecule"]

MOST_ATOMS = 100
"""Most atoms of a molecule."""

Number = Annotated[int, Strict(), Field(ge=0, lt=MOST_ATOMS), WHOLE]


class Atom(Section):
    """A disc of a molecule: of a species, or with properties of its own."""

    position: Vector
    """Centre in the molecule's own frame, the origin of which may lie anywhere [length]."""
    species: str | None = None
    """Name of a species whose disc this is; without it, what follows says what it is."""
    mass: Positive | None = None
    """Mass; without it, 1 [mass]."""
    radius: Positive | None = None
    """Radius; without it, 1 [length]."""
    epsilon: NotNegative | None = None
    """Strength of the force between two of them; without it, 1 [energy]."""
    sigma: Positive | None = None
    """Range of the force between two of them; without it, the diameter [length]."""
    charge: Finite | None = None
    """Charge; without it, 0."""
    color: Annotated[str | None, Field(pattern=r"^#[0-9a-fA-F]{6}$")] = None
    """Colour as `#rrggbb`; without it, that of the molecule."""


class Bond(Section):
    """What holds two atoms together: drawn as a stick, and elastic if it has a stiffness."""

    atoms: tuple[Number, Number]
    """Which two of the atoms, counted from 0."""
    stiffness: Positive | None = None
    """k of the energy k (r - length)²/2; without it, the molecule is rigid [energy/length²]."""
    length: Positive | None = None
    """Length at rest; without it, the distance at which the atoms stand [length]."""


class Bend(Section):
    """What holds the angle between two bonds."""

    atoms: tuple[Number, Number, Number]
    """Which three of the atoms, counted from 0; the angle is at the second."""
    stiffness: Positive
    """k of the energy k (angle - rest)²/2 [energy/rad²]."""
    angle: Annotated[float | None, Strict(), Field(gt=0, le=180)] = None
    """Angle at rest; without it, the one at which the atoms stand [degrees]."""


class Molecule(Section):
    """A kind of molecule: rigid, or flexible where its bonds have a stiffness."""

    name: Annotated[str, Field(min_length=1, max_length=60)]
    """Name, as in charts and tables; no species and no other molecule has it."""
    model: Literal["hydrogen", "nitrogen", "oxygen", "water", "carbon-dioxide", "methane"] | None = None
    """Take the atoms of this molecule, drawn flat; lengths are in ångström, masses in atomic mass units."""
    scale: Positive = 1.0
    """Factor on the lengths of a `model`."""
    atoms: Annotated[tuple[Atom, ...], Field(max_length=MOST_ATOMS)] = ()
    """Its discs, which may overlap each other."""
    bonds: Annotated[tuple[Bond, ...], Field(max_length=10 * MOST_ATOMS)] = ()
    """Its bonds: all elastic, or none."""
    angles: Annotated[tuple[Bend, ...], Field(max_length=10 * MOST_ATOMS)] = ()
    """Its elastic angles."""
    inertia: Positive | None = None
    """Moment of inertia about the centre of mass; without it, that of uniform discs [mass·length²]."""
    color: Annotated[str, Field(pattern=r"^#[0-9a-fA-F]{6}$")] = PALETTE[0]
    """Colour as `#rrggbb`, of its charts, and of atoms without their own; without it, the next one of a palette."""
    count: Annotated[int, Strict(), Field(ge=0, le=LARGEST_COUNT), WHOLE] = 0
    """How many are placed at the start, turned at random, without overlap."""
    temperature: NotNegative | None = None
    """Start with velocities of the Maxwell distribution at this temperature [mass·length²/time², k_B = 1]."""
    rotational_temperature: NotNegative | None = None
    """Start with normal angular velocities of this temperature; without it, that of the flight [likewise]."""
    speed: NotNegative | None = None
    """Start with this one speed and random directions [length/time]."""
    angular_speed: NotNegative | None = None
    """Start with this one angular speed, either way round [rad/time]."""
    region: Region | None = None
    """Where they are placed; without it, in the whole container."""
