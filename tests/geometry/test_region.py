"""Areas and border lengths that centres can reach, against formulas worked out by hand."""

import math

import numpy as np
import pytest

from gasbox.geometry import (
    Block,
    Circle,
    Enclosure,
    Polygon,
    Post,
    Rectangle,
    Segment,
    Wall,
    regular_polygon,
    side_names,
)
from gasbox.geometry.region import components

pytestmark = pytest.mark.small

R = 0.5
BOX = Rectangle(10, 6)
ELL = Polygon(((0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)))
APOTHEM = 5 * math.sqrt(3) / 2 - R


def enclosure(container, obstacles=(), displacement=()):
    names = [*side_names(container), *(f"obstacle-{k}" for k in range(len(obstacles)))]
    return Enclosure(container, tuple(obstacles), tuple(map(Wall, names)), displacement=displacement)


@pytest.mark.parametrize(
    ("container", "obstacles", "area", "reached", "border"),
    [
        (BOX, [], 60, 45, 28),
        (Circle(5), [], 25 * math.pi, 4.5**2 * math.pi, 9 * math.pi),
        (
            Polygon(regular_polygon(6, 5)),
            [],
            37.5 * math.sqrt(3),
            2 * math.sqrt(3) * APOTHEM**2,
            4 * math.sqrt(3) * APOTHEM,
        ),
        (ELL, [], 12, 3 * 1 + 1 * 2 + 0.25 - math.pi / 16, 3 + 3 + 1 + 1 + 1.5 + 1.5 + math.pi / 4),
        (BOX, [Post((5, 3), 1)], 60 - math.pi, 45 - 2.25 * math.pi, 28 + 3 * math.pi),
        (BOX, [Segment((5, 0), (5, 6))], 60, 40, 36),
        (BOX, [Segment((5, 0), (5, 2))], 60, 45 - 1.5 - math.pi / 8, 28 - 1 + 3 + math.pi / 2),
        (
            BOX,
            [Block(((4, 2), (6, 2), (6, 4), (4, 4)))],
            56,
            45 - 8 - math.pi / 4,
            28 + 8 + math.pi,
        ),
        (Rectangle(10, 6, True, False), [], 60, 50, 20),
        (Rectangle(10, 6, True, True), [Post((0, 0), 1)], 60 - math.pi, 60 - 2.25 * math.pi, 3 * math.pi),
    ],
)
def test_areas_and_borders(container, obstacles, area, reached, border):
    shape = enclosure(container, obstacles)
    assert shape.area == pytest.approx(area, rel=1e-9)
    assert shape.accessible_area(R) == pytest.approx(reached, rel=1e-6)
    total = sum(shape.accessible_length(wall, R) for wall in range(len(shape.walls)))
    assert total == pytest.approx(border, rel=1e-8)


def test_the_border_belongs_to_its_walls():
    shape = enclosure(BOX, [Segment((5, 0), (5, 2))])
    lengths = [shape.accessible_length(wall, R) for wall in range(5)]
    assert lengths == pytest.approx([5, 5, 8, 9, 3 + math.pi / 2])
    reflex = enclosure(ELL)
    assert reflex.accessible_length(3, R) == pytest.approx(1.5 + math.pi / 4)
    assert reflex.accessible_length(2, R) == pytest.approx(1.5)


def test_displaced_walls():
    shape = enclosure(BOX, [Segment((5, 0), (5, 6))], (0.0, -2.0, 0.0, 0.0, 1.0))
    assert shape.area == 48
    assert shape.accessible_area(R) == pytest.approx((5 + 1) * 5)
    assert [part.area for part in components(shape, R)] == pytest.approx([25, 5])


def test_a_divider_makes_two_chambers_and_a_gap_joins_them():
    assert len(components(enclosure(BOX, [Segment((5, 0), (5, 6))]), 0.0)) == 2
    assert len(components(enclosure(BOX, [Segment((5, 0), (5, 5))]), 0.4)) == 1
    assert len(components(enclosure(BOX, [Segment((5, 0), (5, 5))]), 0.6)) == 2


def test_discs_inside_and_in_the_way():
    shape = enclosure(BOX, [Segment((5, 0), (5, 2)), Block(((1, 1), (2, 1), (2, 2), (1, 2)))])
    places = np.array([[5.5, 1], [5.4, 1], [1.5, 1.5], [0.5, 3], [0.4, 3], [5, 2.5], [5, 2.4]])
    assert shape.holds(places, R).tolist() == [True, False, False, True, False, True, False]
    assert shape.holds(np.array([[1.5, 1.5], [5, 1], [-1, 1]]), 0.0).tolist() == [False, True, False]


def test_open_walls_are_reached_by_centres():
    shape = enclosure(BOX).with_wall(1, open=True)
    assert shape.accessible_area(R) == pytest.approx(9.5 * 5)


@pytest.mark.parametrize(
    ("segments", "held"),
    [
        ([((5, 0), (5, 3))], (True, False)),
        ([((5, 0), (5, 6))], (True, True)),
        ([((5, 1), (5, 3)), ((2, 3), (8, 3))], (False, True)),
        ([((5, 1), (5, 3)), ((5, 3), (8, 3))], (False, False)),
        ([((5, 1), (5, 3)), ((5, 3), (5, 5))], (False, True)),
    ],
)
def test_ends_on_walls_need_no_corner(segments, held):
    from gasbox.geometry.anchors import anchored

    assert anchored(enclosure(BOX, [Segment(*ends) for ends in segments]), 0) == held
