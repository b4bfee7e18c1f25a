"""What a run says of its walls, of energy and of those that leave, in gases small enough to count by hand."""

from __future__ import annotations

import numpy as np
import pytest

import gasbox
from gasbox.observe import Balance
from gasbox.scenario import parse
from gasbox.state import SetGravity, SetWall

BOX = {"shape": "rectangle", "width": 10, "height": 4}
HIT = {"species": "a", "position": [2, 2], "velocity": [1, 0]}

pytestmark = pytest.mark.small


def gas(*particles: dict, **more) -> gasbox.Simulation:
    return gasbox.Simulation(
        parse(
            {
                "container": BOX,
                "species": [{"name": "a", "radius": 1, "mass": 1}],
                "particles": list(particles),
                "dynamics": {"kind": "event-driven"},
                "frame_interval": 0.5,
                **more,
            }
        )
    )


def wall(simulation: gasbox.Simulation, name: str) -> dict:
    (found,) = [entry for entry in simulation.summary()["walls"] if entry["name"] == name]
    return found


def test_a_plain_box_has_four_walls_without_work_or_heat():
    simulation = gas(HIT)
    simulation.advance(until=8.0)
    # Met the right wall at time 7, with its 2 of length.
    right = wall(simulation, "right")
    assert (right["collisions"], right["pressure"]) == (1, pytest.approx(2 / (8 * 2)))
    assert right["pressure_error"] == pytest.approx(2 / 16 * np.sqrt(4 / np.pi))
    assert (right["work"], right["heat"], right["carried"]) == (0.0, 0.0, 0.0)
    assert right["passed"] == {"a": {"forward": 0, "backward": 0}}
    assert wall(simulation, "left")["pressure"] == 0.0
    summary = simulation.summary()
    assert summary["internal_energy"] == summary["energy"] == 0.5
    assert summary["left"] == {"a": 0}


@pytest.mark.parametrize("looks", [1, 8])
def test_a_wall_that_comes_along_works_and_pressures_belong_to_the_mean_place(looks):
    simulation = gas(HIT, walls={"right": {"motion": {"kind": "constant", "speed": -1, "stop": 5}}})
    for number in range(looks):
        simulation.advance(until=4.0 * (number + 1) / looks)
    # At time 3.5 from 1 to -3: an impulse of 4, from a wall that came with 1.
    right = wall(simulation, "right")
    assert right["work"] == pytest.approx(4.0)
    assert right["pressure"] == pytest.approx(4 / (4 * 2))
    # On average the box was 8 long: 2 + 2 + 6 + 6 can be touched.
    assert simulation.pressure() == pytest.approx(4 / (4 * 16))
    assert simulation.summary()["pressure"] == simulation.pressure()
    assert simulation.mean_displacement.value().tolist() == pytest.approx([0, -2, 0, 0])


def test_who_leaves_is_counted_with_what_it_takes_along():
    stays = {"species": "a", "position": [6, 2], "velocity": [0, 0]}
    simulation = gas(HIT | {"velocity": [-2, 0]}, stays, walls={"left": {"open": True, "name": "door"}})
    simulation.advance(until=3.0)
    summary = simulation.summary()
    assert summary["left"] == {"a": 1}
    assert summary["particles"] == 1
    door = wall(simulation, "door")
    assert door["carried"] == pytest.approx(2.0)
    assert door["pressure"] is None
    assert sum(door["passed"]["a"].values()) == 1


def test_observers_learn_of_changes():
    simulation = gas(HIT, {"species": "a", "position": [6, 2.5], "velocity": [0, 0.25]})
    book = Balance(simulation.geometry, np.array([1.0]))
    simulation.attach(book)
    simulation.advance(frames=1)
    simulation.apply(SetGravity((0.0, -0.5)))
    simulation.advance(frames=6)
    simulation.apply(SetWall("bottom", temperature=2.0))
    simulation.advance(frames=30)
    series = book.series()
    # The heights were 2 and 2.625 when gravity set in.
    assert series.changes[[0, 2, -1]].tolist() == pytest.approx([0.0, 2.3125, 2.3125])
    assert series.heat[-1] != 0.0
    assert np.max(np.abs(series.residual)) < 1e-12
    assert simulation.summary()["potential_energy"] == pytest.approx(series.potential[-1])


def test_a_centre_of_mass_and_momentum_of_nobody():
    simulation = gas(HIT | {"velocity": [-1, 0]}, walls={"left": {"open": True}})
    simulation.advance(until=5.0)
    summary = simulation.summary()
    assert summary["particles"] == 0
    assert summary["temperature"] is None
    assert summary["species"][0]["center_of_mass"] is None
