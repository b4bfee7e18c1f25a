"""Kernels of the forced rule: discs that attract and repel each other, by velocity Verlet."""

from gasbox.kernels.forced.advance import (
    FORCE_FIRST,
    LEFT,
    LIST_FIRST,
    LISTED,
    TOO_FAR,
    WALL_TOO_FAR,
    advance,
)
from gasbox.kernels.forced.bath import Bath
from gasbox.kernels.forced.bodies import Bodies, Inner, bodies
from gasbox.kernels.forced.crowd import Crowd
from gasbox.kernels.forced.lists_anew import GROW, Rule
from gasbox.kernels.forced.sort import thickness
from gasbox.kernels.forced.tables import Terms, atoms, books, lists, room, slots, strips
from gasbox.kernels.forced.wall_tables import Walls, stand, walls

__all__ = [
    "FORCE_FIRST",
    "GROW",
    "LEFT",
    "LISTED",
    "LIST_FIRST",
    "TOO_FAR",
    "WALL_TOO_FAR",
    "Bath",
    "Bodies",
    "Crowd",
    "Inner",
    "Rule",
    "Terms",
    "Walls",
    "advance",
    "atoms",
    "bodies",
    "books",
    "lists",
    "room",
    "slots",
    "stand",
    "strips",
    "thickness",
    "walls",
]
