"""How often particles meet each other and the walls, and how far they fly in between."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gasbox.state import Tallies

__all__ = ["CollisionRates", "collision_rates", "mean_free_path", "species_mean_free_path"]


@dataclass(frozen=True)
class CollisionRates:
    """Collisions per time in the whole gas.

    Attributes
    ----------
    pairs : of all pairs [1/time]
    walls : with all walls [1/time]
    per_pair : (species, species) float64 [1/time], [a, b] with a <= b for a pair of species, zero below the
        diagonal
    per_wall : (walls, species) float64 [1/time]
    """

    pairs: float
    walls: float
    per_pair: NDArray[np.float64]
    per_wall: NDArray[np.float64]

    def per_particle(self, counts: NDArray[np.int64]) -> NDArray[np.float64]:
        """(species, species) float64 [1/time]: how often one particle of a meets any of b (omega_ab).

        Zero for species without particles.

        Parameters
        ----------
        counts : (species,) number of particles
        """
        # A collision of like particles counts for both, one of unlike for one of each.
        shared = self.per_pair + self.per_pair.T
        rows = np.broadcast_to(counts[:, None], shared.shape)
        return np.divide(shared, rows, out=np.zeros_like(shared), where=rows > 0)


def collision_rates(change: Tallies, duration: float) -> CollisionRates | None:
    """Collisions per time from what was added to the tallies in `duration` [time]; None for no duration."""
    if duration <= 0.0:
        return None
    return CollisionRates(
        pairs=float(np.sum(change.pair_collisions)) / duration,
        walls=float(np.sum(change.wall_collisions)) / duration,
        per_pair=change.pair_collisions / duration,
        per_wall=change.wall_collisions / duration,
    )


def mean_free_path(
    change: Tallies, counts: NDArray[np.int64], mean_speeds: NDArray[np.float64], duration: float
) -> float | None:
    """Mean path between collisions with other particles [length]: all paths over all their ends.

    Bounces off walls do not end a path, so that in a small thin gas it may be longer than the box.

    Parameters
    ----------
    change : what was added to the tallies meanwhile
    counts : (species,) number of particles
    mean_speeds : (species,) float64 [length/time], best averaged over the time; anything where a count is
        zero
    duration : [time]

    Returns
    -------
    None if no pair collided.
    """
    ends = 2 * int(np.sum(change.pair_collisions))
    path = duration * float(np.sum(counts * np.where(counts > 0, mean_speeds, 0.0)))
    return path / ends if ends > 0 else None


def species_mean_free_path(
    change: Tallies, species: int, count: int, mean_speed: float, duration: float
) -> float | None:
    """Mean path of one species between collisions with any particle [length]; None if none of it collided."""
    pairs = change.pair_collisions
    # Row and column of the upper triangle meet on the diagonal, where both partners are of this species.
    ends = int(np.sum(pairs[species, :]) + np.sum(pairs[:, species]))
    return duration * count * mean_speed / ends if ends > 0 else None
