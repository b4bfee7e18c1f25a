"""Periodic boxes so short that a single cell goes round them, and so few cells that a disc meets many images."""

from __future__ import annotations

import math

import numpy as np
import pytest
from gases import event_driven, random_gas
from test_odd_gases import compare

from gasbox.geometry import Rectangle
from gasbox.kernels.event_driven.tables import COLUMN, LABEL, LEVEL, ROW


def narrow_gas(seed: int):
    """A few discs of up to three sizes in a box one to three diameters of the largest high, and up to twelve long."""
    rng = np.random.default_rng(seed)
    diameter = 2.0
    height, width = diameter * rng.uniform(1.01, 3.2), diameter * rng.uniform(1.01, 12.0)
    sides = (width, height) if rng.random() < 0.5 else (height, width)
    along = bool(rng.integers(0, 2))
    periodic = (along, True) if sides == (width, height) else (True, along)
    sizes = rng.choice([[1.0, 1.0, 1.0], [1.0, 0.4, 0.4], [1.0, 0.3, 0.06]])
    room = 0.25 * width * height / math.pi
    radii = [1.0] if rng.random() < 0.5 else [0.4]
    while len(radii) < 25 and sum(r * r for r in radii) < room:
        radii.append(float(rng.choice(sizes)))
    if len(radii) == 1:
        radii.append(0.1)
    state = random_gas(seed, Rectangle(*sides, *periodic), radii, 10.0 ** rng.uniform(-1, 1, len(radii)))
    # Round the short way much faster than along.
    state.velocity *= rng.choice([1.0, 30.0], 2)
    return state, Rectangle(*sides, *periodic)


def test_narrow_boxes_as_by_brute_force():
    assert sum(compare(*narrow_gas(seed), 100) for seed in range(40)) > 4000


@pytest.mark.validate
def test_many_narrow_boxes_as_by_brute_force():
    assert sum(compare(*narrow_gas(seed), 300) for seed in range(1000, 1300)) > 90_000


@pytest.mark.parametrize("seed", range(6))
def test_every_disc_is_filed_in_the_cell_where_it_is(seed):
    """Flying once round a box of a single row is no reason to change the column."""
    state, geometry = narrow_gas(seed)
    engine = event_driven(state, geometry)
    fastest = float(np.abs(state.velocity).max())
    for _ in range(50):
        engine.advance(state, state.time + 0.3 * geometry.size.min() / fastest)
        tables = engine._tables
        link = tables.link[np.argsort(tables.link[:, LABEL])]
        for axis, cell in ((0, link[:, COLUMN]), (1, link[:, ROW])):
            side = tables.sides[link[:, LEVEL], axis]
            off = state.position[:, axis] - (cell + 0.5) * side
            if geometry.periodic[axis]:
                off -= geometry.size[axis] * np.rint(off / geometry.size[axis])
            assert np.all(np.abs(off) < (0.5 + 1e-6) * side)
