"""Energy, momentum and temperature of gases that can be reckoned in the head."""

import numpy as np
import pytest
from hand_made import gas, moved
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from gasbox import observe
from gasbox.geometry import Rectangle

WALLS = Rectangle(10.0, 20.0)
CHANNEL = Rectangle(10.0, 20.0, periodic_x=True)
TORUS = Rectangle(10.0, 20.0, periodic_x=True, periodic_y=True)

pytestmark = pytest.mark.small


def test_two_particles_of_different_mass():
    state = gas([[3.0, 4.0], [-1.0, 2.0]], mass=[2.0, 4.0])
    assert observe.kinetic_energy(state) == 25.0 + 10.0
    assert list(observe.momentum(state)) == [2.0, 16.0]
    assert observe.temperature(state, WALLS) == 2 * 35.0 / 4
    # Centre of mass at (1/3, 8/3): 35 - 0.5 (4 + 256)/6 is left in its frame.
    assert observe.temperature(state, TORUS) == pytest.approx(2 * (35.0 - 260.0 / 12) / 2)
    assert observe.temperature(state, CHANNEL) == pytest.approx(2 * (35.0 - 4.0 / 12) / 3)


def test_forces_between_discs_have_an_energy_too():
    state = gas([[3.0, 4.0], [-1.0, 2.0]], mass=[2.0, 4.0])
    state.potential = -7.5
    assert observe.potential_energy(state, TORUS) == -7.5
    assert observe.internal_energy(state, TORUS) == 35.0 - 7.5
    assert observe.enthalpy(state, TORUS, 0.5) == 27.5 + 0.5 * 200.0
    # A barostat has made the box larger: 12 x 20.
    assert observe.enthalpy(moved(state, 0.0, 2.0, 0.0, 0.0), TORUS, 0.5) == 27.5 + 0.5 * 240.0


def test_degrees_of_freedom():
    assert [observe.degrees_of_freedom(5, box) for box in (WALLS, CHANNEL, TORUS)] == [10, 9, 8]
    assert [observe.degrees_of_freedom(0, box) for box in (WALLS, CHANNEL, TORUS)] == [0, 0, 0]


def test_species_temperature_is_a_mean_energy():
    state = gas([[1.0, 0.0], [0.0, 3.0], [2.0, 0.0]], mass=[1.0, 1.0, 4.0], species=[0, 0, 2])
    assert observe.species_temperature(state, WALLS, 0) == 2.5
    assert observe.species_temperature(state, WALLS, 1) is None
    assert observe.species_temperature(state, WALLS, 2) == 8.0


def test_what_has_no_temperature():
    one = gas([[1.0, 2.0]])
    assert observe.temperature(one, TORUS) is None
    assert observe.species_temperature(one, TORUS, 0) is None
    assert observe.temperature(one, WALLS) == 2.5
    # In a channel only the velocity across it is heat.
    assert observe.temperature(one, CHANNEL) == 4.0
    assert observe.temperature(gas(np.zeros((0, 2))), WALLS) is None
    assert observe.kinetic_energy(gas(np.zeros((0, 2)))) == 0.0


velocities = arrays(np.float64, (7, 2), elements=st.floats(-10, 10))


@given(velocities, st.tuples(st.floats(-100, 100), st.floats(-100, 100)))
def test_a_drift_along_periodic_directions_is_no_heat(velocity, drift):
    mass = np.arange(1.0, 8.0)
    still, moving = gas(velocity, mass=mass), gas(velocity + drift, mass=mass)
    assert observe.temperature(moving, TORUS) == pytest.approx(observe.temperature(still, TORUS), abs=1e-9)
    along = gas(velocity + np.array([drift[0], 0.0]), mass=mass)
    assert observe.temperature(along, CHANNEL) == pytest.approx(observe.temperature(still, CHANNEL), abs=1e-9)


@given(velocities)
def test_species_share_the_energy(velocity):
    state = gas(velocity, mass=np.arange(1.0, 8.0), species=[0, 0, 0, 1, 1, 2, 2])
    for box in (WALLS, CHANNEL, TORUS):
        shares = [n * observe.species_temperature(state, box, s) for s, n in enumerate((3, 2, 2))]
        assert sum(shares) == pytest.approx(observe.thermal_energy(state, box), rel=1e-12)
    assert observe.thermal_energy(state, WALLS) == observe.kinetic_energy(state)
