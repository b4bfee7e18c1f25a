"""Which discs of a gas are bonded."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.scenario import Scenario
from gasbox.state import State

__all__ = ["bonds_between"]


def bonds_between(scenario: Scenario, state: State) -> NDArray[np.int64]:
    """(bonds, 2) rows of the sites that each bond holds together."""
    found = [np.zeros((0, 2), np.int64)]
    if state.sites is not None:
        first = state.sites.first[:-1]
        for number, kind in enumerate(scenario.kinds):
            pairs = np.array([bond.atoms for bond in kind.bonds], np.int64).reshape(-1, 2)
            found.append((first[state.species == number][:, None, None] + pairs).reshape(-1, 2))
    return np.concatenate(found)
