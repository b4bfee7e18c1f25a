"""The fast engine against the slow twin: the same collisions, to the bit."""

from __future__ import annotations

import numpy as np
import pytest
from gases import collect, deepest_overlap, event_driven, random_gas, state_of
from twins import EventDrivenTwin

from gasbox.geometry import Rectangle

GASES = {
    "walled": (Rectangle(12, 9), [0.5] * 20, None),
    "periodic": (Rectangle(10, 8, True, True), [0.5] * 24, None),
    "slab": (Rectangle(9, 7, True, False), [0.6] * 12, None),
    "crowded": (Rectangle(7, 7, True, True), [0.5] * 28, None),
    "mixture": (Rectangle(20, 16), [3.0, 2.0] + [0.15] * 20 + [0.6] * 4, [50, 9] + [0.1] * 20 + [1] * 4),
    "mixture, periodic": (Rectangle(14, 11, True, True), [2.5] + [0.05] * 20 + [0.5] * 4, None),
    "two in a tiny box": (Rectangle(2.2, 2.2, True, True), [0.5, 0.5], None),
    "two, box of one cell and a bit": (Rectangle(2.9, 1.3, True, True), [0.5, 0.5], [1, 3]),
    "three in a narrow box": (Rectangle(1.7, 6.0, True, False), [0.4, 0.3, 0.4], None),
}


@pytest.mark.small
@pytest.mark.parametrize("name", GASES)
@pytest.mark.parametrize("seed", [1, 2])
def test_the_same_events_to_the_bit(name, seed):
    geometry, radii, masses = GASES[name]
    state = random_gas(seed, geometry, radii, masses)
    twin = EventDrivenTwin(state, geometry)
    engine = event_driven(state, geometry, contacts=7)
    until = 60.0 / len(radii) ** 1.3
    twin.run(until)
    rows = collect(engine, state, until)
    executed = [(time, 1 if kind == 0 else 2, first, second) for kind, time, first, second, _, _ in rows]
    assert len(executed) >= 3
    assert executed == twin.events
    assert np.array_equal(state.position, twin.position(until))
    assert np.array_equal(state.velocity, twin.v)
    assert deepest_overlap(state, geometry) < 1e-9


@pytest.mark.parametrize("periodic", [(False, False), (True, True), (True, False)])
@pytest.mark.parametrize("seed", [3, 4, 5])
def test_large_among_many_small_ones(periodic, seed):
    """Size ratios of 25 and 5, fast small discs: rings of cells around the large ones hide no meeting."""
    geometry = Rectangle(9, 8, *periodic)
    radii = [1.25, 1.0, 0.25, 0.25] + [0.05] * 60
    state = random_gas(seed, geometry, radii, [100.0, 60.0, 4.0, 4.0] + [0.1] * 60)
    twin = EventDrivenTwin(state, geometry)
    engine = event_driven(state, geometry, contacts=7)
    twin.run(0.6)
    rows = collect(engine, state, 0.6)
    executed = [(time, 1 if kind == 0 else 2, first, second) for kind, time, first, second, _, _ in rows]
    assert sum(event[2] < 2 for event in executed) >= 3
    assert executed == twin.events
    assert np.array_equal(state.position, twin.position(0.6))


def test_a_small_disc_farther_off_that_is_met_first():
    """Pushed, a large disc meets one in an outer ring of cells before the one that it found in an inner ring."""
    geometry = Rectangle(20, 8)
    crowd = [[x, y] for x in np.arange(8.5, 19.5, 0.6) for y in np.arange(0.5, 7.6, 0.5)]
    state = state_of(
        [[4, 4], [2.55, 4], [6.02, 4], [5.52, 5], *crowd],
        [[0, 0], [2, 0]] + [[0, 0]] * (2 + len(crowd)),
        [1.0, 0.25, 0.05, 0.05] + [0.05] * len(crowd),
        [1.0, 1.0, 0.01, 0.01] + [0.01] * len(crowd),
    )
    engine = event_driven(state, geometry, contacts=7)
    rows = collect(engine, state, 0.65)
    assert [row[2:4] for row in rows[:2]] == [(0, 1), (0, 2)]
    assert rows[1][1] == pytest.approx(0.585)
