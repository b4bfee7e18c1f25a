"""The energies of one particle: of its flight, its rotation, and of what moves within it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gasbox.observe import (
    degrees_of_rotation,
    degrees_of_vibration,
    rotational_energies,
    translational_energies,
    vibrational_energies,
)
from gasbox.observe.rotation import spins
from gasbox.state import Sites, State

__all__ = ["Energies", "energies_of"]


@dataclass(frozen=True)
class Energies:
    """Kinetic energies of one particle.

    Attributes
    ----------
    translational : of its centre of mass [energy]
    rotational : about it [energy]; None for what does not turn
    vibrational : of the rest [energy]; None for what is rigid
    angular_velocity : [rad/time], counter-clockwise; 0 for what does not turn
    """

    translational: float
    rotational: float | None = None
    vibrational: float | None = None
    angular_velocity: float = 0.0


def energies_of(state: State, row: int) -> Energies:
    """Of the particle in this row."""
    one = _alone(state, row)
    return Energies(
        float(translational_energies(one)[0]),
        float(rotational_energies(one)[0]) if degrees_of_rotation(one)[0] else None,
        float(vibrational_energies(one)[0]) if degrees_of_vibration(one)[0] else None,
        float(spins(one)[1][0]),
    )


def _alone(state: State, row: int) -> State:
    """This particle by itself; of a large gas nothing else is touched."""
    mine = slice(row, row + 1)
    rows = ("id", "species", "mass", "radius", "position", "velocity")
    one = State(state.time, *(getattr(state, name)[mine] for name in rows))
    if state.sites is None:
        return one
    for name in ("angle", "angular_velocity", "inertia"):
        setattr(one, name, getattr(state, name)[mine])
    first, last = state.sites.first[row : row + 2]
    parts = ("species", "mass", "radius", "place", "position", "velocity")
    own = {name: getattr(state.sites, name)[first:last] for name in parts}
    one.sites = Sites(first=np.array([0, last - first]), flexible=state.sites.flexible[mine], **own)
    return one
