"""What a forced dynamics must know of its discs and molecules to go on with the same bits."""

from __future__ import annotations

import dataclasses

import numpy as np
from numpy.typing import NDArray

from gasbox.dynamics.forced_room import Tables
from gasbox.dynamics.halls import wall_rows
from gasbox.kernels import forced
from gasbox.state import Memory, State

__all__ = ["as_listed", "listed_walls", "put_back", "remembered"]


def remembered(tables: Tables, moves: bool) -> Memory:
    """Places now, and when neighbours were listed; of molecules also what their discs do.

    ``position`` (n, 2): places, also outside a periodic box; ``built`` (n, 2): places at which neighbours were
    listed. With molecules ``built`` is (m, 2), and there are, of all discs, ``site_position`` and ``site_velocity``
    (m, 2), and ``site_shift`` (m, 2): by how many boxes each is away from its molecule. If walls move (`moves`),
    ``walls``: how each does, and ``walls_built`` (walls,): displacements when neighbours were listed.
    """
    atoms, bodies = tables.crowd.atoms, tables.crowd.bodies
    places, built = tables.by_row(atoms.x, atoms.y), tables.by_row(atoms.bx, atoms.by)
    walls: Memory = {}
    if moves:
        walls = {"walls": wall_rows(tables.walls.hall), "walls_built": tables.walls.listed.copy()}
    if bodies is None:
        return {"position": places, "built": built, **walls}
    return {
        **walls,
        "position": np.stack([bodies.x, bodies.y], axis=1),
        "built": built,
        "site_position": places,
        "site_velocity": tables.by_row(atoms.vx, atoms.vy),
        "site_shift": np.stack([bodies.shift_x, bodies.shift_y], axis=1),
    }


def as_listed(discs: State, bodies: forced.Bodies | None, memory: Memory) -> State:
    """The discs where they stood when neighbours were listed; `bodies` as they were then, in place."""
    if bodies is not None:
        bodies.shift_x[:], bodies.shift_y[:] = _vectors(memory, "site_shift").T
        # Centres are brought into the box together with their discs, which are there already.
        bodies.x[:] = bodies.y[:] = 0.0
    return dataclasses.replace(discs, position=_vectors(memory, "built"))


def put_back(tables: Tables, memory: Memory) -> None:
    """Bring all to where it was when `memory` was taken; lists stay as they are."""
    bodies = tables.crowd.bodies
    if bodies is None:
        tables.put(_vectors(memory, "position"))
        return
    bodies.x[:], bodies.y[:] = _vectors(memory, "position").T
    tables.put(_vectors(memory, "site_position"))
    tables.put_velocities(_vectors(memory, "site_velocity"))


def listed_walls(memory: Memory | None) -> NDArray[np.float64] | None:
    """(walls,) displacements when neighbours were listed; None if nothing is remembered of that."""
    if memory is None or "walls_built" not in memory:
        return None
    return np.asarray(memory["walls_built"], np.float64)


def _vectors(memory: Memory, name: str) -> NDArray[np.float64]:
    return np.asarray(memory[name], np.float64).reshape(-1, 2)
