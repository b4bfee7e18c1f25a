"""Changes of a running gas: by a schedule or by hand, whoever looks, in snapshots, and repeated to the bit."""

from __future__ import annotations

import numpy as np
import pytest

from gasbox.errors import UsageError
from gasbox.scenario import ScheduledChange, parse
from gasbox.simulation import Simulation
from gasbox.state import MoveWall, SetGravity, SetWall

KINDS = pytest.mark.parametrize("kind", ["event-driven", "stepped"])


def scenario(kind="event-driven", **more):
    dynamics = {"kind": kind, **({"time_step": 0.05} if kind == "stepped" else {})}
    return parse(
        {
            "format": "gasbox-scenario/1",
            "seed": 3,
            "container": {"shape": "rectangle", "width": 30, "height": 20},
            "species": [
                {"name": "small", "radius": 0.3, "count": 60, "temperature": 1.0, "region": {"x": [0, 14]}},
                {"name": "large", "mass": 4, "radius": 0.5, "count": 20, "temperature": 1.0},
            ],
            "dynamics": dynamics,
            "frame_interval": 0.5,
            **more,
        }
    )


def divided(kind="event-driven", **more):
    divider = {"shape": "segment", "name": "divider", "start": [15, 0], "end": [15, 20]}
    return scenario(kind, obstacles=[divider], **more)


def bits(simulation) -> tuple:
    state = simulation.state
    return state.time, state.id.tobytes(), state.position.tobytes(), state.velocity.tobytes()


def act(simulation) -> None:
    """Some changes at odd times."""
    simulation.advance(until=3.25)
    simulation.apply(SetGravity((0.0, -0.1)))
    simulation.advance(until=6.1)
    simulation.apply(MoveWall("right", -4.0, 0.5))
    simulation.advance(until=8.05)
    simulation.apply(SetWall("divider", present=False))
    simulation.advance(until=9.0)
    simulation.apply(SetWall("left", temperature=2.0))
    simulation.advance(until=12.0)
    simulation.apply(MoveWall("right", 1.0, 1.0))


@KINDS
def test_a_schedule_is_kept_whoever_looks(kind):
    plan = [{"at": 4.15, "wall": "divider", "present": False}, {"at": 7.0, "gravity": [0.0, -0.2]}]
    ends = []
    for pieces in (1, 3, 29):
        simulation = Simulation(divided(kind, schedule=plan))
        for time in np.linspace(0.0, 10.0, pieces + 1)[1:]:
            simulation.advance(until=time)
        assert len(simulation.changes) == 2
        ends.append(bits(simulation))
    assert len(set(ends)) == 1
    # Before the divider went nobody small was on the right, afterwards some are.
    assert (simulation.state.position[simulation.state.species == 0, 0] > 15).any()


@KINDS
def test_a_run_with_changes_is_repeated_by_a_schedule(kind):
    by_hand = Simulation(divided(kind))
    act(by_hand)
    by_hand.advance(until=20.0)
    log = [ScheduledChange.of(time, change) for time, change in by_hand.changes]
    assert len(log) == 5
    plan = [entry.model_dump(mode="json", exclude_none=True) for entry in log]
    again = Simulation(divided(kind, schedule=plan))
    again.advance(until=20.0)
    assert bits(again) == bits(by_hand)
    assert again.state.wall_displacement[1] == 1.0


@KINDS
def test_a_snapshot_goes_on_after_changes(kind, tmp_path):
    whole = Simulation(divided(kind))
    act(whole)
    whole.advance(until=13.5)
    whole.save(tmp_path / "half.json")
    whole.advance(until=20.0)
    resumed = Simulation.restore(tmp_path / "half.json")
    assert [change for _, change in resumed.changes] == [change for _, change in whole.changes]
    assert resumed.geometry.gravity == (0.0, -0.1)
    resumed.advance(until=20.0)
    assert bits(resumed) == bits(whole)
    assert resumed.state.wall_displacement.tobytes() == whole.state.wall_displacement.tobytes()


def test_a_snapshot_keeps_what_is_still_to_come(tmp_path):
    plan = [{"at": 2.0, "gravity": [0, -0.1]}, {"at": 8.0, "wall": "divider", "present": False}]
    whole = Simulation(divided(schedule=plan))
    whole.advance(until=5.0)
    whole.save(tmp_path / "half.json")
    whole.advance(until=12.0)
    resumed = Simulation.restore(tmp_path / "half.json")
    resumed.advance(until=12.0)
    assert len(resumed.changes) == 2
    assert bits(resumed) == bits(whole)


@KINDS
def test_who_has_left_keeps_the_numbers_of_the_others(kind, tmp_path):
    whole = Simulation(scenario(kind, walls={"right": {"open": True}}))
    whole.advance(until=14.0)
    assert 0 < whole.state.count < 80
    whole.save(tmp_path / "half.json")
    resumed = Simulation.restore(tmp_path / "half.json")
    assert resumed.state.id.tolist() == whole.state.id.tolist()
    for simulation in (whole, resumed):
        simulation.advance(until=25.0)
    assert bits(resumed) == bits(whole)


def test_a_plain_rectangle_takes_changes():
    simulation = Simulation(scenario())
    simulation.advance(until=1.0)
    simulation.apply(SetGravity((0.0, -1.0)))
    simulation.apply(MoveWall("top", -5.0, 1.0))
    simulation.advance(until=30.0)
    assert simulation.state.wall_displacement.tolist() == [0.0, 0.0, 0.0, -5.0]
    assert simulation.state.position[:, 1].max() < 15.0
    assert simulation.state.position[:, 1].mean() < 7.0


def test_a_piston_that_was_held_goes_free_again():
    lid = {"top": {"motion": {"kind": "piston", "mass": 20, "pressure": 0.5}}}
    simulation = Simulation(scenario(walls=lid))
    simulation.advance(until=2.0)
    simulation.apply(MoveWall("top", -3.0, 0.5))
    simulation.advance(until=20.0)
    assert simulation.state.wall_displacement[3] == -3.0
    simulation.apply(SetWall("top", free=True))
    simulation.advance(until=21.0)
    assert simulation.state.wall_displacement[3] not in (-3.0, 0.0)


def test_gravity_needs_a_floor():
    box = {"shape": "rectangle", "width": 30, "height": 20, "periodic": ["x"]}
    simulation = Simulation(scenario(container=box))
    with pytest.raises(UsageError, match="fall for ever"):
        simulation.apply(SetGravity((0.1, -1.0)))
    simulation.apply(SetGravity((0.0, -1.0)))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (SetWall("door", present=False), "no wall 'door'"),
        (SetWall("left", present=False), "cannot be taken away"),
        (SetWall("left", free=True), "no piston"),
        (MoveWall("post", 1.0, 1.0), "cannot move"),
        (MoveWall("door", 1.0, 1.0), "no wall 'door'"),
    ],
)
def test_changes_that_cannot_be_made(change, message):
    post = {"shape": "disc", "name": "post", "center": [20, 10], "radius": 2}
    simulation = Simulation(scenario(obstacles=[post]))
    before = bits(simulation)
    with pytest.raises(UsageError, match=message):
        simulation.apply(change)
    assert simulation.changes == []
    assert bits(simulation) == before
