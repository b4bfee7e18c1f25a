"""Walls that move under forces: turned round in the frame of the wall, the work is in the books, bits are the same."""

from __future__ import annotations

import numpy as np
import pytest
from forced_gases import bits, rectangle, scenario
from gases import collect

from gasbox import DynamicsError, ScenarioError, Simulation, UsageError, load, observe
from gasbox.state import Contacts, MoveWall, SetWall

ATOM = {"name": "atom", "radius": 0.5, "count": 120, "temperature": 1.0}
WALLED = rectangle(24, 24, [])
SWING = {"left": {"motion": {"kind": "sinusoid", "amplitude": 1.5, "period": 6}}}
PATH = {"kind": "path", "points": [[0, 0], [3.001, 3], [6, -2], [9, 0]]}
PADDLE = {"name": "paddle", "shape": "segment", "start": [12, 6], "end": [12, 18], "motion": PATH}
POST = {"name": "post", "shape": "disc", "center": [8, 9], "radius": 2.5, "direction": [2, 1], "motion": PATH}
PRESS = {"kind": "constant", "speed": -0.5, "stop": 8}
PLACES = {
    "swinging side": {"container": WALLED, "walls": SWING},
    "paddle": {"container": WALLED, "obstacles": [PADDLE]},
    "divider in a channel": {
        "container": rectangle(24, 24, ["y"]),
        "obstacles": [{**PADDLE, "start": [12, 0], "end": [12, 24]}],
    },
    "post": {"container": WALLED, "obstacles": [POST]},
    "all at once": {
        "container": WALLED,
        "walls": {"right": {"motion": PRESS}, **SWING},
        "obstacles": [PADDLE],
        "gravity": [0.0, -0.1],
    },
}
every_place = pytest.mark.parametrize("place", PLACES.values(), ids=PLACES.keys())
every_wall = pytest.mark.parametrize("smooth", [False, True], ids=["reflecting", "repulsive"])


def make(place, smooth=False, time_step=0.004, species=(ATOM,), threads=1, **more):
    forces = {"walls": "repulsive" if smooth else "reflecting", "truncation": "force-shifted"}
    return Simulation(
        scenario(**place, species=species, forces=forces, time_step=time_step, **more), threads=threads
    )


def energy(simulation):
    return observe.internal_energy(simulation.state, simulation.geometry)


def unbooked(place, smooth, time_step):
    """Root mean square of the energy that no book explains, at 20 moments, and all work together."""
    simulation = make(place, smooth, time_step)
    before, found = energy(simulation), []
    for turn in range(20):
        simulation.advance(until=0.4 * (turn + 1))
        work = simulation.dynamics.tallies.wall_work.sum()
        found.append(energy(simulation) - before - work)
    return np.sqrt(np.mean(np.square(found))), np.abs(simulation.dynamics.tallies.wall_work).sum()


@every_place
@every_wall
def test_energy_is_work(place, smooth):
    error, work = unbooked(place, smooth, 0.004)
    assert work > 50.0
    assert error < 0.004 * work
    assert unbooked(place, smooth, 0.001)[0] < 0.3 * error


@pytest.mark.small
@pytest.mark.parametrize(("speed", "after"), [(0.5, -3.0), (-0.5, -1.0)])
def test_one_disc_meets_a_moving_side(speed, after):
    """v becomes 2u - v, and the work is u times the impulse; the place is exact, too."""
    motion = {"kind": "constant", "speed": -speed, "stop": 4}
    simulation = Simulation(
        scenario(
            rectangle(10.0, 4.0, []),
            [[5.0, 2.0]],
            [[2.0, 0.0]],
            walls={"right": {"motion": motion}},
            time_step=0.01,
        )
    )
    simulation.advance(until=4.0)
    assert simulation.state.velocity[0] == pytest.approx([after, 0.0], abs=1e-12)
    meeting = 4.5 / (2.0 + speed)
    place = 5.0 + 2.0 * meeting + after * (4.0 - meeting)
    assert simulation.state.position[0, 0] == pytest.approx(place, abs=1e-12)
    assert simulation.state.wall_displacement[1] == pytest.approx(-4.0 * speed, abs=1e-12)
    tallies = simulation.dynamics.tallies
    assert tallies.wall_impulse[1, 0] == pytest.approx(2.0 - after)
    assert tallies.wall_work[1, 0] == pytest.approx(-speed * (after - 2.0))


GO = {"kind": "constant", "speed": 1.0, "stop": 6}
MOVERS = {
    "side": {"walls": {"left": {"motion": GO}}},
    "segment": {"obstacles": [{"shape": "segment", "start": [1, 0], "end": [1, 4], "motion": GO}]},
    "end of a segment": {
        "obstacles": [{"shape": "segment", "start": [0.5, 0], "end": [0.5, 2.3], "motion": GO}]
    },
    "post": {
        "obstacles": [{"shape": "disc", "center": [1, 2.7], "radius": 0.7, "direction": [1, 0], "motion": GO}]
    },
}


@pytest.mark.small
@pytest.mark.parametrize("mover", MOVERS.values(), ids=MOVERS.keys())
def test_a_wall_finds_a_disc_at_rest(mover):
    """Only the wall moves, so that only its own way tells that lists are old; along the normal n it gives 2 u·n."""
    simulation = Simulation(scenario(rectangle(12.0, 4.0, []), [[5.0, 2.7]], time_step=0.02, **mover))
    simulation.advance(until=5.0)
    vx, vy = simulation.state.velocity[0]
    speed = np.hypot(vx, vy)
    assert speed == pytest.approx(2.0 * vx / speed, rel=0.01)
    assert vx > 0.6
    work = simulation.dynamics.tallies.wall_work.sum()
    assert work == pytest.approx(0.5 * speed**2)


