"""Which momenta count as heat, by hand."""

import math

import numpy as np
import pytest
from hand_made import gas, hall

from gasbox import observe
from gasbox.geometry import Block, Circle, Passage, Post, Rectangle, Segment
from gasbox.geometry.conserved import conserved_momentum, conserves_rotation

TORUS = Rectangle(10.0, 20.0, periodic_x=True, periodic_y=True)
CHANNEL = Rectangle(10.0, 20.0, periodic_x=True)
ROUND = Circle(10.0)

pytestmark = pytest.mark.small


def conserved(geometry):
    return conserved_momentum(geometry).tolist()


def test_gravity_breaks_the_direction_along_which_it_acts():
    assert conserved(hall(TORUS)) == [True, True]
    assert conserved(hall(TORUS, gravity=(0.0, -1.0))) == [True, False]
    assert conserved(hall(CHANNEL, gravity=(1.0, -1.0))) == [False, False]
    assert conserved(hall(Rectangle(10.0, 20.0))) == [False, False]


def test_obstacles_break_what_they_can_push_along():
    post = Post((5.0, 5.0), 1.0)
    across, along = Segment((5.0, 0.0), (5.0, 20.0)), Segment((0.0, 5.0), (10.0, 5.0))
    assert conserved(hall(TORUS, post)) == [False, False]
    assert conserved(hall(CHANNEL, across)) == [False, False]
    assert conserved(hall(CHANNEL, along)) == [True, False]
    # A block has sides of its own.
    assert conserved(hall(CHANNEL, Block(((2.0, 2.0), (4.0, 2.0), (3.0, 4.0))))) == [False, False]


def test_what_nobody_bounces_off_breaks_nothing():
    across = Segment((5.0, 0.0), (5.0, 20.0))
    for settings in ({"present": False}, {"passes": Passage()}, {"open": True}):
        assert conserved(hall(CHANNEL, across, gate=settings, names=["gate"])) == [True, False], settings
    one = Passage(species=(0,))
    assert conserved(hall(CHANNEL, across, gate={"passes": one}, names=["gate"])) == [False, False]


def test_a_thermal_wall_is_rough():
    assert conserved(hall(CHANNEL, bottom={"temperature": 1.0})) == [False, False]


def test_a_bare_smooth_circle_conserves_rotation():
    assert conserves_rotation(hall(ROUND))
    assert not conserves_rotation(hall(ROUND, gravity=(0.0, -1.0)))
    assert not conserves_rotation(hall(ROUND, Post((10.0, 10.0), 1.0)))
    assert conserves_rotation(hall(ROUND, Post((10.0, 10.0), 1.0), names=["post"], post={"present": False}))
    assert not conserves_rotation(hall(ROUND, rim={"temperature": 1.0}))
    assert not conserves_rotation(Rectangle(1.0, 1.0))
    assert not conserves_rotation(hall(TORUS))


def test_rotation_is_no_heat():
    # Two discs opposite each other, 3 from the centre: 4 along the arm and 2 around. L = 2 * 2 * 3, I = 18.
    state = gas([[4.0, 2.0], [-4.0, -2.0]], position=[[13.0, 10.0], [7.0, 10.0]])
    assert observe.angular_momentum(state, (10.0, 10.0)) == pytest.approx(12.0)
    assert observe.degrees_of_freedom(2, hall(ROUND)) == 3
    assert observe.thermal_energy(state, hall(ROUND)) == pytest.approx(20.0 - 12.0**2 / (2 * 18.0))
    assert observe.temperature(state, hall(ROUND)) == pytest.approx(2 * 16.0 / 3)
    assert observe.species_temperature(state, hall(ROUND), 0) == pytest.approx(8.0)
    # With gravity nothing is taken off.
    heavy = hall(ROUND, gravity=(0.0, -1.0))
    assert observe.temperature(state, heavy) == pytest.approx(2 * 20.0 / 4)


def test_a_disc_in_the_centre_of_a_circle_cannot_turn():
    assert observe.temperature(gas([[3.0, 4.0]], position=[[10.0, 10.0]]), hall(ROUND)) == 25.0


def test_obstacles_give_the_degrees_of_freedom_back():
    post = Post((5.0, 5.0), 1.0)
    state = gas([[3.0, 4.0], [-1.0, 2.0]], mass=[2.0, 4.0])
    assert observe.degrees_of_freedom(2, hall(TORUS, post)) == 4
    assert observe.temperature(state, hall(TORUS, post)) == 2 * 35.0 / 4
    assert observe.temperature(state, hall(TORUS)) == observe.temperature(state, TORUS)


def test_potential_energy():
    state = gas(np.zeros((2, 2)), mass=[2.0, 3.0], position=[[1.0, 4.0], [2.0, 10.0]])
    assert observe.potential_energy(state, Rectangle(10.0, 20.0)) == 0.0
    assert observe.potential_energy(state, hall(Rectangle(10.0, 20.0), gravity=(0.0, -0.5))) == 0.5 * (8 + 30)
    tilted = hall(Rectangle(10.0, 20.0), gravity=(1.0, -0.5))
    assert observe.potential_energy(state, tilted) == 19.0 - (2 + 6)
    # Round and round there is no height.
    assert observe.potential_energy(state, hall(CHANNEL, gravity=(1.0, -0.5))) == 19.0
    falling = gas([[0.0, 2.0]], mass=[3.0], position=[[5.0, 4.0]])
    assert observe.internal_energy(falling, tilted) == 6.0 + 3 * (0.5 * 4 - 5)


def test_the_law_holds_for_a_rigidly_rotating_gas():
    # Whatever turns as a rigid body is cold.
    angle = np.linspace(0.0, 5.0, 7)
    arm = np.stack([np.cos(angle), np.sin(angle)], axis=1) * np.arange(1, 8)[:, None]
    turning = gas(
        0.3 * np.stack([-arm[:, 1], arm[:, 0]], axis=1), position=arm + 10.0, mass=np.arange(1.0, 8.0)
    )
    assert observe.kinetic_energy(turning) > 1.0
    assert observe.temperature(turning, hall(ROUND)) == pytest.approx(0.0, abs=1e-15)
    assert math.isclose(
        observe.temperature(turning, hall(ROUND, Post((1.0, 1.0), 0.1))),
        2 * observe.kinetic_energy(turning) / 14,
    )
