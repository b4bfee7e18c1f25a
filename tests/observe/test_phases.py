"""Phases told from neighbourhoods: crystals, crystals with a surface, liquids, gases, and drops."""

import numpy as np
import pytest
from cold_discs import discs, equilibrated, lattice

from gasbox import observe
from gasbox.geometry import Rectangle
from gasbox.observe import Phase

pytestmark = pytest.mark.small


def shares(state, box):
    return observe.phase_shares(observe.phases(state, box))


def test_a_perfect_crystal_is_all_solid():
    assert shares(*lattice(10, 8, 0.93)).tolist() == [0.0, 0.0, 1.0]


def test_a_piece_of_crystal_is_solid_but_for_its_surface():
    state, box = lattice(14, 14, 0.93)
    wide = Rectangle(60.0, 60.0)
    state.position += 20.0
    found = observe.phases(state, wide)
    bulk = observe.coordination(state, wide) == 6
    # Two rows in from the edge nobody notices it.
    inner = np.all(np.abs(state.position - 20.0 - 0.5 * box.size) < 0.5 * box.size - 2.5, axis=1)
    assert np.all(found[inner] == Phase.SOLID)
    assert np.all(bulk[inner])
    assert np.mean(found == Phase.SOLID) > 0.8
    assert not np.any(found == Phase.GAS)


def test_a_crystal_near_its_melting_point_is_solid():
    solid = equilibrated(*lattice(12, 12, 0.86), 0.38, 40)
    assert shares(*solid)[Phase.SOLID] > 0.95


def test_a_liquid_is_mostly_liquid():
    hot = equilibrated(*lattice(12, 12, 0.7), 2.0, 40, step=0.3)
    liquid = shares(*equilibrated(*hot, 0.5, 60))
    assert liquid[Phase.LIQUID] > 0.8
    assert liquid[Phase.GAS] < 0.05


def test_a_dilute_gas_is_all_gas():
    position = np.random.default_rng(4).uniform(0.0, 100.0, (200, 2))
    assert shares(*discs(position, Rectangle(100.0, 100.0, True, True))).tolist() == [1.0, 0.0, 0.0]


def test_a_drop_and_its_vapour():
    drop, _ = lattice(12, 12, 0.7)
    rng = np.random.default_rng(9)
    inside = drop.position + rng.normal(0.0, 0.18, drop.position.shape) + 30.0
    outside = rng.uniform(0.0, 80.0, (60, 2))
    clear = np.min(np.linalg.norm(outside[:, None] - inside[None], axis=2), axis=1) > 3.0
    state, box = discs(np.concatenate([inside, outside[clear]]), Rectangle(80.0, 80.0, True, True))
    found = observe.phases(state, box)
    assert np.all(found[len(inside) :] == Phase.GAS)
    assert np.mean(found[: len(inside)] != Phase.GAS) > 0.95


def test_no_discs_have_no_phase():
    state, box = discs(np.zeros((0, 2)), Rectangle(1.0, 1.0))
    assert observe.phases(state, box).shape == (0,)
    assert np.all(np.isnan(shares(state, box)))


def test_larger_discs_look_further():
    state, box = lattice(10, 8, 0.93 / 9.0)
    assert observe.phase_shares(observe.phases(state, box, 4.5)).tolist() == [0.0, 0.0, 1.0]
    assert observe.phase_shares(observe.phases(state, box)).tolist() == [1.0, 0.0, 0.0]
