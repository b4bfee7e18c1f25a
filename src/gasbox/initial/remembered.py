"""Where walls that move were when a snapshot was made, for a dynamics other than that which made it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gasbox.geometry import Enclosure, Geometry
from gasbox.kernels.hall import hall
from gasbox.kernels.hall.motion import show_walls
from gasbox.scenario import Snapshot
from gasbox.state import State

__all__ = ["recall_walls"]


def recall_walls(state: State, geometry: Geometry, snapshot: Snapshot) -> None:
    """Write displacement and speed of all walls to the state, as any dynamics remembers them."""
    memory = snapshot.memory
    if not isinstance(geometry, Enclosure) or not geometry.moves or "walls" not in memory:
        return
    # Who passes is nothing to where walls are.
    walls = tuple(replace(wall, passes=None) for wall in geometry.walls)
    table = hall(replace(geometry, walls=walls), 1, 0)
    rows = np.asarray(memory["walls"], np.float64)
    table.wall[:, : rows.shape[1]] = rows
    # Event-driven dynamics counts time from the start of an epoch.
    start = float(memory["epoch"]) * float(memory["epoch_length"]) if "epoch" in memory else 0.0
    state.wall_displacement, state.wall_velocity = np.zeros((2, len(table.wall)))
    show_walls(table, state.time - start, state.wall_displacement, state.wall_velocity)
