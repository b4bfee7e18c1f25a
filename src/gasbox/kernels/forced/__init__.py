"""Kernels of the forced rule: discs that attract and repel each other, by velocity Verlet."""

from gasbox.kernels.forced.advance import TOO_FAR, advance
from gasbox.kernels.forced.bath import Bath
from gasbox.kernels.forced.prepare import GROW, Rule, prepare
from gasbox.kernels.forced.tables import Crowd, Terms, atoms, books, lists, room, slots, strips
from gasbox.kernels.forced.walls import Walls, walls

__all__ = [
    "GROW",
    "TOO_FAR",
    "Bath",
    "Crowd",
    "Rule",
    "Terms",
    "Walls",
    "advance",
    "atoms",
    "books",
    "lists",
    "prepare",
    "room",
    "slots",
    "strips",
    "walls",
]
