"""A demon at its gate: who passes, what is counted, and that its runs can be repeated to the bit."""

import json

import numpy as np
import pytest
from run_bits import bits

from gasbox.errors import UsageError
from gasbox.geometry import Gate, Passage
from gasbox.recording import Recorder, open_recording
from gasbox.scenario import ScheduledChange, load, parse
from gasbox.simulation import Simulation, run
from gasbox.state import SetWorld
from gasbox.theory.demon import BIT

KINDS = ["event-driven", "stepped"]
CHANGES = [
    (4.1, SetWorld("rule", "species")),
    (9.0, SetWorld("species", "b")),
    (12.3, SetWorld("reversed", True)),
    (14.0, SetWorld("rule", "closed")),
    (15.0, SetWorld("threshold", 0.8)),
    (17.0, SetWorld("rule", "speed")),
]


def scenario(kind="event-driven", upwards=True, **world):
    ends = [[10, 4], [10, 10]]
    start, end = ends if upwards else ends[::-1]
    return parse(
        {
            "container": {"width": 20, "height": 14},
            "obstacles": [
                {"shape": "segment", "start": [10, 0], "end": [10, 4]},
                {"shape": "segment", "start": [10, 14], "end": [10, 10]},
                {"shape": "segment", "name": "gate", "start": start, "end": end},
            ],
            "species": [
                {"name": "a", "radius": 0.2, "count": 60, "temperature": 1},
                {"name": "b", "radius": 0.25, "mass": 2, "count": 40, "temperature": 1},
            ],
            "dynamics": {"kind": kind, **({"time_step": 0.0125} if kind == "stepped" else {})},
            "world": {"kind": "demon", "gate": "gate", **world},
            "frame_interval": 0.5,
            "seed": 3,
        }
    )


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("upwards", [True, False])
@pytest.mark.parametrize(
    ("rule", "right", "left"),
    [
        ("speed", Passage(least_speed=1.3), Passage(greatest_speed=1.3)),
        ("species", Passage((1,)), Passage((0,))),
        ("direction", Passage(), None),
        ("none", Passage(), Passage()),
        ("closed", None, None),
    ],
)
def test_who_passes(kind, upwards, rule, right, left):
    simulation = Simulation(scenario(kind, upwards, rule=rule, threshold=1.3, species="b"))
    ways = (right, left) if upwards else (left, right)
    assert simulation.geometry.walls[6].passes == Gate(*ways)
    simulation.advance(until=5.0)
    record = simulation.world.record
    passed = simulation.dynamics.tallies.wall_passed[6].sum(axis=0)
    assert record.passed.tolist() == (passed if upwards else passed[::-1]).tolist()
    assert record.refused.sum() == simulation.dynamics.tallies.wall_collisions[6].sum()
    decides = rule in ("speed", "species", "direction")
    assert record.decisions == decides * (record.passed.sum() + record.refused.sum())
    assert record.let == decides * record.passed.sum()
    assert record.passed.any() == (rule != "closed")
    assert record.refused.any() == (rule != "none")


def test_the_other_way_round():
    right, left = (Simulation(scenario(rule="direction", reversed=turned)) for turned in (False, True))
    for simulation in (right, left):
        simulation.advance(until=40.0)
    assert right.summary()["world"]["right"]["discs"] > 70
    assert left.summary()["world"]["left"]["discs"] > 70


@pytest.mark.parametrize("kind", KINDS)
def test_looking_changes_nothing(kind):
    one, other = (Simulation(scenario(kind)) for _ in range(2))
    one.advance(until=10.0)
    for time in [0.1, 0.25, 0.3, 1.0, 1.0, 7.3, 10.0]:
        other.advance(until=time)
    assert bits(one) == bits(other)


@pytest.mark.parametrize("kind", KINDS)
def test_what_was_asked_repeats_as_a_schedule_from_a_snapshot_and_from_a_recording(kind, tmp_path):
    live = Simulation(scenario(kind))
    for time, change in CHANGES:
        live.advance(until=time)
        live.apply(change)
    live.advance(until=24.0)
    again = Simulation(scenario(kind))
    again._plan = [ScheduledChange.of(*entry) for entry in CHANGES][::-1]
    with Recorder(tmp_path / "run.h5", again.scenario_in_use) as recorder:
        for frame in run(again, frames=48):
            recorder.write(frame, {}, again.changes)
            if frame.number == 25:  # the change at 12.3 is in force
                again.save(tmp_path / "now.json")
    assert bits(live) == bits(again)
    assert live.geometry == again.geometry
    kept = Simulation.restore(tmp_path / "now.json")
    with open_recording(tmp_path / "run.h5") as recording:
        recorded = Simulation(recording.scenario_at(25))
    for later in (kept, recorded):
        for time, change in CHANGES[3:]:
            later.advance(until=time)
            later.apply(change)
        later.advance(until=24.0)
        assert bits(later) == bits(live)


def test_what_cannot_be_set():
    simulation = Simulation(scenario())
    for change in [
        SetWorld("colour", 1.0),
        SetWorld("rule", "colour"),
        SetWorld("threshold", 0.0),
        SetWorld("species", "c"),
        SetWorld("species", 1.0),
        SetWorld("reversed", 1.0),
    ]:
        with pytest.raises(UsageError):
            simulation.apply(change)
    assert simulation.changes == []


def test_what_it_tells():
    simulation = Simulation(scenario())
    simulation.advance(until=10.0)
    view, books, series = simulation.world.view(), simulation.summary()["world"], simulation.world.series()
    json.dumps(view, allow_nan=False)
    speeds = np.sqrt((Simulation(scenario()).state.velocity ** 2).sum(axis=1))
    assert view["threshold"] == pytest.approx(np.median(speeds))
    assert view["sides"] == ["left", "right"]
    assert books["left"]["discs"] + books["right"]["discs"] == 100
    assert {column.shape for column in series.values()} == {(41,)}
    assert series["time"].tolist() == [0.25 * k for k in range(41)]
    assert series["entropy"][-1] == books["entropy_of_gas"]
    assert series["decisions"][-1] == books["decisions"] > 0
    np.testing.assert_allclose(series["balance"], series["entropy"] + BIT * series["decisions"], atol=1e-12)
    energy = (
        series["count_left"] * series["temperature_left"]
        + series["count_right"] * series["temperature_right"]
    )
    np.testing.assert_allclose(energy, simulation.energy(), rtol=1e-12)


def test_a_long_series_is_thinned(monkeypatch):
    monkeypatch.setattr("gasbox.worlds.demon._KEPT", 10)
    simulation = Simulation(scenario())
    simulation.advance(until=10.0)
    time = simulation.world.series()["time"]
    assert time[0] == 0.0
    assert 5 <= time.size <= 10
    assert np.unique(np.diff(time)).tolist() == [2.0]


def test_a_cold_side_makes_no_number_that_is_none():
    still = [{"species": "a", "position": [3, 3]}, {"species": "b", "position": [15, 5], "velocity": [1, 0]}]
    data = json.loads(scenario().to_json())
    for entry in data["species"]:
        entry |= {"count": 0, "temperature": None}
    simulation = Simulation(parse({**data, "particles": still}))
    simulation.advance(until=3.0)
    json.dumps(simulation.world.view(), allow_nan=False)
    assert simulation.summary()["world"]["left"]["temperature"] == 0.0


@pytest.mark.parametrize("name", ["maxwells-demon", "demon-sorting", "one-way-valve"])
def test_shipped_demons_win(name):
    simulation = Simulation(load(name))
    simulation.advance(until=60.0)
    assert simulation.summary()["world"]["entropy_of_gas"] < -4.0
