"""Pressure on each wall, from tallies made by hand."""

import math

import numpy as np
import pytest
from hand_made import gas, hall, moved

from gasbox import observe
from gasbox.geometry import Circle, Passage, Path, Rectangle, Segment
from gasbox.state import Tallies

BOX = Rectangle(10.0, 20.0)
DIVIDER = Segment((4.0, 0.0), (4.0, 20.0))
ONE = np.array([1.0])

pytestmark = pytest.mark.small


def change(walls, species=1, **sums):
    tallies = Tallies.zero(species, walls)
    for name, value in sums.items():
        getattr(tallies, name)[...] = value
    return tallies


def test_each_wall_by_itself():
    tallies = change(4, wall_impulse=[[36.0], [18.0], [8.0], [0.0]])
    for geometry in (BOX, hall(BOX)):
        assert observe.wall_pressures(tallies, geometry, ONE, 2.0).tolist() == [1.0, 0.5, 0.5, 0.0]
    assert np.isnan(observe.wall_pressures(tallies, BOX, ONE, 0.0)).all()
    channel = observe.wall_pressures(tallies, Rectangle(10.0, 20.0, periodic_x=True), ONE, 2.0)
    assert np.isnan(channel[:2]).all()
    assert channel[2:].tolist() == [0.4, 0.0]


def test_species_are_added_with_the_length_that_each_can_reach():
    tallies = change(4, 2, wall_impulse=[[40.0, 32.0], [0, 0], [0, 0], [0, 0]])
    assert observe.wall_pressures(tallies, hall(BOX), np.array([0.0, 2.0]), 1.0)[0] == 40 / 20 + 32 / 16


def test_the_rim_of_a_circle():
    tallies = change(1, wall_impulse=[[9.0 * 2 * math.pi]])
    assert observe.wall_pressures(tallies, hall(Circle(10.0)), ONE, 2.0) == pytest.approx([0.5])
    assert observe.wall_pressure(tallies, hall(Circle(10.0)), ONE, 2.0) == pytest.approx(0.5)


def test_a_divider_has_two_faces():
    geometry = hall(BOX, DIVIDER)
    tallies = change(5, wall_impulse=[[0.0], [0.0], [0.0], [0.0], [72.0]])
    assert observe.wall_pressures(tallies, geometry, ONE, 1.0)[4] == pytest.approx(72 / (2 * 18))


@pytest.mark.parametrize("settings", [{"present": False}, {"passes": Passage()}, {"open": True}])
def test_what_nobody_bounces_off_is_no_gauge(settings):
    geometry = hall(BOX, DIVIDER, names=["gate"], gate=settings)
    tallies = change(5, wall_impulse=[[18.0], [18.0], [8.0], [8.0], [1e9]])
    assert np.isnan(observe.wall_pressures(tallies, geometry, ONE, 1.0)[4])
    whole = observe.wall_pressure(tallies, geometry, ONE, 1.0)
    assert whole == pytest.approx(1.0)


def test_a_membrane_is_a_gauge_for_those_that_it_holds_back():
    geometry = hall(BOX, DIVIDER, names=["membrane"], membrane={"passes": Passage(species=(0,))})
    tallies = change(5, 2, wall_impulse=[[0, 0], [0, 0], [0, 0], [0, 0], [0.0, 54.0]])
    radii = np.array([1.0, 1.0])
    lengths = observe.gauge_lengths(geometry, radii)
    assert lengths[4].tolist() == pytest.approx([0.0, 36.0])
    assert observe.wall_pressures(tallies, geometry, radii, 1.0)[4] == pytest.approx(1.5)


def test_a_gate_feels_a_force_but_is_no_gauge_of_the_gas():
    fast = Passage(species=(0,), least_speed=2.0)
    geometry = hall(BOX, DIVIDER, names=["gate"], gate={"passes": fast})
    tallies = change(5, wall_impulse=[[18.0], [18.0], [8.0], [8.0], [90.0]])
    assert observe.wall_pressures(tallies, geometry, ONE, 1.0)[4] == pytest.approx(2.5)
    # 52 over the 18 + 18 + 8 + 8 less what the divider takes of the bottom and top: twice its 2.
    length = observe.gauge_lengths(geometry, ONE)[:4].sum()
    assert observe.wall_pressure(tallies, geometry, ONE, 1.0) == pytest.approx(52 / length)


def test_errors_of_independent_hits():
    tallies = change(4, 2, wall_impulse=[[60.0, 48.0], [20.0, 0], [0, 0], [0, 0]])
    tallies.wall_collisions[0], tallies.wall_collisions[1] = [100, 25], [1, 0]
    errors = observe.wall_pressure_errors(tallies, hall(BOX), np.array([0.0, 2.0]), 1.0)
    assert errors[0] == pytest.approx(math.sqrt(4 / math.pi * (3.0**2 / 100 + 3.0**2 / 25)))
    assert errors[1] == pytest.approx(1.128, abs=5e-4)
    assert np.isnan(errors[2:]).all()


