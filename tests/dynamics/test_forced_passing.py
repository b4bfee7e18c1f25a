"""Walls under forces that some pass, and open ones: who gets through, and that both books say the same."""

from __future__ import annotations

import numpy as np
import pytest
from forced_gases import bits, rectangle, scenario
from gases import collect

from gasbox import Simulation, load, observe
from gasbox.state import ContactKind, Contacts

LEFT = {"x": [0, 12]}
SMALL = {"name": "small", "radius": 0.3, "count": 90, "temperature": 1.0, "region": LEFT}
LARGE = {"name": "large", "radius": 0.5, "count": 60, "temperature": 1.0, "region": LEFT}
WALLED = rectangle(24, 24, [])
# Its normal points to the right.
LINE = {"name": "line", "shape": "segment", "start": [12, 0], "end": [12, 24]}


def make(passes, species=(SMALL, LARGE), threads=1, container=WALLED, line=LINE, **more):
    obstacles = [{**line, "passes": passes}]
    return Simulation(
        scenario(container, species=species, obstacles=obstacles, time_step=0.004, **more), threads=threads
    )


def passed(simulation):
    """(species, 2): forward and backward, through the line."""
    return simulation.dynamics.tallies.wall_passed[simulation.geometry.wall_names.index("line")]


def beyond(simulation, species):
    state = simulation.state
    return int((state.position[state.species == species, 0] > 12.0).sum())


def energy(simulation):
    return observe.internal_energy(simulation.state, simulation.geometry)


def test_a_membrane_keeps_one_species_in():
    simulation = make({"species": ["small"]})
    before, state = energy(simulation), simulation.state
    for turn in range(20):
        simulation.advance(until=2.0 * (turn + 1))
        large = state.species == 1
        assert (state.position[large, 0] <= 11.5 + 1e-9).all()
    assert beyond(simulation, 0) > 20
    forward, backward = passed(simulation)[0]
    assert backward > 20
    assert forward - backward == beyond(simulation, 0)
    assert not passed(simulation)[1].any()
    assert energy(simulation) == pytest.approx(before, abs=4e-3 * state.count)


@pytest.mark.parametrize(
    "motion", [None, {"kind": "sinusoid", "amplitude": 2, "period": 5}], ids=["rest", "moves"]
)
def test_a_gate_for_one_direction(motion):
    """Nobody ever comes back, though they linger in the line and are pushed there."""
    line = LINE if motion is None else {**LINE, "motion": motion}
    simulation = make({"direction": "forward"}, line=line)
    side, last = simulation.geometry.wall_names.index("line"), 0
    for turn in range(40):
        simulation.advance(until=0.75 * (turn + 1))
        state = simulation.state
        place = 12.0 + (state.wall_displacement[side] if motion else 0.0)
        through = int((state.position[:, 0] > place).sum())
        assert through >= last
        last = through
    assert last == passed(simulation)[:, 0].sum() > 100
    assert not passed(simulation)[:, 1].any()


def test_a_gate_for_the_fast():
    """Those who pass carry more than a fair share of the energy with them."""
    simulation = make({"least_speed": 2.0, "direction": "forward"}, container=WALLED)
    simulation.advance(until=6.0)
    speed = np.hypot(*simulation.state.velocity.T)
    there = simulation.state.position[:, 0] > 12.0
    assert 5 < there.sum() < 60
    assert (speed[there] ** 2).mean() > 1.5 * (speed[~there] ** 2).mean()


GATES = {
    "membrane": {"species": ["small"]},
    "fast": {"least_speed": 1.0},
    "ways": {"forward": {"species": ["small"]}, "backward": {"species": ["large"]}},
}


