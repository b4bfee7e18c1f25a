"""Places of all particles at the start, and how they are turned."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.initial.molecule_places import place_turned
from gasbox.initial.placing import place
from gasbox.scenario import Scenario

__all__ = ["place_all"]


def place_all(
    scenario: Scenario,
    listed: NDArray[np.float64],
    listed_species: NDArray[np.int32],
    listed_angle: NDArray[np.float64],
    species: NDArray[np.int32],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Positions (n, 2) [length] and angles (n,) [rad] of the counted particles of kinds `species` (n,).

    Raises
    ------
    ScenarioError
        No places were found within a bounded amount of work.
    """
    turning = [number for number, kind in enumerate(scenario.kinds) if kind.inertia > 0.0]
    if not np.isin(np.concatenate([listed_species, species]), turning).any():
        return place(scenario, listed, listed_species, species), np.zeros(species.shape[0])
    return place_turned(scenario, listed, listed_species, listed_angle, species)
