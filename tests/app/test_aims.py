"""What the page says that a gas is held at, and real units."""

from __future__ import annotations

import pytest
from free_flight import FreeFlight
from surroundings import matter, sample, walled

from gasbox.app import real_units
from gasbox.app.aims import (
    Aim,
    Aims,
    aims_of,
    can_have_barostat,
    has_forces,
    power_unit,
    walls_come,
    walls_move,
)
from gasbox.scenario import Units
from gasbox.state import SetBarostat, SetGravity, SetHeating, SetThermostat

pytestmark = pytest.mark.small
ARGON = Units(name="argon", length=3.405e-10, energy=1.654e-21, mass=6.634e-26)


def test_aims_of_the_scenario_and_of_what_came_after() -> None:
    assert aims_of(matter(), ()) == Aims()
    held = matter(
        thermostat={"kind": "langevin", "temperature": 0.4},
        barostat={"pressure": 0.02},
        heating={"power": -0.001},
    )
    assert aims_of(held, ()) == Aims(Aim(0.4), Aim(0.02), -0.001)
    aims = aims_of(
        held,
        [
            (10.0, SetThermostat(0.8, 20.0)),
            (15.0, SetBarostat(None)),
            (16.0, SetGravity((0.0, 0.0))),
            (20.0, SetThermostat(0.2, 10.0)),
            (30.0, SetHeating(0.5)),
        ],
    )
    assert aims.temperature is not None
    assert [aims.temperature.at(time) for time in (20.0, 25.0, 99.0)] == pytest.approx([0.6, 0.4, 0.2])
    assert (aims.pressure, aims.power) == (None, 0.5)


def test_a_thermostat_without_a_temperature_keeps_that_of_the_start() -> None:
    assert aims_of(matter(thermostat={"kind": "velocity-rescaling"}), ()).temperature == Aim(1.0)


def test_an_aim_that_is_switched_on_begins_where_it_goes() -> None:
    aims = aims_of(matter(), [(5.0, SetThermostat(0.3, 10.0))])
    assert aims.temperature is not None
    assert aims.temperature.at(6.0) == 0.3


def test_where_a_barostat_is_possible() -> None:
    periodic, walls = matter(), matter(container={"shape": "rectangle", "width": 60, "height": 40})
    assert can_have_barostat(periodic, periodic.geometry())
    assert not can_have_barostat(walls, walls.geometry())
    hard = walled()
    assert not has_forces(hard)
    assert not can_have_barostat(hard, hard.geometry())


def test_where_walls_can_move_and_go() -> None:
    smooth = matter(forces={"walls": "repulsive"})
    water = {"name": "water", "model": "water", "count": 3, "temperature": 1}
    molecules = matter(molecules=[water])
    assert [walls_move(one) for one in (walled(), matter(), smooth, molecules)] == [True, True, True, False]
    assert [walls_come(one) for one in (walled(), matter(), smooth, molecules)] == [True, True, False, False]


def test_by_hand_the_energy_of_a_pair_takes_ten_seconds() -> None:
    assert power_unit(sample(FreeFlight(matter(frame_interval=0.05)))) == pytest.approx(1 / 30, rel=0.02)


def test_real_units() -> None:
    assert real_units.temperature(ARGON, 0.5) == "59.9 K"
    assert real_units.time(ARGON, 1.0) == "2.16 ps"
    assert real_units.pressure(ARGON, 0.02) == "285 µN/m"
    assert real_units.energy(ARGON, -3.0) == "\u22122.99 kJ/mol"
    assert real_units.density(ARGON, 0.8) == "6.90/nm²"
    assert real_units.pressure(ARGON, 0.0) == "0 N/m"
    for say in (real_units.temperature, real_units.time, real_units.pressure, real_units.energy):
        assert say(None, 1.0) == say(ARGON, None) == ""
