"""Speeds, and the centre of mass where there is no edge to count from."""

import math

import numpy as np
import pytest
from hand_made import gas
from hypothesis import given
from hypothesis import strategies as st

from gasbox import observe
from gasbox.geometry import Rectangle

WALLS = Rectangle(10.0, 20.0)
TORUS = Rectangle(10.0, 20.0, periodic_x=True, periodic_y=True)

pytestmark = pytest.mark.small


def test_mean_and_rms_speed():
    state = gas([[3.0, 4.0], [0.0, 1.0], [6.0, 8.0]], species=[0, 0, 1])
    assert observe.mean_speed(state, 0) == 3.0
    assert observe.rms_speed(state, 0) == math.sqrt(13.0)
    assert observe.mean_speed(state) == pytest.approx(16.0 / 3)
    assert observe.mean_speed(state, 2) is None
    assert observe.rms_speed(state, 2) is None


def test_center_of_mass_between_walls_weighs_by_mass():
    state = gas(np.zeros((2, 2)), mass=[1.0, 3.0], position=[[2.0, 4.0], [6.0, 8.0]])
    assert list(observe.center_of_mass(state, WALLS)) == [5.0, 7.0]
    assert observe.center_of_mass(state, WALLS, 1) is None


def test_center_of_mass_across_a_periodic_edge():
    state = gas(np.zeros((2, 2)), position=[[9.5, 19.0], [0.5, 3.0]])
    torus = observe.center_of_mass(state, TORUS)
    assert torus[0] == pytest.approx(0.0, abs=1e-12) or torus[0] == pytest.approx(10.0)
    assert torus[1] == pytest.approx(1.0)
    channel = observe.center_of_mass(state, Rectangle(10.0, 20.0, periodic_y=True))
    assert channel[0] == 5.0
    assert channel[1] == pytest.approx(1.0)


@given(st.floats(0.0, 9.999), st.floats(0.0, 10.0))
def test_center_of_mass_moves_with_a_cluster(middle, shift):
    offsets = np.array([[-0.3, 0.0], [0.1, 0.0], [0.2, 0.0]])
    place = TORUS.wrap(offsets + np.array([middle + shift, 7.0]))
    center = observe.center_of_mass(gas(np.zeros((3, 2)), position=place), TORUS)
    assert 0.0 <= center[0] < 10.0
    away = (center[0] - middle - shift + 5.0) % 10.0 - 5.0
    assert abs(away) < 1e-3  # the circular mean bends by the cube of the spread over the length
