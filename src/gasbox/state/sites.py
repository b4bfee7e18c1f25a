"""The discs that molecules are made of."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["Sites"]


@dataclass
class Sites:
    """All discs of a gas with molecules: those of each particle together, in the order of the particles.

    A single disc is a particle with one site.

    Attributes
    ----------
    first : (n + 1,) int64, particle r has the sites first[r] to first[r + 1]
    species : (m,) int32, index into the scenario's kinds of site: its species, then the atoms of its molecules
    mass : (m,) float64 [mass]
    radius : (m,) float64 [length]
    place : (m, 2) float64 [length], where each stands in its molecule, seen from the centre of mass, at angle 0
    position : (m, 2) float64 [length]; next to the others of its molecule, so perhaps outside a periodic box
    velocity : (m, 2) float64 [length/time], of the centre of each
    flexible : (n,) bool, whether the sites of a particle move against each other; the others are rigid
    """

    first: NDArray[np.int64]
    species: NDArray[np.int32]
    mass: NDArray[np.float64]
    radius: NDArray[np.float64]
    place: NDArray[np.float64]
    position: NDArray[np.float64]
    velocity: NDArray[np.float64]
    flexible: NDArray[np.bool_]

    @property
    def count(self) -> int:
        """Number of sites."""
        return int(self.mass.shape[0])

    @property
    def owner(self) -> NDArray[np.int64]:
        """(m,) int64: the row of the particle that each site belongs to."""
        return np.repeat(np.arange(self.first.size - 1), np.diff(self.first))

    def copy(self) -> Sites:
        """An independent copy."""
        return Sites(**{name: array.copy() for name, array in vars(self).items()})

    def keep(self, rows: NDArray[np.bool_]) -> None:
        """Go on with the sites of these particles (n,) bool alone."""
        mine = rows[self.owner]
        self.first = np.concatenate([[0], np.cumsum(np.diff(self.first)[rows])]).astype(np.int64)
        self.flexible = self.flexible[rows]
        for name in ("species", "mass", "radius", "place", "position", "velocity"):
            setattr(self, name, getattr(self, name)[mine])

    def follow(
        self,
        position: NDArray[np.float64],
        velocity: NDArray[np.float64],
        angle: NDArray[np.float64],
        angular_velocity: NDArray[np.float64],
        flexible_too: bool = False,
    ) -> None:
        """Put the sites of rigid particles where these are, with their velocities.

        Parameters
        ----------
        position, velocity : (n, 2) of the centres of mass [length], [length/time]
        angle, angular_velocity : (n,) [rad], [rad/time]
        flexible_too : whether those of flexible particles follow, too, in their shape at rest
        """
        owner = self.owner
        cos, sin = np.cos(angle)[owner], np.sin(angle)[owner]
        arm = np.stack(
            [
                cos * self.place[:, 0] - sin * self.place[:, 1],
                sin * self.place[:, 0] + cos * self.place[:, 1],
            ],
            axis=1,
        )
        turning = angular_velocity[owner, None] * np.stack([-arm[:, 1], arm[:, 0]], axis=1)
        those = flexible_too | ~self.flexible[owner]
        self.position[those] = (position[owner] + arm)[those]
        self.velocity[those] = (velocity[owner] + turning)[those]
