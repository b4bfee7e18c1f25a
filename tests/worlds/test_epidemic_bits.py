"""An epidemic goes through the same bits however it is looked at, stopped, resumed or repeated."""

import numpy as np
import pytest
from epidemic_towns import discs, town
from run_bits import bits

from gasbox.recording import Recorder, open_recording
from gasbox.scenario import ScheduledChange, parse
from gasbox.simulation import Simulation, run
from gasbox.state import SetWorld

SCENARIOS = {"town": town, "discs": discs}
both = pytest.mark.parametrize("make", SCENARIOS.values(), ids=SCENARIOS.keys())


@both
def test_looking_changes_nothing(make):
    one, other = Simulation(make()), Simulation(make())
    one.advance(until=12.0)
    for time in [0.3, 0.35, 1.0, 1.0, 4.75, 7.5, 12.0]:
        other.advance(until=time)
        other.world.view(), other.world.series(), other.world.summary()
    assert bits(one) == bits(other)
    assert one.world.summary()["final_size"] > 20


@both
def test_a_snapshot_goes_on_with_the_same_bits(make, tmp_path):
    whole = Simulation(make())
    whole.advance(until=4.0)
    whole.apply(SetWorld("hygiene", 0.5))
    # In the middle between two turns of the discs' world.
    whole.advance(until=6.1 if make is discs else 6.0)
    whole.save(tmp_path / "now.json")
    later = Simulation.restore(tmp_path / "now.json")
    assert bits(later) == bits(whole)
    for each in (whole, later):
        each.advance(until=10.0)
    assert bits(whole) == bits(later)
    assert whole.world.summary() == later.world.summary()
    assert whole.world.view() == later.world.view()


@both
def test_a_recorded_frame_goes_on_with_the_same_bits(make, tmp_path):
    simulation = Simulation(make(frame_interval=0.5))
    with Recorder(tmp_path / "run.h5", simulation.scenario_in_use) as recorder:
        for frame in run(simulation, frames=16):
            recorder.write(frame, {}, simulation.changes)
    with open_recording(tmp_path / "run.h5") as recording:
        middle = Simulation(recording.scenario_at(7))
    middle.advance(until=8.0)
    assert bits(middle) == bits(simulation)


def test_live_changes_repeat_as_a_schedule():
    live = Simulation(town())
    for time, name, value in [
        (1.0, "quarantine_probability", 1.0),
        (2.05, "distancing_trigger", 1.0),
        (2.05, "radius", 1.7),
        (4.0, "central_visits", 2.0),
        (5.0, "infectious_days", 1.0),
    ]:
        live.advance(until=time)
        live.apply(SetWorld(name, value))
    live.advance(until=9.0)
    plan = [ScheduledChange.of(*entry).model_dump(exclude_none=True) for entry in live.changes]
    again = Simulation(parse({**town().to_dict(), "schedule": plan}))
    again.advance(until=9.0)
    assert bits(live) == bits(again)
    plain = Simulation(town())
    plain.advance(until=9.0)
    assert not np.array_equal(plain.state.species, live.state.species)
