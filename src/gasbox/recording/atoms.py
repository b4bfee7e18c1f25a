"""What a recording keeps of the discs of flexible molecules, which do not follow from a place and an angle."""

from __future__ import annotations

import h5py
import numpy as np
from numpy.typing import ArrayLike, NDArray

from gasbox.recording import places
from gasbox.scenario import Scenario
from gasbox.state import State

__all__ = ["atoms", "has_atoms", "write_bonds"]


def has_atoms(state: State) -> bool:
    """Whether discs are recorded one by one."""
    return state.sites is not None and bool(state.sites.flexible.any())


def atoms(state: State) -> dict[str, ArrayLike]:
    """Path -> value of all that discs keep while they move; `molecule` is the id of the particle of each."""
    sites = state.sites
    assert sites is not None
    values: dict[str, ArrayLike] = {
        f"{places.ATOMS}/{name}": getattr(sites, name) for name in places.ATOM_FIELDS
    }
    values[f"{places.ATOMS}/molecule"] = state.id[sites.owner]
    return values


def write_bonds(file: h5py.File, scenario: Scenario, state: State) -> None:
    """Write the rows of bonded discs, as H5MD wants connectivity, and the box of the discs."""
    sites = state.sites
    assert sites is not None
    found: list[NDArray[np.int64]] = [np.zeros((0, 2), np.int64)]
    for number, kind in enumerate(scenario.kinds):
        pairs = np.array([bond.atoms for bond in kind.bonds], np.int64).reshape(-1, 2)
        firsts = sites.first[:-1][state.species == number]
        found.append((firsts[:, None, None] + pairs).reshape(-1, 2))
    bonds = file.create_dataset(places.BONDS, data=np.concatenate(found))
    bonds.attrs["particles_group"] = file[places.ATOMS].ref
    file[f"{places.ATOMS}/box"] = file[f"{places.PARTICLES}/box"]
