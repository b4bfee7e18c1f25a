"""Profiles and sides, counted by hand."""

import math

import numpy as np
import pytest
from hand_made import gas, hall, moved

from gasbox import observe
from gasbox.geometry import Block, Circle, Path, Rectangle, Segment
from gasbox.observe import Line
from gasbox.protocols import Observer
from gasbox.state import Tallies

BOX = Rectangle(10.0, 20.0)
NOTHING = Tallies.zero(2, 4)

pytestmark = pytest.mark.small


def test_area_of_strips_of_a_box():
    edges = np.array([0.0, 1.0, 5.0, 20.0])
    for geometry in (BOX, hall(BOX, gravity=(0.0, -1.0))):
        assert observe.strip_areas(geometry, 0.0, "y", edges) == pytest.approx([10.0, 40.0, 150.0])
        assert observe.strip_areas(geometry, 2.0, "y", edges) == pytest.approx([0.0, 18.0, 78.0])
        assert observe.strip_areas(geometry, 2.0, "x", np.array([0.0, 4.0, 10.0])) == pytest.approx(
            [32.0, 64.0]
        )
    channel = Rectangle(10.0, 20.0, periodic_x=True)
    assert observe.strip_areas(channel, 2.0, "y", edges) == pytest.approx([0.0, 30.0, 130.0])
    assert observe.strip_areas(BOX, 6.0, "y", edges).tolist() == [0.0, 0.0, 0.0]


def test_area_of_strips_along_an_angle():
    # Along the diagonal of a square of side 2 lie two triangles of area 2 each.
    square = Rectangle(2.0, 2.0)
    edges = np.array([0.0, 1.0, 2.0]) * math.sqrt(2)
    assert observe.strip_areas(square, 0.0, math.pi / 4, edges) == pytest.approx([2.0, 2.0])
    assert observe.strip_areas(square, 0.0, math.pi / 2, np.array([0.0, 0.5])) == pytest.approx([1.0])


def test_area_of_strips_round_corners():
    half = observe.strip_areas(hall(Circle(5.0)), 1.0, "x", np.array([0.0, 5.0, 10.0]))
    assert half == pytest.approx([8 * math.pi] * 2, rel=1e-4)
    block = Block(((0.0, 0.0), (10.0, 0.0), (10.0, 5.0), (0.0, 5.0)))
    assert observe.strip_areas(hall(BOX, block), 1.0, "y", np.array([0.0, 6.0, 10.0]))[1] == pytest.approx(
        8 * 4
    )


def frames(observer, *states):
    for number, state in enumerate(states):
        state.time = float(number)
        if number == 0:
            observer.start(state, NOTHING)
        observer.observe(state, NOTHING)
    return observer


def test_profiles_of_two_frames():
    observer: Observer = observe.ProfileAverage(BOX, np.array([0.0, 2.0]), "y", [0.0, 10.0, 20.0])
    one = gas(
        [[1.0, 0.0], [0.0, 2.0], [3.0, 0.0]],
        species=[0, 1, 0],
        mass=[2.0, 1.0, 2.0],
        position=[[1, 1], [5, 3], [5, 19]],
    )
    two = gas(
        [[1.0, 0.0], [0.0, 2.0], [3.0, 0.0]],
        species=[0, 1, 0],
        mass=[2, 1, 2],
        position=[[1, 1], [5, 3], [5, 9]],
    )
    result = frames(observer, one, two).profiles()
    assert result.frames == 2
    assert result.middles.tolist() == [5.0, 15.0]
    # Points: 1 and 2 below, 1 and 0 above, on areas of 100; the disc below on 6 * 8.
    assert result.density[0].mean == pytest.approx([0.015, 0.005])
    assert result.density[0].error == pytest.approx([0.005, 0.005])
    assert result.density[1].mean == pytest.approx([1 / 48, 0.0])
    assert result.density[1].error.tolist() == [0.0, 0.0]
    assert result.whole_density.mean == pytest.approx([0.015 + 1 / 48, 0.005])
    # Energies 1 and 9 of the points, 2 of the disc.
    assert result.temperature[0].mean == pytest.approx([(1 + 10) / 3, 9.0])
    assert result.temperature[1].mean[0] == 2.0
    assert np.isnan(result.temperature[1].mean[1])
    assert result.whole_temperature.mean == pytest.approx([(3 + 12) / 5, 9.0])
    # What the ratio leaves: 1 - 11/3 and 10 - 22/3 in the two frames, over a mean count of 1.5.
    assert result.temperature[0].error[0] == pytest.approx(8 / 3 / 1.5)


def test_an_early_frame_is_left_out_and_an_empty_average_is_none():
    observer = observe.ProfileAverage(BOX, np.array([0.0]), "y", [0.0, 10.0, 20.0], since=0.5)
    assert np.isnan(observer.profiles().density[0].mean).all()
    assert observer.profiles().frames == 0
    early, late = gas([[0.0, 0.0]], position=[[1, 1]]), gas([[0.0, 0.0]], position=[[1, 20]])
    result = frames(observer, early, late).profiles()
    # What lies on the last edge belongs to the last strip.
    assert result.density[0].mean.tolist() == [0.0, 0.01]


