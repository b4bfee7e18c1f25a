"""Overlaps of a gas that came from elsewhere: the worst one, and how to undo all."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.errors import Problem, ScenarioError
from gasbox.geometry import Enclosure, Geometry
from gasbox.initial.grid import empty_grid
from gasbox.initial.parting import part_molecules
from gasbox.initial.walls import bounds, out_of_walls, worst_at_wall
from gasbox.kernels.overlaps import SEPARATED, enter_all, push_apart, worst_pair
from gasbox.state import State

__all__ = ["Overlap", "separate", "worst_overlap"]

_TOUCHING: Final = 1e-9
"""Depth, as a fraction of the smaller radius, up to which discs only touch."""
_GAP: Final = 1e-7
_LOOKS_EACH: Final = 2000
_LOOKS_MORE: Final = 1_000_000


@dataclass(frozen=True)
class Overlap:
    """Two particles, or a particle and a wall, that are in one another.

    Attributes
    ----------
    first : id of a particle (of a pair: the lower one)
    second : id of the other one; None for a wall
    depth : [length]
    wall : name of the wall; None for a pair
    """

    first: int
    second: int | None
    depth: float
    wall: str | None = None

    def __str__(self) -> str:
        other = f"particle {self.second}" if self.wall is None else f"the {self.wall} wall"
        return f"particle {self.first} and {other} overlap by {self.depth:.3g}"


def worst_overlap(state: State, geometry: Geometry) -> Overlap | None:
    """The deepest overlap of two discs or of a disc and a wall; None if nothing more than touches.

    Touching is up to 1e-9 of the smaller radius: as much as exact dynamics may leave by rounding. Of molecules all
    discs are looked at, against those of other particles.
    """
    if not state.count:
        return None
    discs, owner = (
        (state, np.arange(state.count)) if state.sites is None else (state.sites, state.sites.owner)
    )
    position = geometry.wrap(discs.position)
    grid = empty_grid(geometry, discs.radius)
    enter_all(grid, position, np.arange(len(position)))
    first, second, depth = worst_pair(grid, position, discs.radius, owner, _TOUCHING)
    pair = None
    if first >= 0:
        one, other = sorted((int(state.id[owner[first]]), int(state.id[owner[second]])))
        pair = Overlap(one, other, float(depth))
    wall = None
    if (found := worst_at_wall(discs.position, discs.radius, geometry, _TOUCHING)) is not None:
        wall = Overlap(int(state.id[owner[found[0]]]), None, found[2], geometry.wall_names[found[1]])
    if pair is None or wall is None:
        return pair or wall
    return pair if pair.depth >= wall.depth else wall


def separate(state: State, geometry: Geometry) -> float:
    """Push overlapping particles apart and into the walls, in place, each pair only as far as it needs.

    Molecules are turned, too. Lighter ones give way farther, so that the centre of mass of a pair stays where it is.

    Returns
    -------
    The largest displacement [length]; 0 if nothing overlapped.

    Raises
    ------
    ScenarioError
        They are too crowded: overlaps are left after a bounded amount of work. The state is left as it was.
    """
    if not state.count:
        return 0.0
    if state.sites is not None:
        before = state.sites.position.copy()
        if not part_molecules(state, geometry, _GAP) or worst_overlap(state, geometry) is not None:
            raise ScenarioError([_crowded(state, geometry, "molecules")])
        return _largest(state.sites.position - before, geometry)
    low, high = bounds(state.radius, geometry)
    position = np.clip(geometry.wrap(state.position), low, high)
    walls = None
    if isinstance(geometry, Enclosure):
        walls, position = out_of_walls(position, state.radius, geometry)
    grid = empty_grid(geometry, state.radius)
    everyone = np.arange(state.count)
    enter_all(grid, position, everyone)
    share = state.mass.min() / state.mass
    budget = _LOOKS_EACH * state.count + _LOOKS_MORE
    status, _ = push_apart(
        grid, position, state.radius, share, low, high, state.radius, walls, _GAP, everyone, budget
    )
    if status != SEPARATED:
        raise ScenarioError([_crowded(state, geometry, "discs")])
    moved = _largest(position - state.position, geometry)
    state.position[:] = position
    return moved


def _crowded(state: State, geometry: Geometry, what: str) -> Problem:
    found = f"overlapping {what}"
    if state.sites is None:
        fraction = float(np.pi * np.square(state.radius).sum()) / geometry.area
        found += f" at an area fraction of {fraction:.4g}"
    return Problem("particles", found, "they could not be pushed apart; use a larger box")


def _largest(moved: NDArray[np.float64], geometry: Geometry) -> float:
    """The largest of displacements (n, 2) [length], to the nearest image."""
    moved = moved - np.where(geometry.periodic, np.round(moved / geometry.size) * geometry.size, 0.0)
    return float(np.sqrt(np.square(moved).sum(axis=1)).max())