@pytest.mark.parametrize("passes", GATES.values(), ids=GATES.keys())
@pytest.mark.parametrize("moves", [False, True])
def test_crossings_in_both_books_and_the_same_bits(passes, moves, tmp_path):
    line = {**LINE, "motion": {"kind": "path", "points": [[0, 0], [2.001, 2], [4, -2]]}} if moves else LINE
    whole = make(passes, line=line)
    whole.advance(until=4.0)
    assert passed(whole).sum() > 5
    pieces = make(passes, threads=2, line=line)
    pieces.dynamics.contacts = Contacts.empty(3)
    rows = []
    for time in (0.1, 1.2345, 2.0, 3.3, 4.0):
        rows += collect(pieces.dynamics, pieces.state, time)
    assert bits(pieces) == bits(whole)
    crossings = [row for row in rows if row[0] == ContactKind.CROSSING]
    assert len(crossings) == passed(whole).sum()
    hits = [row for row in rows if row[0] == ContactKind.WALL]
    assert len(hits) == whole.dynamics.tallies.wall_collisions.sum()
    resumed = make(passes, line=line)
    for time in (0.7777, 2.0, 2.1):
        resumed.advance(until=time)
        resumed.save(tmp_path / "snapshot.json")
        resumed = Simulation(load(tmp_path / "snapshot.json"))
    resumed.advance(until=4.0)
    assert bits(resumed) == bits(whole)


def test_who_passes_is_not_pushed():
    """A line that all pass changes no bit of the motion."""
    free = Simulation(scenario(WALLED, species=(SMALL, LARGE), time_step=0.004))
    through = make({})
    for simulation in (free, through):
        simulation.advance(until=3.0)
    assert np.array_equal(free.state.position, through.state.position)
    assert passed(through).sum() > 10


def leaking(threads=1, law="wca", **more):
    more["forces"] = {"law": law}
    walls = {"right": {"open": True}}
    species = [{**SMALL, "region": None}, {**LARGE, "region": None}]
    return Simulation(
        scenario(WALLED, species=species, walls=walls, time_step=0.004, **more), threads=threads
    )


def test_discs_leave_through_an_open_side(tmp_path):
    whole = leaking(thermostat={"kind": "velocity-rescaling", "temperature": 1.0, "time": 0.5})
    count = whole.state.count
    whole.advance(until=12.0)
    gone = whole.dynamics.tallies.wall_passed[1]
    assert gone[:, 0].sum() == count - whole.state.count > 20
    assert not gone[:, 1].any()
    assert (whole.state.position[:, 0] < 24.0).all()
    assert whole.dynamics._bath.freedom == 2 * whole.state.count
    pieces = leaking(2, thermostat={"kind": "velocity-rescaling", "temperature": 1.0, "time": 0.5})
    pieces.dynamics.contacts = Contacts.empty(3)
    rows = [row for time in (1.0, 3.003, 12.0) for row in collect(pieces.dynamics, pieces.state, time)]
    assert bits(pieces) == bits(whole)
    assert len([row for row in rows if row[0] == ContactKind.CROSSING]) == gone.sum()
    resumed = leaking(thermostat={"kind": "velocity-rescaling", "temperature": 1.0, "time": 0.5})
    resumed.advance(until=3.003)
    resumed.save(tmp_path / "snapshot.json")
    resumed = Simulation(load(tmp_path / "snapshot.json"))
    resumed.advance(until=12.0)
    assert bits(resumed) == bits(whole)


def test_energy_that_leaves_is_booked():
    """Without forces between them it is all kinetic."""
    simulation = leaking(law="none")
    before = energy(simulation)
    simulation.advance(until=100.0)
    carried = simulation.dynamics.tallies.wall_carried[1].sum()
    assert before - energy(simulation) == pytest.approx(carried, rel=1e-12)
    assert simulation.state.count < 40


@pytest.mark.small
def test_the_last_one_leaves():
    simulation = Simulation(
        scenario(rectangle(5, 5, []), [[3.0, 2.0]], [[1.0, 0.0]], walls={"right": {"open": True}})
    )
    simulation.advance(until=3.0)
    assert simulation.state.count == 0
    assert simulation.state.potential == 0.0
    assert simulation.dynamics.tallies.wall_carried[1, 0] == pytest.approx(0.5)
    simulation.advance(until=4.0)
    assert simulation.time == pytest.approx(4.0)
