"""The gas at one moment: a structure of arrays."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from gasbox.state.sites import Sites

__all__ = ["State"]


@dataclass
class State:
    """All particles at one time. Rows are in the order of ascending `id`.

    Attributes
    ----------
    time : [time]
    id : (n,) int64
    species : (n,) int32, index into the scenario's species
    mass : (n,) float64 [mass]
    radius : (n,) float64 [length]
    position : (n, 2) float64 [length], centres; inside the box also where it is periodic
    velocity : (n, 2) float64 [length/time]
    wall_displacement : (walls,) float64 [length], of each wall along its normal since the start; empty if none moves
    wall_velocity : (walls,) float64 [length/time], likewise
    potential : potential energy of all forces between discs, and of soft walls, at this time [energy]; 0 without forces
    virial : sum over pairs of the force (repulsive > 0) times the distance, at this time [energy]
    angle : (n,) float64 [rad], by which each molecule is turned, counter-clockwise; empty without molecules
    angular_velocity : (n,) float64 [rad/time], likewise
    inertia : (n,) float64 [mass·length²], moment of inertia about the centre of mass; 0 of what does not rotate
    sites : the discs of the molecules; None without molecules, then each particle is a disc

    The position and the velocity of a molecule are those of its centre of mass, its radius reaches to the farthest rim.
    """

    time: float
    id: NDArray[np.int64]
    species: NDArray[np.int32]
    mass: NDArray[np.float64]
    radius: NDArray[np.float64]
    position: NDArray[np.float64]
    velocity: NDArray[np.float64]
    wall_displacement: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))
    wall_velocity: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))
    potential: float = 0.0
    virial: float = 0.0
    angle: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))
    angular_velocity: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))
    inertia: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))
    sites: Sites | None = None

    @property
    def count(self) -> int:
        """Number of particles."""
        return int(self.id.shape[0])

    def copy(self) -> State:
        """An independent copy."""
        return State(
            self.time,
            self.id.copy(),
            self.species.copy(),
            self.mass.copy(),
            self.radius.copy(),
            self.position.copy(),
            self.velocity.copy(),
            self.wall_displacement.copy(),
            self.wall_velocity.copy(),
            self.potential,
            self.virial,
            self.angle.copy(),
            self.angular_velocity.copy(),
            self.inertia.copy(),
            None if self.sites is None else self.sites.copy(),
        )

    def keep(self, rows: NDArray[np.bool_]) -> None:
        """Go on with these particles (n,) bool alone; the others have left."""
        for name in ("id", "species", "mass", "radius", "position", "velocity"):
            setattr(self, name, getattr(self, name)[rows])
        if self.sites is not None:
            self.sites.keep(rows)
            for name in ("angle", "angular_velocity", "inertia"):
                setattr(self, name, getattr(self, name)[rows])

    def turn_sites(self) -> None:
        """Put the sites of rigid molecules where their molecules are."""
        if self.sites is not None:
            self.sites.follow(self.position, self.velocity, self.angle, self.angular_velocity)
