"""A rectangle whose size a barostat has changed."""

import numpy as np
import pytest

from gasbox.geometry import Rectangle

BOX = Rectangle(10.0, 20.0, periodic_x=True, periodic_y=True)

pytestmark = pytest.mark.small


def test_it_is_as_large_as_its_sides_say():
    assert BOX.at(np.array([0.0, 1.5, 0.0, -3.0])) == Rectangle(11.5, 17.0, True, True)
    assert BOX.at(np.array([-1.0, 0.0, 2.0, 0.0])) == Rectangle(11.0, 18.0, True, True)


@pytest.mark.parametrize("displacement", [np.zeros(0), np.zeros(4)])
def test_walls_at_rest_leave_it_the_same(displacement):
    assert BOX.at(displacement) is BOX
