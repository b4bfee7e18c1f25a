"""Observers against the plain functions they stand on."""

import numpy as np
import pytest
from hand_made import gas, hall, moved

from gasbox import observe
from gasbox.geometry import Path, Rectangle
from gasbox.protocols import Observer
from gasbox.state import ContactKind, Contacts, Tallies

WALLS = Rectangle(10.0, 20.0)
TORUS = Rectangle(10.0, 20.0, periodic_x=True, periodic_y=True)
RADII = np.array([1.0, 2.0])

pytestmark = pytest.mark.small


def run_by_hand(observer):
    """Four frames of two particles; the tallies grow by known amounts."""
    tallies = Tallies.zero(2, 4)
    for frame in range(4):
        state = gas([[1.0 + frame, 0.0], [0.0, 2.0]], species=[0, 1], time=0.5 * frame)
        if frame == 0:
            observer.start(state, tallies)
        observer.observe(state, tallies)
        tallies.wall_impulse[1, 0] += 52.0 * (frame + 1)
        tallies.pair_virial[0] += 10.0
        tallies.pair_collisions[0, 1] += 1


def test_time_series():
    observer: Observer = observe.TimeSeries(WALLS, RADII)
    run_by_hand(observer)
    series = observer.series()
    assert series.time.tolist() == [0.0, 0.5, 1.0, 1.5]
    assert series.energy.tolist() == [2.5, 4.0, 6.5, 10.0]
    assert series.temperature.tolist() == [1.25, 2.0, 3.25, 5.0]
    assert series.species_temperature.tolist() == [[0.5, 2.0], [2.0, 2.0], [4.5, 2.0], [8.0, 2.0]]
    assert np.isnan(series.wall_pressure[0])
    assert series.wall_pressure[1:].tolist() == [2.0, 4.0, 6.0]
    area = observe.common_accessible_area(WALLS, RADII, np.array([1, 1]))
    np.testing.assert_allclose(series.virial_pressure[1:], (2 * series.temperature[1:] + 10.0) / area)


def test_pressure_over_a_window_of_frames():
    observer = observe.TimeSeries(WALLS, RADII)
    run_by_hand(observer)
    assert observer.series(window=2).wall_pressure[1:].tolist() == [2.0, 3.0, 5.0]
    assert observer.series(window=99).wall_pressure[1:].tolist() == [2.0, 3.0, 4.0]


def test_time_series_of_a_gas_that_loses_discs_behind_a_moving_wall():
    box = hall(WALLS, gravity=(0.0, -2.0), right={"motion": Path((0.0,), (0.0,), (1.0,))})
    observer = observe.TimeSeries(box, np.array([0.0]))
    tallies = Tallies.zero(1, 4)
    places = [0.0, 1.0, 4.0]
    for frame, place in enumerate(places):
        state = moved(gas(np.ones((3 - frame, 2)), time=float(frame)), 0, place, 0, 0)
        if frame == 0:
            observer.start(state, tallies)
        observer.observe(state, tallies)
        tallies.wall_impulse[0, 0] += 60.0
    series = observer.series()
    assert series.potential_energy.tolist() == [6.0, 4.0, 2.0]
    # Around a box that is 10.5 and then 12.5 wide.
    assert series.wall_pressure[1:].tolist() == pytest.approx([60 / 61, 60 / 65])
    # (Two discs, then one, of T = 1.)
    assert series.virial_pressure[1:].tolist() == pytest.approx([2 / 210, 1 / 250])
    # Over both windows: 10.5 and 12.5 in the mean.
    assert observer.series(window=2).wall_pressure[2] == pytest.approx(60 / 63)


def test_what_does_not_exist_is_not_a_number():
    observer = observe.TimeSeries(TORUS, np.array([1.0, 1.0]))
    assert observer.series().time.shape == (0,)
    one = gas([[1.0, 0.0]])
    observer.start(one, Tallies.zero(2, 4))
    series = observer.series()
    assert series.species_temperature.shape == (1, 2)
    assert np.isnan([series.temperature[0], series.wall_pressure[0], series.virial_pressure[0]]).all()