def test_a_strip_that_opens_is_normalised_by_its_mean_area():
    geometry = hall(BOX, right={"motion": Path((0.0,), (0.0,), (1.0,))})
    observer = observe.ProfileAverage(geometry, np.array([0.0]), "x", [0.0, 10.0, 14.0])
    states = [moved(gas([[0.0, 0.0]], position=[[12, 3]]), 0, way, 0, 0) for way in (0.0, 4.0)]
    result = frames(observer, *states).profiles()
    assert result.density[0].mean[1] == pytest.approx(1 / (0.5 * 80))


def test_heat_is_measured_without_the_drift():
    channel = Rectangle(10.0, 20.0, periodic_x=True)
    observer = observe.ProfileAverage(channel, np.array([0.0]), "y", [0.0, 20.0])
    result = frames(observer, gas([[5.0, 1.0], [5.0, -1.0]], position=[[1, 1], [2, 2]])).profiles()
    assert result.whole_temperature.mean.tolist() == [0.5]


def test_who_is_on_which_side():
    middle = Line.of_segment((5.0, 0.0), (5.0, 20.0))
    assert (middle.normal, middle.sides) == ((1.0, 0.0), ("left", "right"))
    state = gas(np.zeros((4, 2)), species=[0, 0, 1, 1], position=[[1, 1], [9, 1], [4.9, 15], [5, 3]])
    assert observe.side_counts(state, middle, 3).tolist() == [[1, 1], [1, 1], [0, 0]]
    back = Line.of_segment((5.0, 20.0), (5.0, 0.0))
    assert back.sides == ("right", "left")
    assert Line.of_segment((0.0, 5.0), (10.0, 5.0)).sides == ("above", "below")
    assert Line.of_segment((10.0, 5.0), (0.0, 5.0)).sides == ("below", "above")


def test_the_line_of_a_divider():
    geometry = hall(BOX, Segment((5.0, 0.0), (5.0, 20.0)), names=["divider"])
    line = Line.of_wall(geometry, "divider")
    assert line is not None
    assert line.point == (5.0, 0.0)
    assert Line.of_wall(geometry, "left") is None
    assert Line.of_wall(geometry, "none") is None
    assert Line.of_wall(BOX, "left") is None


def test_entropy_of_mixing():
    apart = np.array([[100, 0], [0, 300]])
    assert observe.mixing_entropy(apart) == 0.0
    greatest = -(100 * math.log(0.25) + 300 * math.log(0.75))
    assert observe.greatest_mixing_entropy(apart) == pytest.approx(greatest)
    assert observe.mixing(apart) == 0.0
    even = np.array([[20, 80], [60, 240]])
    assert observe.mixing_entropy(even) == pytest.approx(greatest)
    assert observe.mixing(even) == pytest.approx(1.0)
    # On the left 3 to 1, on the right 1 to 3.
    partly = np.array([[3, 1], [1, 3]])
    assert observe.mixing_entropy(partly) == pytest.approx(-2 * (3 * math.log(0.75) + math.log(0.25)))
    assert observe.mixing(np.array([[5, 3]])) is None
    assert observe.mixing(np.zeros((2, 2), int)) is None


def test_sides_over_time_follow_their_divider():
    line = Line.of_segment((5.0, 0.0), (5.0, 20.0))
    observer: Observer = observe.Sides(line, 2, wall=4)
    here = [[4.0, 1.0], [6.0, 1.0]]
    states = [
        moved(gas(np.zeros((2, 2)), species=[0, 1], position=here), 0, 0, 0, 0, way)
        for way in (0.0, 2.0, -2.0)
    ]
    series = frames(observer, *states).series()
    assert series.counts.tolist() == [[[1, 0], [0, 1]], [[1, 0], [1, 0]], [[0, 1], [0, 1]]]
    assert series.mixing == pytest.approx([0.0, 1.0, 1.0])
    assert series.entropy == pytest.approx([0.0, 2 * math.log(2), 2 * math.log(2)])
    assert observe.Sides(line, 2).series().counts.shape == (0, 2, 2)


def test_centres_of_mass_over_time_while_discs_leave():
    observer: Observer = observe.Centers(BOX, 3)
    one = gas(np.zeros((3, 2)), species=[0, 0, 1], mass=[1, 3, 2], position=[[0, 0], [4, 8], [5, 5]])
    two = gas(np.zeros((1, 2)), species=[1], mass=[2], position=[[6, 5]])
    series = frames(observer, one, two).series()
    assert series.whole.tolist() == [pytest.approx([22 / 6, 34 / 6]), [6.0, 5.0]]
    assert series.species[0, :2].tolist() == [[3.0, 6.0], [5.0, 5.0]]
    assert np.isnan(series.species[1, 0]).all()
    assert np.isnan(series.species[:, 2]).all()
