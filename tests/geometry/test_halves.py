"""Areas on both sides of a segment."""

import numpy as np
import pytest

from gasbox.geometry import Circle, Enclosure, Passage, Rectangle, Segment, Wall, side_names
from gasbox.geometry.halves import half_areas

pytestmark = pytest.mark.small


def room(container, *segments, **last):
    names = [*side_names(container), *(f"o{k}" for k in range(len(segments)))]
    walls = [Wall(name) for name in names[:-1]] + [Wall(names[-1], **last)]
    return Enclosure(container, segments, tuple(walls))


DIVIDED = Segment((4, 0), (4, 2)), Segment((4, 6), (4, 4)), Segment((4, 2), (4, 4))


@pytest.mark.parametrize("passes", [None, Passage(), Passage((1,))])
def test_both_sides_of_a_divider(passes):
    # Upwards: its normal points to the right, and behind is left.
    behind, ahead = half_areas(room(Rectangle(10, 6), *DIVIDED, passes=passes), 6, 0.5)
    assert behind == pytest.approx(3 * 5)
    assert ahead == pytest.approx(5 * 5)


def test_the_other_way_round_and_moved():
    down = room(Rectangle(10, 6), Segment((4, 6), (4, 0)))
    assert half_areas(down, 4, 0.5) == pytest.approx((25, 15))
    moved = down.at(np.array([0, 0, 0, 0, 1.0]))  # to the left
    assert half_areas(moved, 4, 0.5) == pytest.approx((30, 10))


def test_a_circle_is_cut_in_halves():
    behind, ahead = half_areas(room(Circle(5), Segment((0, 5), (10, 5))), 1, 0.0)
    assert behind == pytest.approx(ahead, rel=1e-9)
    assert behind + ahead == pytest.approx(25 * np.pi, rel=1e-3)
