"""Discs under gravity, by the stepped rule: nobody sinks, however long; and pressure is the same all around."""

from __future__ import annotations

import numpy as np
import pytest
from enclosures import enclosure, fill, internal_energy
from gases import energy, state_of
from stepped_gases import pair_depth, stepped, wall_depth

from gasbox.geometry import Circle, Polygon, Rectangle

DOWN = (0.0, -1.0)
BOX = Rectangle(10, 10)
VALLEY = Polygon(((0.0, 20.0), (10.0, 0.0), (20.0, 20.0)))
WEDGE = Polygon(((0.0, 20.0), (1.5, 0.0), (3.0, 20.0)))
SLOPE = (-0.6, -0.8)
HEAPS = {
    "floor": (BOX, DOWN, [[5, 0.5]]),
    "slope into a corner": (BOX, SLOPE, [[5, 0.5]]),
    "corner": (BOX, DOWN, [[0.5, 0.5]]),
    "stack": (BOX, DOWN, [[5, 0.5 + k] for k in range(5)]),
    "stack in disorder": (BOX, DOWN, [[5, 0.5 + k] for k in (4, 1, 3, 0, 2)]),
    "shaft": (Rectangle(1.6, 10), DOWN, [[0.5 + 0.6 * (k % 2), 0.5 + 0.8 * k] for k in range(6)]),
    "valley": (VALLEY, DOWN, [[10, 1.2]]),
    "three in a valley": (VALLEY, DOWN, [[10, 1.2], [10, 2.4], [10, 3.6]]),
    "wedge": (WEDGE, DOWN, [[1.5, 7.0]]),
    "circle": (Circle(5.0), DOWN, [[5, 0.5], [4, 0.7], [6, 0.7], [3.0, 1.2], [7, 1.2]]),
}


@pytest.mark.parametrize("step", [0.01, 0.05])
@pytest.mark.parametrize(("container", "gravity", "position"), HEAPS.values(), ids=HEAPS.keys())
def test_nobody_sinks(container, gravity, position, step):
    """Over 10^5 steps of contact, nobody is deeper in a wall or in another than it flies in one or two steps."""
    place = enclosure(container, gravity=gravity)
    state = state_of(position, np.zeros((len(position), 2)), 0.5)
    before = internal_energy(state, place)
    engine = stepped(state, place, time_step=step)
    for k in range(1, 1001):
        engine.advance(state, 100 * k * step)
        fastest = np.hypot(*state.velocity.T).max()
        assert wall_depth(state, place) * 0.5 <= step * (step + fastest)
        assert pair_depth(state, place) * 0.5 <= 2.0 * step * (step + fastest)
        assert place.holds(state.position, 0.0).all()
    change = internal_energy(state, place) - before - engine.tallies.rest_energy[0]
    assert abs(change) < 1e-9
    # What the rule for rest gives warms a heap to some ten g dt, and ends there: m/2 (20 g dt)² a disc.
    assert engine.tallies.rest_energy[0] < 200 * len(position) * step * step + 1e-6


@pytest.mark.small
def test_a_disc_at_rest_hops_no_higher_than_the_rule_says():
    place = enclosure(BOX, gravity=DOWN)
    state = state_of([[5, 0.5]], [[0, 0]], 0.5)
    engine = stepped(state, place, time_step=0.01)
    for step in range(1, 400):
        engine.advance(state, 0.01 * step)
        assert 0.5 - 1e-15 <= state.position[0, 1] <= 0.5 + 0.5e-6
    assert engine.tallies.rest_energy[0] == pytest.approx(0.5e-6, rel=1e-9)


