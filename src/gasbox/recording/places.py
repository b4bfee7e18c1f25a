"""Where things stand in a recording: the H5MD groups, and gasbox's own beside them.

Source: P. de Buyl, P. H. Colberg and F. Höfling, H5MD: a structured, efficient, and portable file format for
molecular data, Comput. Phys. Commun. 185 (2014) 1546, doi:10.1016/j.cpc.2014.01.018; format version 1.1.
"""

from __future__ import annotations

from typing import Final

__all__ = [
    "ATOMS",
    "ATOM_FIELDS",
    "BONDS",
    "CHANGES",
    "CHANGES_MADE",
    "EDGES",
    "EVERY_FRAME",
    "FORCES",
    "FORCE_FIELDS",
    "FORMAT",
    "H5MD_VERSION",
    "LENGTHS",
    "MEMORY",
    "NO_PARTICLE",
    "OBSERVABLES",
    "OWN",
    "PARTICLES",
    "ROSTER",
    "TALLIES",
    "TURNED",
    "WALLS",
    "WALL_FIELDS",
]

FORMAT: Final = "gasbox-recording/1"
"""Kind and version of the file, an attribute of `OWN`."""
H5MD_VERSION: Final = (1, 1)

PARTICLES: Final = "particles/all"
EDGES: Final = f"{PARTICLES}/box/edges"
"""Size of the box, once for all; an element with a row for each frame where a barostat may change it."""
OBSERVABLES: Final = "observables"
OWN: Final = "parameters/gasbox"
TALLIES: Final = f"{OWN}/tallies"
MEMORY: Final = f"{OWN}/memory"
"""What the dynamics remembers, each frame: what makes the frame resumable to the bit."""
LENGTHS: Final = f"{OWN}/memory_lengths"
"""How many entries of a remembered array are valid in each frame; those behind are padding."""

WALL_FIELDS: Final = {"displacement": "wall_displacement", "velocity": "wall_velocity"}
"""Elements of `WALLS` -> fields of the state."""

FORCES: Final = f"{OWN}/forces"
"""What forces between discs give the state, each frame; 0 where there are none."""
FORCE_FIELDS: Final = ("potential", "virial")
"""Elements of `FORCES` and fields of the state."""

EVERY_FRAME: Final = ("position", "velocity")
"""Particle fields with a row for each frame."""
TURNED: Final = ("angle", "angular_velocity")
"""The same where there are molecules."""
ROSTER: Final = ("id", "species", "mass", "radius")
"""Particle fields with a new row only when one of them changes; a row holds until the next."""

ATOMS: Final = "particles/atoms"
"""The discs of a gas with flexible molecules; those of rigid ones follow from angle and scenario."""
ATOM_FIELDS: Final = ("species", "mass", "radius")
"""Of a disc, with a new row only when one of them changes."""
BONDS: Final = "connectivity/bonds"
"""Rows of the atoms that are bonded."""

CHANGES: Final = f"{OWN}/changes"
"""One JSON text for each change of gravity or of a wall while the gas ran, as entries of a scenario's schedule."""
CHANGES_MADE: Final = f"{OWN}/changes_made"
"""How many of them were made until each frame."""
WALLS: Final = f"{OWN}/walls"
"""Where walls are, each frame: displacement and velocity of each wall; not-a-number while none has moved yet."""

NO_PARTICLE: Final = -1
"""Fill value of `id`: this place is empty, since fewer particles were there than at another time."""
