"""Every particle is in exactly one bin, or counted as outside."""

import numpy as np
import pytest
from hand_made import gas
from hypothesis import given
from hypothesis import strategies as st

from gasbox import observe
from gasbox.geometry import Rectangle

WALLS = Rectangle(10.0, 20.0)

pytestmark = pytest.mark.small


def test_bins_are_half_open():
    shown = observe.Histogram.of(np.array([-0.1, 0.0, 0.99, 1.0, 1.5, 2.0, 7.0]), np.array([0.0, 1.0, 2.0]))
    assert shown.counts.tolist() == [2.0, 2.0]
    assert (shown.underflow, shown.overflow, shown.total) == (1.0, 2.0, 7.0)


def test_speeds_and_energies_of_a_species():
    state = gas([[3.0, 4.0], [0.0, 1.0], [0.0, 2.0]], mass=[2.0, 2.0, 8.0], species=[0, 0, 1])
    edges = observe.bin_edges(3, 0.0, 6.0)
    assert edges.tolist() == [0.0, 2.0, 4.0, 6.0]
    assert observe.speed_histogram(state, 0, edges).counts.tolist() == [1.0, 0.0, 1.0]
    assert observe.speed_histogram(state, 1, edges).counts.tolist() == [0.0, 1.0, 0.0]
    assert observe.speed_histogram(state, None, edges).counts.tolist() == [1.0, 1.0, 1.0]
    energy = observe.energy_histogram(state, None, np.array([0.0, 1.5, 20.0]))
    assert energy.counts.tolist() == [1.0, 1.0]
    assert energy.overflow == 1.0
    same = observe.histogram(state, None, np.array([0.0, 1.5, 20.0]), "energy")
    assert same.counts.tolist() == energy.counts.tolist()


@given(st.lists(st.floats(-10, 10), max_size=50), st.integers(1, 40), st.floats(-5, 5), st.floats(0.01, 10))
def test_no_particle_is_lost(values, bins, minimum, width):
    edges = observe.bin_edges(bins, minimum, minimum + width)
    shown = observe.Histogram.of(np.array(values), edges)
    assert shown.total == len(values)
    assert shown.counts.shape == (bins,)
    inside = [v for v in values if edges[0] <= v < edges[-1]]
    assert shown.counts.sum() == len(inside)
    for i in range(bins):
        assert shown.counts[i] == sum(edges[i] <= v < edges[i + 1] for v in values)


def test_automatic_end_follows_from_temperature_not_from_the_fastest():
    rng = np.random.default_rng(1)
    state = gas(rng.normal(size=(1000, 2)))
    end = observe.automatic_maximum(state, WALLS, 0)
    assert end == 4.0  # 99.9 % below sqrt(2 ln 1000) = 3.72
    state.velocity[0] *= 3.0 / np.linalg.norm(state.velocity[0])
    assert observe.automatic_maximum(state, WALLS, 0) == end
    assert observe.automatic_maximum(state, WALLS, 0, "energy") == 8.0  # ln 1000 = 6.9


def test_automatic_end_of_a_species_that_starts_hot_cold_or_heavy():
    hot = np.full((50, 2), 2.0)
    cold = np.zeros((50, 2))
    state = gas(np.concatenate([hot, cold]), species=[0] * 50 + [1] * 50, mass=[1.0] * 50 + [4.0] * 50)
    # Hot: T = 4 at the start, and 2 for the whole gas, to which the cold one will come.
    assert observe.automatic_maximum(state, WALLS, 0) == 8.0  # 3.72 * 2 = 7.4
    assert observe.automatic_maximum(state, WALLS, 1) == 3.0  # 3.72 * sqrt(2/4) = 2.6


def test_automatic_end_without_a_temperature():
    torus = Rectangle(10.0, 20.0, periodic_x=True, periodic_y=True)
    assert observe.automatic_maximum(gas([[0.0, 0.0]]), WALLS, 0) == 1.0
    assert observe.automatic_maximum(gas([[0.0, 0.7]]), torus, 0) == 0.8
    assert observe.automatic_maximum(gas([[0.0, 0.7]]), WALLS, 3) == 1.0