def test_a_wall_that_moves_is_measured_with_the_mean_length():
    geometry = hall(BOX, right={"motion": Path((0.0,), (0.0,), (-1.0,))})
    before, after = gas([[1.0, 0.0]]), gas([[1.0, 0.0]], time=2.0)
    moved(before, 0, 0, 0, 0)
    moved(after, 0, -4.0, 0, 0)
    tallies = change(4, wall_impulse=[[36.0], [36.0], [6.0], [6.0]])
    mid = observe.between(geometry, before.wall_displacement, after.wall_displacement)
    # The box is 8 wide on average.
    assert observe.wall_pressures(tallies, mid, ONE, 2.0).tolist() == pytest.approx([1.0, 1.0, 0.5, 0.5])
    assert observe.between(BOX, np.zeros(0), np.zeros(0)) == BOX


def test_mean_displacement_is_one_over_time():
    state = moved(gas([[0.0, 0.0]]), 0.0, 0.0)
    mean = observe.MeanDisplacement(state)
    assert mean.value().tolist() == [0.0, 0.0]
    for time, place in ((1.0, 2.0), (4.0, 2.0), (5.0, 0.0)):
        mean.see(moved(gas([[0.0, 0.0]], time=time), 0.0, place))
    assert mean.value().tolist() == [0.0, pytest.approx((1 + 6 + 1) / 5)]
    still = observe.MeanDisplacement(gas([[0.0, 0.0]]))
    still.see(gas([[0.0, 0.0]], time=1.0))
    assert still.value().size == 0


def test_rates_of_passing():
    tallies = change(5, 2)
    tallies.wall_passed[4] = [[6, 2], [0, 1]]
    assert observe.passage_rates(tallies, 2.0)[4].tolist() == [[3.0, 1.0], [0.0, 0.5]]
    assert observe.passage_rates(tallies, 0.0) is None


def gauge_of(pressures, radii=ONE, since=-np.inf):
    """A gauge that has seen these pressures on the left wall, one window of time 1 each."""
    gauge = observe.WallGauge(hall(BOX), radii, since)
    tallies = Tallies.zero(1, 4)
    gauge.start(gas([[0.0, 0.0]]), tallies)
    for number, pressure in enumerate(pressures, 1):
        tallies.wall_impulse[0, 0] += 18.0 * pressure
        tallies.wall_collisions[0, 0] += 100
        gauge.observe(gas([[0.0, 0.0]], time=float(number)), tallies)
    return gauge.series()


def test_a_gauge_keeps_each_window():
    series = gauge_of([1.0, 3.0, 2.0])
    assert series.names == ("left", "right", "bottom", "top")
    assert series.time.tolist() == [1.0, 2.0, 3.0]
    assert series.pressure[:, 0].tolist() == [1.0, 3.0, 2.0]
    assert series.mean.tolist() == pytest.approx([2.0, 0.0, 0.0, 0.0])
    # The scatter of three windows, 1/sqrt(3), is more than hits would make: 2 * 1.128/sqrt(300).
    assert series.error[0] == pytest.approx(1 / math.sqrt(3))
    late = gauge_of([1.0, 3.0, 2.0], since=1.0)
    assert late.mean[0] == pytest.approx(2.5)


def test_a_gauge_says_at_least_the_error_of_independent_hits():
    series = gauge_of([2.0, 2.0, 2.0])
    assert series.error[0] == pytest.approx(2 * math.sqrt(4 / math.pi / 300))
    nothing = gauge_of([])
    assert nothing.pressure.shape == (0, 4)
    assert np.isnan(nothing.mean).all()


def test_a_gauge_that_is_taken_away_keeps_what_it_has_seen():
    box = hall(BOX, DIVIDER, names=["divider"])
    gauge = observe.WallGauge(box, ONE)
    tallies = Tallies.zero(1, 5)
    gauge.start(gas([[0.0, 0.0]]), tallies)
    for number, push in enumerate([36.0, 72.0, 0.0, 0.0], 1):
        if number == 3:
            gauge.changed(gas([[0.0, 0.0]]), box.with_wall(4, present=False))
        tallies.wall_impulse[4, 0] += push
        gauge.observe(gas([[0.0, 0.0]], time=float(number)), tallies)
    series = gauge.series()
    assert series.pressure[:2, 4] == pytest.approx([1.0, 2.0])
    assert np.isnan(series.pressure[2:, 4]).all()
    assert series.mean[4] == pytest.approx(1.5)
    assert series.error[4] == pytest.approx(0.5)


def test_error_from_blocks():
    rng = np.random.default_rng(5)
    white = rng.normal(size=(4096, 3))
    # The largest of nine looks lies a little above; the scatter of the last is 18 %.
    assert observe.block_error(white) == pytest.approx(1 / 64, rel=0.5)
    # Each value held for 16 frames: only 256 independent ones.
    held = np.repeat(rng.normal(size=256), 16)
    assert observe.block_error(held) == pytest.approx(1 / 16, rel=0.5)
    assert observe.block_error(held) > 0.75 / 16
    assert np.isnan(observe.block_error(np.ones((1, 2)))).all()
    assert observe.block_error(np.array([1.0, 3.0])) == pytest.approx(1.0)
