"""Rows and columns: as many places as promised, as far apart as promised."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gasbox.initial.arrangement import Patch, arrangements, most_places

pytestmark = pytest.mark.small


@settings(max_examples=150, deadline=None, derandomize=True)
@given(st.floats(0.5, 12), st.floats(0, 12), st.booleans(), st.booleans(), st.integers(1, 60))
def test_places_are_as_far_apart_as_promised(width, height, periodic_x, periodic_y, places):
    height = max(height, 1.0) if periodic_y else height
    patch = Patch(3.0, 2.0, max(width, 1.0), height, periodic_x, periodic_y)
    for arrangement in arrangements(patch, places, 1.0):
        position = arrangement.positions()
        assert position.shape == (arrangement.places, 2)
        assert arrangement.places >= places
        assert (position >= [3, 2]).all()
        assert (position <= [3 + patch.width, 2 + patch.height]).all()
        difference = position[:, None] - position[None]
        for axis, (length, periodic) in enumerate([(patch.width, periodic_x), (patch.height, periodic_y)]):
            if periodic:
                difference[..., axis] -= np.round(difference[..., axis] / length) * length
        distance = np.hypot(difference[..., 0], difference[..., 1])
        np.fill_diagonal(distance, math.inf)
        assert distance.min() >= arrangement.gap * (1 - 1e-12)
        assert arrangement.gap >= 1 - 1e-12


@pytest.mark.parametrize(
    ("width", "height", "most"),
    [
        (0, 0, 1),
        (9, 0, 10),
        (1, 1, 4),
        (0.5, math.sqrt(3) / 2, 2),
        # Five columns by three rows, every second row one less.
        (4, math.sqrt(3), 14),
    ],
)
def test_most_places_of_small_boxes(width, height, most):
    assert most_places(Patch(0, 0, width, height, False, False), 1.0) == most
    assert most_places(Patch(0, 0, height, width, False, False), 1.0) == most


def test_the_triangular_lattice_fills_a_periodic_box():
    # pi / (2 sqrt 3) is the densest packing of discs: L. Fejes Toth, Math. Z. 46, 83 (1940).
    patch = Patch(0, 0, 10.0, 12 * math.sqrt(3) / 2, True, True)
    assert most_places(patch, 1.0) == 120
