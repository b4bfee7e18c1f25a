"""The book of energy and the indicator diagram, from states and tallies made by hand."""

import numpy as np
import pytest
from hand_made import gas, hall, moved

from gasbox import observe
from gasbox.geometry import Path, Rectangle
from gasbox.protocols import Observer
from gasbox.state import Tallies

BOX = Rectangle(10.0, 20.0)
HEAVY = hall(BOX, gravity=(0.0, -2.0), top={"open": True})
MASS = np.array([1.0, 3.0])

pytestmark = pytest.mark.small


def test_every_entry_of_the_book():
    book: Observer = observe.Balance(HEAVY, MASS)
    tallies = Tallies.zero(2, 4)
    tallies.wall_work[1, 0] = 99.0  # before this run
    one = gas([[1.0, 0.0], [0.0, 2.0]], mass=MASS, species=[0, 1], position=[[1.0, 5.0], [2.0, 1.0]])
    book.start(one, tallies)
    tallies.wall_work[1] += [1.0, 2.0]
    tallies.wall_heat[0, 1] -= 5.0
    tallies.rest_energy[0] += 0.25
    two = gas(
        [[2.0, 0.0], [0.0, 1.0]], mass=MASS, species=[0, 1], position=[[1.0, 4.0], [2.0, 3.0]], time=1.0
    )
    book.observe(two, tallies)
    series = book.series()
    assert series.kinetic.tolist() == [6.5, 3.5]
    assert series.potential.tolist() == [2 * (5 + 3), 2 * (4 + 9)]
    assert series.internal.tolist() == [22.5, 29.5]
    assert series.work.tolist() == [0.0, 3.0]
    assert series.heat.tolist() == [0.0, -5.0]
    assert series.rest.tolist() == [0.0, 0.25]
    assert series.wall_work[1].tolist() == [0.0, 3.0, 0.0, 0.0]
    assert series.wall_heat[1].tolist() == [-5.0, 0.0, 0.0, 0.0]
    assert series.residual.tolist() == [0.0, 7.0 - (3 - 5 + 0.25)]


def test_those_that_leave_take_their_height_along():
    book = observe.Balance(HEAVY, MASS)
    tallies = Tallies.zero(2, 4)
    both = gas([[1.0, 0.0], [0.0, 2.0]], mass=MASS, species=[0, 1], position=[[1.0, 5.0], [2.0, 20.0]])
    book.start(both, tallies)
    # The heavy one leaves at the top, where it has 3 * 2 * 20 of potential energy.
    tallies.wall_passed[3, 1, 0] += 1
    tallies.wall_carried[3, 1] += 6.0
    rest = gas([[1.0, 0.0]], mass=[1.0], species=[0], position=[[1.5, 5.0]], time=0.5)
    book.observe(rest, tallies)
    series = book.series()
    assert series.carried.tolist() == [0.0, 126.0]
    assert series.residual == pytest.approx([0.0, 0.0])


def test_tilting_gravity_is_paid_for():
    book = observe.Balance(HEAVY, MASS)
    tallies = Tallies.zero(2, 4)
    state = gas([[1.0, 0.0]], position=[[3.0, 5.0]])
    book.start(state, tallies)
    book.changed(state, hall(BOX, gravity=(-4.0, 0.0)))
    later = state.copy()
    later.time = 1.0
    book.observe(later, tallies)
    series = book.series()
    assert series.potential.tolist() == [10.0, 12.0]
    assert series.changes.tolist() == [0.0, 2.0]
    assert series.residual.tolist() == [0.0, 0.0]


def test_a_gas_with_forces_takes_heat_and_work_from_all_sides():
    torus = Rectangle(10.0, 20.0, True, True)
    book = observe.Balance(torus, MASS[:1])
    tallies = Tallies.zero(1, 4)
    tallies.thermostat_heat[0] = 50.0  # before this run
    state = gas([[1.0, 0.0], [-1.0, 0.0]])
    state.potential = -3.0
    book.start(state, tallies)
    tallies.thermostat_heat[0] -= 0.5
    tallies.heater_heat[0] += 2.0
    tallies.barostat_work[0] += 0.25
    later = gas([[1.5, 0.0], [-1.5, 0.0]], time=1.0)
    later.potential = -2.5
    book.observe(later, tallies)
    series = book.series()
    assert series.potential.tolist() == [-3.0, -2.5]
    assert series.thermostat.tolist() == [0.0, -0.5]
    assert series.heater.tolist() == [0.0, 2.0]
    assert series.barostat.tolist() == [0.0, 0.25]
    assert series.residual.tolist() == [0.0, 0.0]


def test_an_empty_book():
    series = observe.Balance(HEAVY, MASS).series()
    assert series.residual.shape == (0,)
    assert series.wall_work.shape == (0, 4)


def pushed(speed, wall, frames=4):
    """A diagram of a side that moves at a constant speed under a constant force of 3."""
    name = ("left", "right", "bottom", "top")[wall]
    geometry = hall(BOX, **{name: {"motion": Path((0.0,), (0.0,), (speed,))}})
    diagram: Observer = observe.Indicator(geometry, np.array([1.0]), wall)
    tallies = Tallies.zero(1, 4)
    for frame in range(frames):
        place = np.zeros(4)
        place[wall] = speed * frame
        state = moved(gas([[0.0, 0.0]], time=float(frame)), *place)
        if frame == 0:
            diagram.start(state, tallies)
        diagram.observe(state, tallies)
        tallies.wall_impulse[wall, 0] += 3.0
        # On the right and top the gas pushes outwards, and takes work from a wall that moves inwards.
        tallies.wall_work[wall, 0] += 3.0 * speed * (-1 if wall % 2 else 1)
    return diagram.series()


@pytest.mark.parametrize("wall", [0, 1, 2, 3])
@pytest.mark.parametrize("speed", [-0.5, 0.5])
def test_the_area_under_the_diagram_is_the_work(wall, speed):
    series = pushed(speed, wall)
    across = 20.0 if wall < 2 else 10.0
    outwards = speed if wall % 2 else -speed
    assert series.area == pytest.approx(200.0 + across * outwards * np.arange(4))
    assert series.displacement == pytest.approx(speed * np.arange(4))
    assert np.isnan(series.pressure[0])
    assert series.pressure[1:] == pytest.approx(3.0 / (across - 2))
    assert series.mid_area[1:] == pytest.approx(0.5 * (series.area[1:] + series.area[:-1]))
    assert series.work == pytest.approx(-3.0 * outwards * np.arange(4))
    assert series.integral == pytest.approx(series.work)
