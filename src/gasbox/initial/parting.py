"""How overlaps of molecules are undone."""

from __future__ import annotations

import numpy as np

from gasbox.geometry import Enclosure, Geometry
from gasbox.initial.barriers import barriers, stops_all
from gasbox.initial.grid import empty_grid
from gasbox.initial.walls import bounds
from gasbox.kernels.molecules.parting import push_bodies_apart
from gasbox.kernels.molecules.placing import Bodies, enter_bodies
from gasbox.state import State

__all__ = ["part_molecules"]

_SWEEPS = 2000
"""Enough for some hundred that were dropped into one another; a gas of the stepped rule needs a few."""


def part_molecules(state: State, geometry: Geometry, gap: float) -> bool:
    """Push molecules that overlap apart, in place; False, and the state as it was, if they are too crowded.

    gap : how far beyond touching they are pushed, as a fraction of the sum of the radii
    """
    sites = state.sites
    assert sites is not None
    low, high = bounds(sites.radius, geometry)
    walls = (
        barriers(geometry, float(sites.radius.max()), stops_all) if isinstance(geometry, Enclosure) else None
    )
    bodies = Bodies(
        sites.first,
        sites.place,
        sites.radius,
        sites.radius,
        np.broadcast_to(low, sites.position.shape).copy(),
        np.broadcast_to(high, sites.position.shape).copy(),
        geometry.wrap(state.position),
        state.angle.copy(),
        np.ones(state.count),
        sites.position.copy(),
        sites.radius.copy(),
    )
    grid = empty_grid(geometry, sites.radius)
    enter_bodies(bodies, grid, np.arange(state.count))
    turns = state.inertia > 0.0
    spin = np.divide(1.0, state.inertia, out=np.zeros(state.count), where=turns)
    share = np.column_stack([1.0 / state.mass, spin])
    if not push_bodies_apart(bodies, grid, walls, sites.owner, share, gap, _SWEEPS):
        return False
    state.position[:] = geometry.wrap(bodies.position)
    state.angle[:] = bodies.angle
    state.turn_sites()
    return True