def test_thermal_walls_that_move_give_work_and_heat():
    walls = {"left": {"motion": SWING["left"]["motion"], "temperature": 1.5}}
    simulation = make({"container": WALLED, "walls": walls}, time_step=0.002)
    before = energy(simulation)
    simulation.advance(until=8.0)
    tallies = simulation.dynamics.tallies
    work, heat = tallies.wall_work.sum(), tallies.wall_heat.sum()
    assert abs(heat) > 20.0
    assert energy(simulation) - before == pytest.approx(work + heat, abs=0.4)


@every_place
@every_wall
def test_nobody_gets_through(place, smooth):
    simulation = make(place, smooth, time_step=0.002)
    state = simulation.state
    for turn in range(20):
        simulation.advance(until=0.4 * (turn + 1))
        here = simulation.geometry.at(state.wall_displacement)
        assert here.holds(state.position, (0.4 if smooth else 1.0 - 1e-9) * state.radius).all()


@every_place
@every_wall
def test_the_same_bits_in_pieces_resumed_and_by_two(place, smooth, tmp_path):
    whole = make(place, smooth)
    whole.advance(until=4.0)
    pieces = make(place, smooth, threads=2)
    pieces.dynamics.contacts = Contacts.empty(3)
    for time in (0.1, 0.1, 1.2345, 2.0, 3.0, 3.0041, 4.0):
        collect(pieces.dynamics, pieces.state, time)
    assert bits(pieces) == bits(whole)
    resumed = make(place, smooth)
    for k, time in enumerate((0.0, 0.7777, 3.0, 3.0041)):
        resumed.advance(until=time)
        resumed.save(tmp_path / "snapshot.json")
        resumed = Simulation(load(tmp_path / "snapshot.json"), threads=1 + k % 2)
    resumed.advance(until=4.0)
    assert bits(resumed) == bits(whole)


def test_changes_in_a_run_and_on_a_schedule(tmp_path):
    """A side sent by hand, sent back on its way, a divider taken away and put back: repeated, and resumed."""
    gate = {"name": "gate", "shape": "segment", "start": [12, 0], "end": [12, 24]}
    place = {"container": WALLED, "obstacles": [gate]}
    entries = [
        (0.5, MoveWall("right", -4.0, 3.0)),
        (1.0, MoveWall("right", 0.0, 1.0)),
        (1.3, SetWall("gate", present=False)),
        (2.5, SetWall("gate", present=True)),
        (2.7, MoveWall("gate", 1.0, 0.5)),
    ]
    live = make(place)
    before = energy(live)
    for time, change in entries:
        live.advance(until=time)
        live.apply(change)
    live.advance(until=3.0)
    live.save(tmp_path / "snapshot.json")
    live.advance(until=4.0)
    assert live.state.wall_displacement[4] == pytest.approx(0.65, abs=1e-9)
    work = live.dynamics.tallies.wall_work.sum()
    assert energy(live) - before == pytest.approx(work, abs=0.01 * abs(work) + 0.1)
    schedule = [
        {"at": 0.5, "wall": "right", "displacement": -4.0, "speed": 3.0},
        {"at": 1.0, "wall": "right", "displacement": 0.0, "speed": 1.0},
        {"at": 1.3, "wall": "gate", "present": False},
        {"at": 2.5, "wall": "gate", "present": True},
        {"at": 2.7, "wall": "gate", "displacement": 1.0, "speed": 0.5},
    ]
    planned = make(place, schedule=schedule, threads=2)
    planned.advance(until=4.0)
    resumed = Simulation(load(tmp_path / "snapshot.json"))
    resumed.advance(until=4.0)
    assert bits(planned) == bits(live) == bits(resumed)


def test_a_side_that_moves_out_takes_the_gas_along():
    side = {"right": {"motion": {"kind": "constant", "speed": 4.0, "stop": 6}}}
    simulation = make({"container": WALLED, "walls": side})
    simulation.advance(until=60.0)
    assert simulation.state.wall_displacement[1] == pytest.approx(24.0)
    assert (simulation.state.position[:, 0] > 24.0).sum() > 30
    here = simulation.geometry.at(simulation.state.wall_displacement)
    assert here.holds(simulation.state.position, 0.5 - 1e-9).all()


def test_a_wall_that_is_too_fast_is_named():
    side = {"left": {"motion": {"kind": "constant", "speed": 200.0, "stop": 0.05}}}
    simulation = make({"container": WALLED, "walls": side}, species=[{**ATOM, "count": 0}])
    with pytest.raises(DynamicsError, match=r"a wall moved further than 0\.25 in one step of 0\.004"):
        simulation.advance(until=1.0)


def test_what_forces_have_no_answer_to():
    with pytest.raises(ScenarioError, match=r"moves freely.* not available under forces"):
        make({"container": WALLED, "walls": {"left": {"motion": {"kind": "piston", "mass": 50}}}})
    smooth = make({"container": WALLED, "obstacles": [{**PADDLE, "motion": None}]}, True)
    smooth.apply(SetWall("paddle", present=False))
    with pytest.raises(UsageError, match="push back smoothly cannot be open"):
        smooth.apply(SetWall("paddle", present=True))
    molecules = {
        "species": [],
        "molecules": [{"name": "water", "model": "water", "count": 3, "temperature": 1}],
    }
    with pytest.raises(ScenarioError, match="not available for molecules under forces"):
        make({"container": WALLED, "walls": SWING}, **molecules)
    resting = make({"container": WALLED}, **molecules)
    with pytest.raises(UsageError, match="molecules know no walls that move"):
        resting.apply(MoveWall("left", 1.0, 1.0))
    resting.advance(until=0.1)
