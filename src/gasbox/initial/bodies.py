"""The particles of a gas with molecules while they look for their places."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
import shapely
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.initial.grid import empty_grid
from gasbox.kernels.barriers import Barriers
from gasbox.kernels.molecules.placing import Bodies, enter_bodies
from gasbox.kernels.size_grid import SizeGrid
from gasbox.rng import Stream, generator
from gasbox.scenario import Kind, centre_bounds

__all__ = ["Draw", "Filling", "filling"]


class Draw:
    """Random places and angles."""

    def __init__(self, seed: int) -> None:
        self._places = generator(seed, Stream.POSITIONS)
        self._angles = generator(seed, Stream.ORIENTATIONS)

    def uniform(self, count: int) -> NDArray[np.float64]:
        """(count, 3) in [0, 1): two of a place, one of an angle."""
        return np.column_stack([self._places.random((count, 2)), self._angles.random(count)])

    def within(self, box: NDArray[np.float64], count: int) -> NDArray[np.float64]:
        """(count, 3): places [length] in a box (2, 2), and angles [rad]."""
        drawn = self.uniform(count)
        drawn[:, :2] = box[0] + drawn[:, :2] * (box[1] - box[0])
        drawn[:, 2] *= 2.0 * math.pi
        return drawn

    def shuffled(self, rows: NDArray[np.int64]) -> NDArray[np.int64]:
        """`rows` (m,) in random order."""
        return self._places.permutation(rows)


@dataclass(frozen=True)
class Filling:
    """A container that is being filled.

    Attributes
    ----------
    geometry : the container
    kinds : all kinds of particle, with their own radii
    kind : (n,) int32, of each particle
    bodies : the particles
    grid : those that have a place
    walls : what stands in the way apart from the bounds; None for nothing
    """

    geometry: Geometry
    kinds: tuple[Kind, ...]
    kind: NDArray[np.int32]
    bodies: Bodies
    grid: SizeGrid
    walls: Barriers | None

    def box(self, kind: int) -> NDArray[np.float64]:
        """Lower and upper bounds (2, 2) [length] of where centres of mass are looked for."""
        left, right, lower, upper = self.kinds[kind].bounds(self.geometry)
        return np.array([[left, lower], [right, upper]])

    def emptied(self, kept: NDArray[np.int64]) -> Filling:
        """The same with these particles (m,) alone."""
        empty = replace(self, grid=empty_grid(self.geometry, self.bodies.full))
        enter_bodies(empty.bodies, empty.grid, kept)
        return empty


def filling(
    geometry: Geometry,
    kinds: tuple[Kind, ...],
    radii: list[NDArray[np.float64]],
    kind: NDArray[np.int32],
    walls: Barriers | None,
) -> Filling:
    """A container without particles.

    Parameters
    ----------
    radii : of the discs of each kind, with which they are placed beside each other [length]
    kind : (n,) of each particle
    """
    tables = [_table(geometry, kinds[k], radii[k], walls is not None) for k in range(len(kinds))]
    lengths = np.array([len(table) for table in tables], np.int64)[kind]
    first = np.concatenate([[0], np.cumsum(lengths)]).astype(np.int64)
    every = np.concatenate([np.zeros((0, 8)), *(tables[k] for k in kind)])
    place, full, reach, low, high = np.split(every, (2, 3, 4, 6), axis=1)
    count = kind.shape[0]
    bodies = Bodies(
        first,
        place.copy(),
        full[:, 0].copy(),
        reach[:, 0].copy(),
        low.copy(),
        high.copy(),
        np.zeros((count, 2)),
        np.zeros(count),
        np.ones(count),
        np.zeros((len(every), 2)),
        full[:, 0].copy(),
    )
    return Filling(geometry, kinds, kind, bodies, _grid(geometry, bodies), walls)


def _grid(geometry: Geometry, bodies: Bodies) -> SizeGrid:
    """A grid for the discs; what is none is never entered, and must not make cells small."""
    radius = bodies.full
    return empty_grid(geometry, np.where(radius > 0.0, radius, radius.max(initial=1.0)))


def _table(
    geometry: Geometry, kind: Kind, radii: NDArray[np.float64], between_walls: bool
) -> NDArray[np.float64]:
    """Rows (m, 8) of the discs of a kind: place, radius, reach, lower and upper bounds [length]."""
    place, reach = kind.place, kind.radii
    if between_walls and not _is_joined(kind):
        chain = _chain(kind)
        place = np.concatenate([place, chain])
        radii = np.concatenate([radii, np.zeros(len(chain))])
        reach = np.concatenate([reach, np.full(len(chain), reach.min())])
    bounds = [centre_bounds(geometry, kind.bounds(geometry), float(r)) for r in reach]
    return np.column_stack([place, radii, reach, np.array(bounds).reshape(-1, 4)])


def _is_joined(kind: Kind) -> bool:
    """Whether no line can pass between the discs."""
    discs = shapely.buffer(shapely.points(kind.place), kind.radii)
    return bool(shapely.get_num_geometries(shapely.union_all(discs)) == 1)


def _chain(kind: Kind) -> NDArray[np.float64]:
    """Places (m, 2) [length] along the lines from the centre of mass to all discs, closer than the least radius."""
    pitch = float(kind.radii.min())
    return np.concatenate(
        [
            np.linspace(0.0, 1.0, math.ceil(float(np.hypot(*end)) / pitch) + 1)[:-1, None] * end
            for end in kind.place
        ]
    )
