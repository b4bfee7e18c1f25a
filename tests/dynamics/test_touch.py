"""When a disc meets an element, against positions sampled densely along its way."""

from __future__ import annotations

import math

import numpy as np
import pytest
from enclosures import ALL, BOX, enclosure

from gasbox.geometry import ElementKind, Path, Piston, Segment, Sinusoid
from gasbox.kernels.hall import hall, set_motion
from gasbox.kernels.hall.approach import BOUNCE, touch
from gasbox.kernels.hall.motion import displacement
from gasbox.kernels.hall.roots import first_fall, safe_step

SPAN = 12.0


def gap(place, table, e, position, radius, time):
    """Free distance between discs at positions (k, 2) at times (k,) and element e."""
    element = place.elements[e]
    moved = np.zeros(len(time))
    if place.walls[element.wall].motion is not None:
        moved[:] = [displacement(table, element.wall, t) for t in time]
    away = position - np.array(element.place) - moved[:, None] * np.array(element.normal)
    if element.kind is ElementKind.RIM:
        return element.radius - radius - np.hypot(*away.T)
    if element.kind is ElementKind.CORNER:
        return np.hypot(*away.T) - radius - element.radius
    foot = away @ np.array(element.tangent)
    height = away @ np.array(element.normal)
    beside = np.clip(foot, element.low, element.high) - foot
    # Beyond an end the corner, if there is one, is met instead; behind a container is no place to be.
    behind = element.faces * height < -radius
    return np.where((beside == 0.0) & ~behind, np.abs(height) - radius, np.inf)


def ways(place, seed, count):
    """Discs that start clear of everything, at the times at which they do."""
    rng = np.random.default_rng(seed)
    while count:
        at, radius = rng.random(2) * place.size, rng.uniform(0.1, 0.6)
        if place.holds(at[None], np.array([radius * 1.01]))[0]:
            count -= 1
            yield at, rng.normal(size=2), radius


@pytest.mark.parametrize("name", [name for name in ALL if "periodic" not in name and name != "slab"])
def test_the_first_meeting_is_found(name):
    """Sampled 6 000 times along the way: clear before the time that was found, and touching at it."""
    place = ALL[name]
    table = hall(place, 2, 1)
    for number, wall in enumerate(place.walls):
        if wall.motion is not None:
            set_motion(table.wall[number], table.rule[number], wall.motion, 0.0, 0.0)
    gravity = np.array(place.gravity)
    time = np.linspace(0.0, SPAN, 6_001)
    met = 0
    solid = [e for e, element in enumerate(place.elements) if place.walls[element.wall].passes is None]
    for at, velocity, radius in ways(place, 3, 20):
        disc = (*at, *velocity, 0.0, radius)
        times = {e: touch(table, e, disc, 0, 0.0, 0.0, SPAN) for e in solid}
        first = min(times, key=lambda e: times[e][0])
        found, what = times[first]
        position = at + velocity * time[:, None] + 0.5 * gravity * time[:, None] ** 2
        free = np.min([gap(place, table, e, position, radius, time) for e in solid], axis=0)
        assert free[time < found - 1e-9].min(initial=np.inf) > -1e-9
        if found <= SPAN:
            assert what == BOUNCE
            there = at + velocity * found + 0.5 * gravity * found**2
            assert gap(place, table, first, there[None], radius, [found])[0] == pytest.approx(0.0, abs=1e-9)
            met += 1
    assert met >= 12


@pytest.mark.small
def test_first_fall():
    assert first_fall(2.0, -1.0, 0.0, 1.0, 0.0) == 2.0
    assert first_fall(2.0, 1.0, 0.0, 1.0, 0.0) == math.inf
    assert first_fall(4.5, 0.0, -1.0, 1.0, 0.0) == 3.0
    assert first_fall(1.0, -1.0, 1.0, 1.0, 0.0) == math.inf  # turns round before it is there
    assert first_fall(0.0, 1.0, -1.0, 1.0, 0.0) == 2.0  # has just bounced
    assert first_fall(0.0, -1.0, 0.0, 1.0, 0.0) == 0.0
    assert first_fall(-0.5, -1.0, 0.0, 1.0, 0.0) == 0.0  # touches
    assert first_fall(-2.0, -1.0, 0.0, 1.0, 0.0) == math.inf  # is beyond
    assert first_fall(-2.0, 3.0, -1.0, 1.0, 0.0) == pytest.approx(
        3.0 + math.sqrt(5.0)
    )  # comes back from there
    assert first_fall(0.0, 0.0, -1.0, 1.0, 0.0) == 0.0  # rests


@pytest.mark.small
def test_a_safe_step_is_safe():
    rng = np.random.default_rng(0)
    for _ in range(200):
        f, slope, bound = rng.uniform(0, 2), rng.normal(), rng.uniform(0.1, 3)
        t = np.linspace(0.0, safe_step(f, slope, bound), 50)
        assert (f + slope * t - 0.5 * bound * t**2 > -1e-12).all()


@pytest.mark.small
@pytest.mark.parametrize(
    "motion", [Path((0.0,), (0.0,), (-0.3,)), Piston(2.0, 0.1, -0.3), Sinusoid(-0.5, 8.0)]
)
def test_a_wall_that_moves_is_met_where_it_is(motion):
    place = enclosure(BOX, right={"motion": motion})
    table = hall(place, 1, 1)
    set_motion(table.wall[1], table.rule[1], motion, 0.0, 0.0)
    time, _ = touch(table, 1, (10.0, 6.0, 1.0, 0.0, 0.0, 0.5), 0, 0.0, 0.0, 100.0)
    assert 10.0 + time + 0.5 == pytest.approx(16.0 + displacement(table, 1, time), abs=1e-12)


@pytest.mark.small
def test_both_faces_and_the_ends_of_a_segment():
    place = enclosure(BOX, (Segment((8.0, 3.0), (8.0, 9.0)),))
    table = hall(place, 1, 1)
    times = {}
    for e, element in enumerate(place.elements):
        if element.wall == 4:
            from_left = touch(table, e, (2.0, 6.0, 1.0, 0.0, 0.0, 0.5), 0, 0.0, 0.0, 100.0)[0]
            from_right = touch(table, e, (14.0, 6.0, -1.0, 0.0, 0.0, 0.5), 0, 0.0, 0.0, 100.0)[0]
            on_the_end = touch(table, e, (8.0, 1.0, 0.0, 1.0, 0.0, 0.5), 0, 0.0, 0.0, 100.0)[0]
            times[element.kind] = min(
                times.get(element.kind, (np.inf,) * 3), (from_left, from_right, on_the_end)
            )
    assert times[ElementKind.SIDE] == (5.5, 5.5, np.inf)
    assert times[ElementKind.CORNER][2] == 1.5
