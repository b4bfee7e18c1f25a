"""The plain engines compute the same as the fast ones, so that their rates can be compared."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray

from gasbox.bench.gases import collisions
from gasbox.bench.plain.event_driven import PlainEventDriven
from gasbox.bench.plain.stepped import PlainStepped
from gasbox.bench.scenarios import exact_gas, stepped_gas
from gasbox.initial import populate
from gasbox.simulation import Simulation

pytestmark = pytest.mark.small


def apart(one: NDArray[np.float64], other: NDArray[np.float64], length: float) -> NDArray[np.float64]:
    """Distances (n,) between positions (n, 2) in a periodic square."""
    difference = one - other
    difference -= length * np.rint(difference / length)
    return np.hypot(*difference.T)


@pytest.mark.parametrize(("discs", "fraction"), [(1, 0.2), (200, 0.2), (200, 0.65)])
def test_stepped_to_the_bit(discs: int, fraction: float) -> None:
    # Where it is dense, discs touch several others at once, so that the order of the pairs matters.
    scenario = stepped_gas(discs, fraction)
    simulation, state = Simulation(scenario), populate(scenario)
    plain = PlainStepped(state.position, state.velocity, scenario.container.geometry().size, 1.0, 1.0)
    for _ in range(3):
        plain.step(40)
        simulation.advance(until=simulation.time + 40)
        assert np.array_equal(plain.position, simulation.state.position)
        assert np.array_equal(plain.velocity, simulation.state.velocity)
        assert plain.collisions == collisions(simulation)
    assert discs == 1 or plain.collisions > discs


@pytest.mark.parametrize(("fraction", "time"), [(0.05, 6.0), (0.3, 1.0), (0.6, 0.3)])
def test_event_driven_goes_the_same_way(fraction: float, time: float) -> None:
    simulation = Simulation(exact_gas(200, fraction))
    state, length = simulation.state, simulation.geometry.width
    plain = PlainEventDriven(state.position, state.velocity, length, 1.0)
    for until in (time / 2, time):
        plain.advance(until)
        simulation.advance(until=until)
        assert plain.collisions == collisions(simulation)
        # A difference grows some 10 times in each collision of a disc, and each has had two to four.
        assert apart(plain.position, simulation.state.position, length).max() < 1e-8
        assert np.allclose(plain.velocity, simulation.state.velocity, atol=1e-8)
    assert plain.collisions > 100


def test_event_driven_keeps_its_laws_for_long() -> None:
    simulation = Simulation(exact_gas(100, 0.6))
    state, length = simulation.state, simulation.geometry.width
    energy, momentum = np.sum(state.velocity**2), state.velocity.sum(axis=0)
    plain = PlainEventDriven(state.position, state.velocity, length, 1.0)
    plain.advance(2.0)
    assert plain.collisions > 1000
    assert math.isclose(np.sum(plain.velocity**2), energy, rel_tol=1e-12)
    assert np.allclose(plain.velocity.sum(axis=0), momentum, atol=1e-12)
    first, second = np.triu_indices(100, 1)
    assert apart(plain.position[first], plain.position[second], length).min() > 1 - 1e-9
