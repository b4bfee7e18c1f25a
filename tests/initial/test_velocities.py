"""Velocities at the start: the temperature is exact, and they are Maxwell's."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import stats

from gasbox.initial import populate
from gasbox.scenario import parse

PERIODIC = [[], ["x"], ["y"], ["x", "y"]]


def gas(species, periodic=(), seed=1):
    return parse(
        {
            "seed": seed,
            "container": {"width": 1000, "height": 1000, "periodic": list(periodic)},
            "species": [{"name": str(number), **entry} for number, entry in enumerate(species)],
        }
    )


def energies(state):
    energy = 0.5 * state.mass * np.square(state.velocity).sum(axis=1)
    return np.bincount(state.species, energy)


@settings(max_examples=60, deadline=None, derandomize=True)
@given(
    st.lists(st.tuples(st.integers(2, 30), st.floats(0.01, 1000), st.floats(0, 100)), min_size=1, max_size=4),
    st.sampled_from(PERIODIC),
    st.integers(0, 2**40),
)
def test_temperatures_are_exact_and_momentum_vanishes(kinds, periodic, seed):
    species = [{"count": n, "mass": m, "temperature": t} for n, m, t in kinds]
    scenario = gas(species, periodic, seed)
    state = populate(scenario)
    counts, masses, temperatures = np.array(kinds).T
    directions = len(periodic)
    expected = counts * temperatures * (1 - directions / 2 * masses / (counts @ masses))
    assert energies(state) == pytest.approx(expected, rel=1e-12, abs=1e-300)
    momentum = (state.mass[:, None] * state.velocity).sum(axis=0)
    scale = (state.mass[:, None] * np.abs(state.velocity)).sum(axis=0) + 1e-300
    for axis, name in enumerate("xy"):
        if name in periodic:
            assert abs(momentum[axis]) <= 1e-12 * scale[axis]


@pytest.mark.parametrize("periodic", PERIODIC)
def test_the_whole_gas_has_exactly_its_temperature(periodic):
    """T = 2 K / f, with one degree of freedom less for each direction in which momentum is conserved."""
    species = [{"count": 5, "mass": 1, "temperature": 0.7}, {"count": 3, "mass": 50, "temperature": 0.7}]
    state = populate(gas(species, periodic))
    freedom = 2 * state.count - len(periodic)
    assert 2 * energies(state).sum() / freedom == pytest.approx(0.7, rel=1e-13)


@pytest.mark.parametrize("periodic", PERIODIC)
def test_momentum_stays_among_the_species(periodic):
    """Only the sum over all species is taken off, so one species may move against the others."""
    species = [{"count": 50, "temperature": 1}, {"count": 50, "mass": 2, "temperature": 1}]
    state = populate(gas(species, periodic))
    assert np.abs(state.velocity[:50].mean(axis=0)).min() > 1e-6


def test_a_single_disc_of_a_species_keeps_what_it_was_dealt():
    light = {"count": 100, "temperature": 1}
    one, two = (populate(gas([light, {"count": n, "mass": 9, "temperature": 1}])) for n in (1, 2))
    assert energies(two)[1] == pytest.approx(2, rel=1e-13)
    assert abs(energies(one)[1] - 1) > 1e-3
    around = populate(gas([light, {"count": 1, "mass": 9, "temperature": 1}], ["x", "y"]))
    assert np.abs((around.mass[:, None] * around.velocity).sum(axis=0)).max() < 1e-12


@pytest.mark.parametrize("periodic", PERIODIC)
def test_the_only_disc_moves(periodic):
    assert np.abs(populate(gas([{"count": 1, "temperature": 1}], periodic)).velocity).min() > 0


def test_zero_temperature_is_rest():
    assert not populate(gas([{"count": 10, "temperature": 0}], ["x", "y"])).velocity.any()


def test_equal_speeds_in_random_directions():
    velocity = populate(gas([{"count": 4000, "speed": 1.5}])).velocity
    assert np.hypot(*velocity.T) == pytest.approx(1.5, rel=1e-15)
    angle = np.arctan2(velocity[:, 1], velocity[:, 0])
    assert stats.kstest(angle, stats.uniform(-np.pi, 2 * np.pi).cdf).pvalue > 1e-3


def test_given_velocities_are_taken_as_they_are():
    given_ones = [[1, 2], [0.1, -3], [0, 0]]
    scenario = gas([{"count": 10, "temperature": 1}, {"count": 3, "velocities": given_ones}], ["x", "y"])
    assert populate(scenario).velocity[10:].tolist() == given_ones


def test_maxwell_distribution():
    """Speeds squared over 2 T/m are exponential; 4000 independent speeds, Kolmogorov-Smirnov."""
    species = [{"count": 4000, "mass": 4, "temperature": 0.5}, {"count": 4000, "temperature": 2}]
    state = populate(gas(species, ["x"]))
    energy = 0.5 * state.mass * np.square(state.velocity).sum(axis=1)
    for number, temperature in enumerate([0.5, 2]):
        assert stats.kstest(energy[state.species == number] / temperature, "expon").pvalue > 1e-3
    for component in state.velocity[4000:].T:
        assert stats.kstest(component / np.sqrt(2), "norm").pvalue > 1e-3


def test_like_species_are_dealt_different_velocities():
    velocity = populate(gas([{"count": 20, "temperature": 1}] * 2)).velocity
    assert not np.isclose(velocity[:20], velocity[20:]).any()


def test_a_new_species_leaves_the_others_alone():
    first = {"count": 20, "temperature": 1}
    alone, together = (
        populate(gas([first])),
        populate(gas([first, {"count": 7, "mass": 3, "temperature": 2}])),
    )
    assert alone.velocity.tobytes() == together.velocity[:20].tobytes()


@pytest.mark.small
def test_without_the_compiler():
    state = populate(gas([{"count": 4, "temperature": 3}]))
    assert energies(state)[0] == pytest.approx(12, rel=1e-13)
