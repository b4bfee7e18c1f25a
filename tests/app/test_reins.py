"""How far a hand may move a wall, and how fast."""

from __future__ import annotations

import math

import numpy as np
import pytest
from free_flight import FreeFlight
from surroundings import DIVIDER, placed, walled

from gasbox.app.reins import displacement_of, guided, limits, movable, released
from gasbox.geometry import Enclosure
from gasbox.state import SetWall

pytestmark = pytest.mark.small
PISTON = {"right": {"motion": {"kind": "piston", "mass": 50, "pressure": 0.3}}}
RIGHT, DIVIDED = 1, 4


def enclosure(simulation: FreeFlight) -> Enclosure:
    assert isinstance(simulation.geometry, Enclosure)
    return simulation.geometry


def test_what_can_be_moved() -> None:
    slanted = {"shape": "segment", "start": [10, 5], "end": [20, 30]}
    geometry = walled(walls=PISTON, obstacles=[DIVIDER, slanted]).geometry()
    assert [movable(geometry, wall) for wall in range(6)] == [False, True, False, False, True, False]
    assert not movable(geometry, 17)
    assert isinstance(geometry, Enclosure)
    assert not movable(geometry.with_wall(DIVIDED, present=False), DIVIDED)
    assert not movable(walled(container={"shape": "circle", "radius": 20}).geometry(), 0)


def test_a_piston_is_not_pushed_beyond_what_the_gas_can_take() -> None:
    simulation = FreeFlight(walled((100,), walls=PISTON))
    low, high = limits(enclosure(simulation), simulation.state, RIGHT)
    least = 100 * math.pi * 0.5**2 / 0.6 / 40
    assert 60 + low == pytest.approx(least)
    assert high == 60.0


def test_a_divider_stays_between_its_neighbours() -> None:
    simulation = placed(FreeFlight(walled((2,), obstacles=[DIVIDER])), [(10, 10), (50, 10)])
    low, high = limits(enclosure(simulation), simulation.state, DIVIDED)
    # Four radii are kept free on each side.
    assert (low, high) == pytest.approx((-30 + 2.0, 30 - 2.0))


def test_it_follows_with_half_the_mean_speed() -> None:
    simulation = FreeFlight(walled((50,), walls=PISTON))
    simulation.state.velocity = np.tile([0.6, 0.8], (50, 1))
    change = guided(simulation.geometry, simulation.state, RIGHT, -10.0, 0.5)
    assert change is not None
    assert (change.wall, change.displacement, change.speed) == ("right", -10.0, pytest.approx(0.5))
    far = guided(simulation.geometry, simulation.state, RIGHT, -1e9, 0.5)
    assert far is not None
    assert far.displacement > -60
    assert guided(simulation.geometry, simulation.state, RIGHT, math.nan, 0.5) is None
    assert guided(simulation.geometry, simulation.state, 0, 1.0, 0.5) is None


def test_a_gas_at_rest_gives_some_speed_too() -> None:
    simulation = FreeFlight(walled((5,), walls=PISTON))
    simulation.state.velocity[:] = 0.0
    change = guided(simulation.geometry, simulation.state, RIGHT, 1.0, 0.5)
    assert change is not None
    assert change.speed > 0


def test_a_piston_that_is_let_go_is_free_again() -> None:
    start = walled(walls=PISTON, obstacles=[DIVIDER]).geometry()
    assert released(start, RIGHT) == SetWall("right", free=True)
    assert released(start, DIVIDED) is None
    assert released(start, 99) is None


def test_where_a_wall_is() -> None:
    simulation = FreeFlight(walled(walls=PISTON))
    assert displacement_of(simulation.state, RIGHT) == 0.0
    simulation.state.wall_displacement[RIGHT] = -3.0
    assert displacement_of(simulation.state, RIGHT) == -3.0
    assert displacement_of(FreeFlight(walled()).state, 0) == 0.0
