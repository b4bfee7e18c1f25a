"""What surrounds discs under forces: the enclosure, its walls as they move, and the numbers that follow from it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.dynamics.baths import degrees_of_freedom
from gasbox.dynamics.changes import as_enclosure
from gasbox.dynamics.forced_discs import has_molecules
from gasbox.dynamics.halls import start_walls
from gasbox.errors import UsageError
from gasbox.geometry import Enclosure, Geometry, Piston
from gasbox.geometry.conserved import conserved_momentum
from gasbox.kernels import forced
from gasbox.kernels.hall import Hall, hall
from gasbox.rng import halves
from gasbox.state import State

__all__ = ["Surroundings", "surroundings"]

_SKIN = 0.4
"""By which lists reach beyond the largest cutoff, in units of the smallest sigma."""
_MOST = 0.25
"""Way in one step, in units of the smallest sigma, that no sensible step makes."""


class Surroundings(NamedTuple):
    """A geometry as the kernels take it.

    Attributes
    ----------
    enclosure, hall : the geometry, a plain rectangle as an enclosure; and its tables
    bath, rule : numbers for the kernels
    """

    enclosure: Enclosure
    hall: Hall
    bath: forced.Bath
    rule: forced.Rule


def surroundings(
    state: State,
    geometry: Geometry,
    time_step: float,
    sigma: float,
    smooth: bool,
    drive: NDArray[np.float64],
    kinds: int,
    seed: int,
    rows: NDArray[np.float64] | None,
) -> Surroundings:
    """Take over a geometry at the time of the state.

    Parameters
    ----------
    time_step, sigma, smooth : [time]; smallest range of a force [length]; whether walls push back smoothly
    drive : aims of the baths, shared with the kernels
    kinds : of particle, how many there are
    rows : how walls move, as `gasbox.dynamics.halls.wall_rows` gave it; None: as they do from now on

    Raises
    ------
    UsageError
        Walls that forces have no answer to.
    """
    enclosure = as_enclosure(geometry)
    refused = _refusal(enclosure, has_molecules(state), smooth)
    if refused is not None:
        raise UsageError(refused)
    tables = hall(enclosure, kinds, seed)
    start_walls(tables, enclosure, state, 0.0, rows)
    drifts = conserved_momentum(geometry)
    bath = forced.Bath(
        drive,
        halves(seed),
        state.count,
        degrees_of_freedom(state, geometry),
        bool(drifts[0]),
        bool(drifts[1]),
    )
    gravity = np.where(geometry.periodic, 0.0, geometry.gravity)
    rule = forced.Rule(
        time_step,
        _SKIN * sigma,
        _MOST * sigma,
        bool(geometry.periodic_x),
        bool(geometry.periodic_y),
        float(gravity[0]),
        float(gravity[1]),
    )
    return Surroundings(enclosure, tables, bath, rule)


def _refusal(enclosure: Enclosure, molecules: bool, smooth: bool) -> str | None:
    """Why forces have no answer to these walls, in a sentence."""
    if any(isinstance(wall.motion, Piston) for wall in enclosure.walls):
        return "under forces no wall moves freely: a piston needs another dynamics, or a motion of its own"
    through = any(wall.open or wall.passes is not None or wall.soft for wall in enclosure.walls)
    if molecules and (enclosure.moves or through):
        return "under forces molecules know no walls that move, are open, let some pass, or come later"
    if smooth and through:
        return "walls that push back smoothly cannot be open, let some pass, or come later"
    return None
