"""Overlaps of molecules: of the discs of two different ones, across periods, and with walls."""

import numpy as np
import pytest
from molecule_gases import BENT, DUMBBELL, deepest, gas, rod

from gasbox.initial import populate, worst_overlap

pytestmark = pytest.mark.small


@pytest.mark.parametrize("shape", [DUMBBELL, BENT, rod(3)])
def test_the_worst_pair_of_molecules_is_that_of_all_pairs(shape):
    scenario = gas(shape, 12, 0.2)
    state, geometry = populate(scenario), scenario.geometry()
    assert worst_overlap(state, geometry) is None
    for seed in range(8):
        random = np.random.default_rng(seed)
        state.position = random.random((12, 2)) * geometry.size
        state.angle = random.random(12) * 2 * np.pi
        state.turn_sites()
        depth = deepest(state, geometry)
        found = worst_overlap(state, geometry)
        assert found is not None
        assert found.first < found.second
        assert found.depth == pytest.approx(depth, rel=1e-12)


def test_a_molecule_in_a_wall_is_told_by_its_number():
    scenario = gas(DUMBBELL, 3, 0.03, periodic=())
    state, geometry = populate(scenario), scenario.geometry()
    state.position[:] = [[5, 2], [0.7, 5], [5, 8]]
    state.angle[1] = 0.0
    state.turn_sites()
    found = worst_overlap(state, geometry)
    assert str(found) == "particle 1 and the left wall overlap by 0.3"
    state.angle[1] = np.pi / 2
    state.turn_sites()
    assert worst_overlap(state, geometry) is None