@pytest.mark.small
@pytest.mark.parametrize("step", [0.01, 0.07])
def test_a_bouncing_disc_keeps_its_height(step):
    """A parabola sampled in steps; the floor turns it round with the speed that it has at the floor."""
    place = enclosure(BOX, gravity=DOWN)
    state = state_of([[5, 4.0]], [[0, 0]], 0.5)
    engine = stepped(state, place, time_step=step)
    highest = 0.0
    for k in range(1, 4000):
        engine.advance(state, k * step)
        top = state.position[0, 1] + 0.5 * state.velocity[0, 1] ** 2
        assert top == pytest.approx(4.0, abs=1e-11)
        highest = max(highest, state.position[0, 1])
    assert highest > 4.0 - 0.5 * step * step
    assert engine.tallies.rest_energy[0] == 0.0


def test_floor_and_ceiling_carry_the_weight():
    """The impulse on the floor less that on the ceiling is N m g t, and what the momentum of the gas has changed by."""
    place = enclosure(Rectangle(12, 8), gravity=(0.0, -0.3))
    state = fill(place, 30)
    before = (state.mass * state.velocity[:, 1]).sum()
    engine = stepped(state, place)
    engine.advance(state, 100.0)
    _, _, floor, ceiling = engine.tallies.wall_impulse.sum(axis=1)
    change = (state.mass * state.velocity[:, 1]).sum() - before
    assert floor - ceiling == pytest.approx(state.mass.sum() * 0.3 * 100.0 + change, rel=1e-11)


def test_the_barometric_law():
    """The mean height of thin gas in a tall box is kT/(m g) above the floor, T shared with the potential energy."""
    place = enclosure(Rectangle(60, 200), gravity=(0.0, -0.1))
    state = fill(place, 150, sizes=(0.1, 0.1), masses=(1.0, 1.0))
    # All energy from the place: E = N (kT + kT) for a tall box.
    state.velocity[:] = np.random.default_rng(1).normal(size=(150, 2))
    state.position[:, 1] = 0.1 + np.random.default_rng(2).exponential(10.0, 150)
    total = (internal_energy(state, place) - 0.1 * 0.1 * 150) / 150
    engine = stepped(state, place, time_step=0.05)
    engine.advance(state, 200.0)
    heights = []
    for k in range(2000):
        engine.advance(state, 200.0 + 2.0 * k)
        heights.append((state.position[:, 1] - 0.1).mean())
    expected = total / 2.0 / 0.1
    blocks = np.array(heights).reshape(20, 100).mean(axis=1)
    error = blocks.std(ddof=1) / np.sqrt(20)
    # B2 N/(2W) of discs that small: 0.02 σ (0.2) above; the share of one in N: 1/300.
    assert abs(np.mean(heights) - expected) < 5 * error + 0.03 + expected / 300


SHAPES = {
    "L": enclosure(Polygon(((0.0, 0.0), (20.0, 0.0), (20.0, 10.0), (10.0, 10.0), (10.0, 20.0), (0.0, 20.0)))),
    "circle": enclosure(Circle(9.0)),
    "triangle": enclosure(Polygon(((0.0, 0.0), (24.0, 0.0), (0.0, 24.0)))),
}


@pytest.mark.parametrize("place", SHAPES.values(), ids=SHAPES.keys())
def test_pressure_is_the_same_on_all_walls(place):
    """Impulse over time and the length that centres can reach: that of the ideal gas with room for its centres.

    Discs of 0.1: collisions among them add 2 eta = 0.4 %. A wall's error is 1.13/sqrt(hits), dilute; five of them are
    some five per cent.
    """
    state = fill(place, 60, sizes=(0.1, 0.1), masses=(1.0, 1.0))
    engine = stepped(state, place, time_step=0.01)
    engine.advance(state, 2000.0)
    tallies = engine.tallies
    kinetic = energy(state)
    expected = kinetic / place.accessible_area(0.1)
    for wall in range(len(place.walls)):
        hits = tallies.wall_collisions[wall].sum()
        pressure = tallies.wall_impulse[wall].sum() / (2000.0 * place.accessible_length(wall, 0.1))
        assert hits > 1000
        assert pressure / expected == pytest.approx(1.004, abs=0.004 + 5 * 1.128 / np.sqrt(hits))