def test_starting_again_forgets():
    observer = observe.TimeSeries(WALLS, RADII)
    run_by_hand(observer)
    run_by_hand(observer)
    assert observer.series().time.tolist() == [0.0, 0.5, 1.0, 1.5]


def test_histogram_average():
    edges = [np.array([0.0, 1.5, 3.5]), np.array([0.0, 3.0])]
    observer: Observer = observe.HistogramAverage(edges)
    run_by_hand(observer)
    first, second = observer.histograms()
    assert observer.frames == 4
    assert first.counts.tolist() == [0.25, 0.5]
    assert first.overflow == 0.25
    assert first.total == second.total == 1.0
    assert second.counts.tolist() == [1.0]


def test_histogram_average_after_a_transient():
    observer = observe.HistogramAverage(
        [np.array([0.0, 2.5, 5.0]), np.array([0.0, 9.0])], "energy", since=1.0
    )
    assert observer.histograms()[0].total == 0.0
    run_by_hand(observer)
    assert observer.frames == 2
    assert observer.histograms()[0].counts.tolist() == [0.0, 0.5]


def contacts():
    """Five contacts of four particles, ids 3, 5, 7, 9, of species 0, 1, 0, 1."""
    buffer = Contacts.empty(8)
    rows = [
        (ContactKind.PAIR, 0.1, 3, 5),
        (ContactKind.PAIR, 0.2, 3, 7),
        (ContactKind.WALL, 0.3, 9, 2),
        (ContactKind.PAIR, 0.4, 5, 7),
        (ContactKind.WALL, 0.5, 3, 0),
    ]
    for i, (kind, time, first, second) in enumerate(rows):
        buffer.kind[i], buffer.time[i], buffer.first[i], buffer.second[i] = kind, time, first, second
        buffer.impulse[i] = [i, -i]
    buffer.count = len(rows)
    return buffer


def four():
    state = gas(np.ones((4, 2)), species=[0, 1, 0, 1])
    state.id = np.array([3, 5, 7, 9])
    return state


def test_contact_log_keeps_copies_in_order():
    observer: Observer = observe.ContactLog(limit=7)
    observer.start(four(), Tallies.zero(2, 4))
    buffer = contacts()
    observer.read(buffer)
    buffer.time[:] = 9.0
    observer.read(buffer)
    kept = observer.contacts()
    assert kept.count == 7
    assert kept.time.tolist() == [0.1, 0.2, 0.3, 0.4, 0.5, 9.0, 9.0]
    assert kept.first.tolist() == [3, 3, 9, 5, 3, 3, 3]
    assert observer.left_out == 3
    assert kept.impulse[4].tolist() == [4.0, -4.0]
    observer.start(four(), Tallies.zero(2, 4))
    assert observer.contacts().count == 0


def test_contact_counter():
    observer: Observer = observe.ContactCounter(species=2, walls=4)
    observer.start(four(), Tallies.zero(2, 4))
    observer.read(contacts())
    assert observer.rates() is None
    later = four()
    later.time = 2.0
    observer.observe(later, Tallies.zero(2, 4))
    rates = observer.rates()
    assert rates.per_pair.tolist() == [[0.5, 1.0], [0.0, 0.0]]
    assert rates.walls == 1.0
    assert rates.per_wall[2].tolist() == [0.0, 0.5]
    assert rates.per_wall[0].tolist() == [0.5, 0.0]
    assert observer.per_particle.tolist() == [2, 2, 2, 0]


def test_only_those_that_need_contacts_ask_for_them():
    assert observe.ContactLog.reads_contacts
    assert observe.ContactCounter.reads_contacts
    assert not observe.TimeSeries.reads_contacts
    assert not observe.HistogramAverage.reads_contacts
