"""Collision rates and free paths from counts made by hand."""

import numpy as np
import pytest

from gasbox import observe
from gasbox.state import Tallies

pytestmark = pytest.mark.small


@pytest.fixture
def change():
    tallies = Tallies.zero(2, 4)
    tallies.pair_collisions[...] = [[10, 6], [0, 4]]
    tallies.wall_collisions[...] = [[1, 0], [2, 0], [3, 1], [4, 1]]
    return tallies


def test_rates(change):
    rates = observe.collision_rates(change, 2.0)
    assert (rates.pairs, rates.walls) == (10.0, 6.0)
    assert rates.per_pair.tolist() == [[5.0, 3.0], [0.0, 2.0]]
    assert rates.per_wall[:, 0].tolist() == [0.5, 1.0, 1.5, 2.0]
    assert observe.collision_rates(change, 0.0) is None


def test_a_collision_of_alike_particles_counts_for_both(change):
    per_particle = observe.collision_rates(change, 2.0).per_particle(np.array([5, 3]))
    np.testing.assert_allclose(per_particle, [[2.0, 0.6], [1.0, 4 / 3]])
    none = observe.collision_rates(change, 2.0).per_particle(np.array([5, 0]))
    assert none[1].tolist() == [0.0, 0.0]


def test_mean_free_path_is_all_paths_over_all_their_ends(change):
    counts, speeds = np.array([5, 3]), np.array([4.0, 2.0])
    # 2 time units: 5 * 4 * 2 + 3 * 2 * 2 of path, 2 * 20 ends.
    assert observe.mean_free_path(change, counts, speeds, 2.0) == pytest.approx(52 / 40)
    assert observe.species_mean_free_path(change, 0, 5, 4.0, 2.0) == pytest.approx(40 / 26)
    assert observe.species_mean_free_path(change, 1, 3, 2.0, 2.0) == pytest.approx(12 / 14)
    absent = observe.mean_free_path(change, np.array([5, 0]), np.array([4.0, np.nan]), 2.0)
    assert absent == pytest.approx(40 / 40)


def test_without_collisions_there_is_no_mean_free_path():
    nothing = Tallies.zero(1, 4)
    assert observe.mean_free_path(nothing, np.array([3]), np.array([1.0]), 2.0) is None
    assert observe.species_mean_free_path(nothing, 0, 3, 1.0, 2.0) is None
